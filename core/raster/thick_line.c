#include "thick_line.h"

#include "collect.h"
#include "edge.h"
#include "triangle.h"

/* floor(sqrt(n)) for n < 2^62, a bit a turn. pel_square_root() is faster, but
 * with its table 300 bytes larger on a microcontroller; a line takes one
 * root. */
static int64_t root(uint64_t n)
{
    uint64_t r = 0;
    for (uint64_t bit = UINT64_C(1) << 60; bit; bit >>= 2) {
        const uint64_t more = r + bit;
        r >>= 1;
        if (n >= more) {
            n -= more;
            r += bit;
        }
    }
    return (int64_t)r;
}

/* A length of 2^30 <= size < 2^31 in units of 2^-shift sub-pixels. */
struct length {
    int64_t size;
    int shift;
};

static struct length length_of(int32_t dx, int32_t dy)
{
    struct length l = {0, 0};
    uint64_t square = (uint64_t)(pel_square(dx) + pel_square(dy));
    for (; square < UINT64_C(1) << 60; square <<= 2)
        l.shift++;
    l.size = root(square);
    return l;
}

/* round(v width / (2 l)), away from 0 at a tie. |v| is at most the length, so
 * the product is below 2^31 * 2^23. */
static int32_t across(int32_t v, int32_t width, const struct length *l)
{
    int64_t n = (int64_t)v * (INT64_C(1) << l->shift) * width;
    n = n < 0 ? n - l->size : n + l->size;
    return (int32_t)(n / (2 * l->size));
}

bool pel_thick_line_corners(const struct pel_thick_line_shape *line,
                            struct pel_point v[4])
{
    const struct pel_point a = line->from, b = line->to;
    if (!pel_point_legal(a) || !pel_point_legal(b) ||
        !pel_radius_legal(line->width))
        return false;
    const int32_t dx = b.x - a.x, dy = b.y - a.y;
    struct pel_point n = {0, 0};
    if (dx || dy) {
        const struct length length = length_of(dx, dy);
        n.x = across(-dy, line->width, &length);
        n.y = across(dx, line->width, &length);
    }
    v[0] = (struct pel_point){a.x + n.x, a.y + n.y};
    v[1] = (struct pel_point){b.x + n.x, b.y + n.y};
    v[2] = (struct pel_point){b.x - n.x, b.y - n.y};
    v[3] = (struct pel_point){a.x - n.x, a.y - n.y};
    return pel_points_legal(v, 4);
}

/* One side of the parallelogram, from its top corner past another one down to
 * its bottom corner. */
struct side {
    struct pel_edge edge;
    const struct pel_point *corner, *bottom;
    int32_t bend; /* the first row below the corner */
};

static void side_start(struct side *s, const struct pel_point *top, int32_t y)
{
    s->bend = pel_first_pixel(s->corner->y);
    if (y < s->bend)
        pel_edge_start(&s->edge, top, s->corner, y);
    else
        pel_edge_start(&s->edge, s->corner, s->bottom, y);
}

/* On to row y, which is above the bottom. */
static void side_next(struct side *s, int32_t y)
{
    if (y == s->bend)
        pel_edge_start(&s->edge, s->corner, s->bottom, y);
    else
        pel_edge_next(&s->edge);
}

/* A function of its own, so that its stack is free again when rows are painted.
 * The rows y to the result; none when it is not above y. */
static PEL_NOINLINE_32 int32_t start(struct side side[2],
                                     const struct pel_point v[4],
                                     const struct pel_rect *clip, int32_t *y)
{
    int top = 0;
    for (int i = 1; i < 4; i++)
        if (v[i].y < v[top].y)
            top = i;
    const struct pel_point *bottom = &v[(top + 2) & 3];
    const int32_t end = pel_min(pel_first_pixel(bottom->y), clip->y1);
    *y = pel_max(pel_first_pixel(v[top].y), clip->y0);
    for (int k = 0; k < 2 && *y < end; k++) {
        side[k].corner = &v[(top + 1 + 2 * k) & 3];
        side[k].bottom = bottom;
        side_start(&side[k], &v[top], *y);
    }
    return end;
}

/* Two triangles that share the diagonal: not from the top down, but quicker
 * where the paint has a function for triangles. */
static void draw_halves(const struct pel_surface *surface,
                        const struct pel_point v[4],
                        const struct pel_paint *paint)
{
    const struct pel_point other[3] = {v[2], v[3], v[0]};
    pel_triangle(surface, v, paint);
    pel_triangle(surface, other, paint);
}

void pel_thick_line(const struct pel_surface *surface,
                    const struct pel_thick_line_shape *line,
                    const struct pel_paint *paint)
{
    struct pel_point v[4];
    struct pel_collector c;
    struct side side[2];
    int32_t y;
    bool legal = pel_thick_line_corners(line, v);
    PEL_ASSERT(legal);
    if (!legal)
        return;
    if (PEL_FAST_FILLS && paint->fast) {
        draw_halves(surface, v, paint);
        return;
    }
    pel_collect_begin(&c, surface, paint);
    for (const int32_t end = start(side, v, &surface->clip, &y); y < end;) {
        const int32_t a = side[0].edge.x, b = side[1].edge.x;
        pel_collect_clipped(&c, y, pel_min(a, b), pel_max(a, b));
        if (++y < end) {
            side_next(&side[0], y);
            side_next(&side[1], y);
        }
    }
    pel_collect_end(&c);
}
