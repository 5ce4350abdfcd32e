#include "exact_area.h"

/* Of the part of an edge that lies in the pixel's row, from (xa, ya) to (xb,
 * yb), pixels from its left top corner: the integral of the width right of it,
 * 0..1, which is linear between the sides of the pixel. Coordinates have 42
 * bits at most, divisions round once: 2^-40 in all. */
static long double area_in_row(long double xa, long double ya, long double xb,
                               long double yb)
{
    if (xa > xb) { /* mirrored in y: the same integral */
        const long double x = xa;
        xa = xb;
        xb = x;
    }
    const long double h = yb - ya;
    const long double l = xa < 0 ? 0 : xa > 1 ? 1 : xa;
    const long double r = xb < 0 ? 0 : xb > 1 ? 1 : xb;
    if (xb <= 0)
        return h;
    if (xa >= 1)
        return 0;
    if (xa == xb)
        return h * (1 - xa);
    const long double slope = h / (xb - xa);
    return (l - xa) * slope + (r - l) * slope * (1 - (l + r) / 2);
}

long double exact_area_right_of(const struct pel_point *a,
                                const struct pel_point *b, int32_t x, int32_t y)
{
    const long double sign = a->y < b->y ? 1 : -1;
    if (a->y > b->y) {
        const struct pel_point *const t = a;
        a = b;
        b = t;
    }
    const int32_t top = pel_max(a->y, 256 * y);
    const int32_t bottom = pel_min(b->y, 256 * y + 256);
    if (top >= bottom)
        return 0;
    const long double dx = b->x - a->x, dy = b->y - a->y;
    const long double at = (a->x - 256 * x) / 256.0L;
    return sign * area_in_row(at + dx * (top - a->y) / dy / 256,
                              (top - 256 * y) / 256.0L,
                              at + dx * (bottom - a->y) / dy / 256,
                              (bottom - 256 * y) / 256.0L);
}

long double exact_area(const struct pel_point *v, int32_t n, int32_t x,
                       int32_t y, int *edges)
{
    long double area = 0;
    *edges = 0;
    for (int32_t i = 0, k = n - 1; i < n; k = i++) {
        const long double left = exact_area_right_of(&v[k], &v[i], x - 1, y);
        const long double here = exact_area_right_of(&v[k], &v[i], x, y);
        area += here;
        *edges += here != 0 && here != left;
    }
    return area < 0 ? -area : area;
}
