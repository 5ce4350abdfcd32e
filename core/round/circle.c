#include "circle.h"

#include "disc.h"

/* A flat circle by disc.c takes 196 bytes of code and 76 of stack more on a
 * Cortex-M0+ (324 of stack; the budget is 256), and a small one 5 % longer on
 * 64-bit CPUs. So this file has its own rows. */

/* One side (disc.h), `columns` wide in this row, at most `limit`. */
struct side {
    int64_t d;
    int32_t u, columns, limit;
};

static PEL_NOINLINE void side_start(struct side *s, int64_t half_width2,
                                    int32_t u)
{
    s->d = (half_width2 - pel_square(u)) >> 9;
    s->u = u;
    s->columns = 0;
}

/* Returns the columns of the row and moves on to the next. */
static PEL_INLINE_64 int32_t side_next(struct side *s, int32_t v)
{
    pel_disc_side_adjust(&s->d, &s->u, &s->columns, s->limit);
    s->d -= v + 128;
    return s->columns;
}

/* True when the right side is the mirror image of the left one: the centre is
 * on the left edge or the centre of a pixel, and the clip cuts neither side (at
 * most radius / 256 + 1 columns). The column of a pixel centre counts to the
 * right side, and is in every row. */
static bool mirrored(const struct side *left, const struct side *right,
                     int32_t radius)
{
    return PEL_64BIT && (right->u == 0 || right->u == 128) &&
           pel_min(left->limit, right->limit) > radius >> 8;
}

void pel_circle(const struct pel_surface *surface, struct pel_point center,
                int32_t radius, const struct pel_paint *paint)
{
    bool legal = pel_point_legal(center) && pel_radius_legal(radius);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&center, 1, radius));
    if (!legal)
        return;
    const struct pel_rect *clip = &surface->clip;
    const struct pel_rect visible =
        pel_rect_around(center, (struct pel_point){radius, radius}, clip);
    if (pel_rect_empty(&visible))
        return;
    const int32_t end = visible.y1;
    struct pel_span span[PEL_ROWS];
    struct pel_spans spans = {surface, span, visible.y0, 0, 1};
    struct side left, right;
    int32_t v = pel_pixel_center(spans.y) - center.y;
    int64_t half_width2 = pel_square(radius) - pel_square(v);
    int32_t split =
        pel_min(pel_max(pel_first_pixel(center.x), clip->x0), clip->x1);
    left.limit = split - clip->x0;
    right.limit = clip->x1 - split;
    side_start(&right, half_width2, pel_pixel_center(split) - center.x);
    side_start(&left, half_width2, center.x - pel_pixel_center(split - 1));
    const bool mirror = mirrored(&left, &right, radius);
    const int32_t middle = split + (right.u == 0);
    for (; spans.y < end; spans.y += spans.n) {
        spans.n = pel_min(end - spans.y, PEL_ROWS);
        for (int32_t i = 0; i < spans.n; i++, v += 256) {
            int32_t columns = side_next(&left, v);
            span[i].x0 = split - columns;
            span[i].x1 =
                mirror ? middle + columns : split + side_next(&right, v);
        }
        paint->fill(paint, &spans);
    }
}
