/* Hit tests of all shapes, without a fill. */
#include "core/hit/hit.h"

static const struct pel_point v[3] = {PEL_AT(32, -5), PEL_AT(51, 60),
                                      PEL_AT(2, 20)};
static const struct pel_ring_shape ring = {PEL_AT(30, 30), PEL_PX(9),
                                           PEL_PX(40)};
static const struct pel_sector_shape sector = {PEL_AT(30, 30), PEL_PX(40), 7000,
                                               3000};
static const struct pel_arc_shape arc = {PEL_AT(30, 30), PEL_PX(9), PEL_PX(40),
                                         7000, 3000};
static const struct pel_ellipse_shape ellipse = {PEL_AT(30, 30),
                                                 PEL_AT(40, 25)};
static const struct pel_rounded_shape rounded = {PEL_AT(3, -5), PEL_AT(60, 50),
                                                 PEL_PX(12)};
static const struct pel_thick_line_shape thick = {PEL_AT(3, 5), PEL_AT(50, 60),
                                                  PEL_PX(6)};

int main(void)
{
    int hits = 0;
    for (int32_t y = -8; y < 70; y += 7)
        for (int32_t x = -8; x < 70; x += 7) {
            hits += pel_hit_triangle(v, x, y);
            hits += pel_hit_rectangle(v[0], v[1], x, y);
            hits += pel_hit_circle(v[2], PEL_PX(30), x, y);
            hits += pel_hit_line(v[0], v[1], x, y);
            hits += pel_hit_ring(&ring, x, y);
            hits += pel_hit_sector(&sector, x, y);
            hits += pel_hit_arc(&arc, x, y);
            hits += pel_hit_ellipse(&ellipse, x, y);
            hits += pel_hit_rounded_rectangle(&rounded, x, y);
            hits += pel_hit_thick_line(&thick, x, y);
        }
    return hits == 0;
}
