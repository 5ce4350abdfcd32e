#include "reference.h"

#include <stdlib.h>

/* Twice the area of (a, b, p); positive when p lies right of a -> b, which in a
 * y-down picture is the inside of a clockwise outline. */
static wide side_of(const struct pel_point *a, const struct pel_point *b,
                    wide px, wide py)
{
    return ((wide)b->x - a->x) * (py - a->y) -
           ((wide)b->y - a->y) * (px - a->x);
}

static wide center_of(int32_t i)
{
    return (wide)i * 256 + 128;
}

static wide floor_of(wide n, wide d)
{
    wide q = n / d;
    return n % d < 0 ? q - 1 : q;
}

/* In a clockwise outline a top edge runs right, a left edge runs up. */
static bool is_top_left(const struct pel_point *a, const struct pel_point *b)
{
    return b->y < a->y || (b->y == a->y && b->x > a->x);
}

bool reference_triangle_at(const struct pel_point v[3], int32_t x, int32_t y)
{
    wide area = side_of(&v[0], &v[1], v[2].x, v[2].y);
    if (area == 0)
        return false;
    for (int i = 0; i < 3; i++) {
        const struct pel_point *a = &v[i], *b = &v[(i + 1) % 3];
        wide e = area > 0 ? side_of(a, b, center_of(x), center_of(y))
                          : side_of(b, a, center_of(x), center_of(y));
        bool owned = area > 0 ? is_top_left(a, b) : is_top_left(b, a);
        if (e < 0 || (e == 0 && !owned))
            return false;
    }
    return true;
}

bool reference_disc_at(struct pel_point center, int32_t radius, int32_t x,
                       int32_t y)
{
    wide dx = center_of(x) - center.x, dy = center_of(y) - center.y;
    return dx * dx + dy * dy <= (wide)radius * radius;
}

int32_t reference_winding_at(const struct pel_polygon_shape *outline, int32_t x,
                             int32_t y)
{
    wide px = center_of(x), py = center_of(y);
    int32_t winding = 0;
    for (int32_t i = 0; i < outline->n; i++) {
        const struct pel_point *a = &outline->v[i];
        const struct pel_point *b = &outline->v[(i + 1) % outline->n];
        if (a->y <= py && py < b->y && side_of(a, b, px, py) <= 0)
            winding--;
        else if (b->y <= py && py < a->y && side_of(b, a, px, py) <= 0)
            winding++;
    }
    return winding;
}

bool reference_polygon_at(const struct pel_polygon_shape *outline, int32_t x,
                          int32_t y)
{
    int32_t winding = reference_winding_at(outline, x, y);
    return outline->rule == PEL_EVEN_ODD ? winding % 2 != 0 : winding != 0;
}

/* start + floor(steps rise / run + 1/2). */
static wide rounded(wide start, wide steps, wide rise, wide run)
{
    if (run < 0) {
        run = -run;
        rise = -rise;
    }
    return start + floor_of(2 * steps * rise + run, 2 * run);
}

static bool between(int32_t v, int32_t a, int32_t b)
{
    return (a <= v && v <= b) || (b <= v && v <= a);
}

bool reference_line_at(struct pel_point from, struct pel_point to, int32_t x,
                       int32_t y)
{
    int32_t x0 = (int32_t)floor_of(from.x, 256);
    int32_t y0 = (int32_t)floor_of(from.y, 256);
    int32_t x1 = (int32_t)floor_of(to.x, 256),
            y1 = (int32_t)floor_of(to.y, 256);
    int32_t dx = x1 - x0, dy = y1 - y0;
    if (!between(x, x0, x1) || !between(y, y0, y1))
        return false;
    if (dx == 0 && dy == 0)
        return true;
    if (abs(dy) > abs(dx))
        return x == rounded(x0, (wide)y - y0, dx, dy);
    return y == rounded(y0, (wide)x - x0, dy, dx);
}

int32_t reference_edge_at(const struct pel_point *a, const struct pel_point *b,
                          int32_t y)
{
    wide dy = (wide)b->y - a->y, run = ((wide)b->x - a->x);
    wide n = ((wide)a->x - 128) * dy + run * (center_of(y) - a->y);
    if (dy < 0) {
        dy = -dy;
        n = -n;
    }
    return (int32_t)-floor_of(-n, 256 * dy);
}

struct fraction reference_channel_at(const struct pel_point v[3],
                                     const pel_color c[3], int channel,
                                     int32_t x, int32_t y)
{
    struct fraction f = {0, side_of(&v[0], &v[1], v[2].x, v[2].y)};
    for (int i = 0; i < 3; i++) {
        const struct pel_point *a = &v[(i + 1) % 3], *b = &v[(i + 2) % 3];
        f.n += side_of(a, b, center_of(x), center_of(y)) *
               (wide)(c[i] >> 8 * channel & 255);
    }
    if (f.d < 0) {
        f.n = -f.n;
        f.d = -f.d;
    }
    return f;
}
