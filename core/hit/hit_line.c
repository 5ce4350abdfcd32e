#include "hit.h"

#include "hit_pixel.h"

/* True when b is b1 a / length rounded to the nearest, a tie up, and a is in 0
 * to length, which may be negative. |b1| <= |length| < 2^16. */
static bool on_line(int32_t a, int32_t b, int32_t length, int32_t b1)
{
    if (length < 0) {
        a = -a;
        length = -length;
    }
    if (a < 0 || a > length)
        return false;
    int64_t rest = (int64_t)2 * b1 * a + length - (int64_t)2 * length * b;
    return length ? rest >= 0 && rest < 2 * length : b == 0;
}

bool pel_hit_line(struct pel_point from, struct pel_point to, int32_t x,
                  int32_t y)
{
    struct pel_point p;
    if (!pel_hit_pixel(x, y, &p) || !pel_point_legal(from) ||
        !pel_point_legal(to))
        return false;
    int32_t x0 = pel_pixel_of(from.x), y0 = pel_pixel_of(from.y);
    int32_t dx = pel_pixel_of(to.x) - x0, dy = pel_pixel_of(to.y) - y0;
    x -= x0;
    y -= y0;
    if ((dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy))
        return on_line(x, y, dx, dy);
    return on_line(y, x, dy, dx);
}
