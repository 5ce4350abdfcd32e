#include "thick_line.h"

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

/* Three corners are enough: the fourth lies opposite to the second one. A
 * function of its own, for the sake of the stack. */
static PEL_WIDE bool corners_of(const struct pel_thick_line_shape *line,
                                struct pel_point v[3])
{
    struct pel_point corner[4];
    if (!pel_thick_line_corners(line, corner))
        return false;
    v[0] = corner[0];
    v[1] = corner[1];
    v[2] = corner[2];
    return true;
}

void pel_thick_line(const struct pel_surface *surface,
                    const struct pel_thick_line_shape *line,
                    const struct pel_paint *paint)
{
    struct pel_point v[3];
    bool legal = corners_of(line, v);
    PEL_ASSERT(legal);
    if (!legal)
        return;
    /* A parallelogram: two triangles, which share the diagonal. */
    pel_triangle(surface, v, paint);
    v[1].x = v[0].x + v[2].x - v[1].x;
    v[1].y = v[0].y + v[2].y - v[1].y;
    pel_triangle(surface, v, paint);
}
