/* Hit tests of all shapes, without a fill. */
#include "draws.h"

int main(void)
{
    int hits = 0;
    for (int32_t y = -8; y < 70; y += 7)
        for (int32_t x = -8; x < 70; x += 7) {
            hits += pel_hit_triangle(star, x, y);
            hits += pel_hit_rectangle(star[0], star[1], x, y);
            hits += pel_hit_circle(star[2], PEL_PX(30), x, y);
            hits += pel_hit_line(star[0], star[1], x, y);
            hits += pel_hit_ring(&ring, x, y);
            hits += pel_hit_sector(&sector, x, y);
            hits += pel_hit_arc(&arc, x, y);
            hits += pel_hit_ellipse(&ellipse, x, y);
            hits += pel_hit_rounded_rectangle(&rounded, x, y);
            hits += pel_hit_thick_line(&thick, x, y);
        }
    return hits == 0;
}
