#include "circle.h"

#include "disc_side.h"

/* The circle makes its rows itself. By way of disc.c, which keeps two middles
 * and a row for shapes that need them, a program of flat circles takes 196
 * bytes of code and 76 of stack more on a Cortex-M0+ (324 of stack: the budget
 * is 256), and on 64-bit CPUs a small circle 5 % longer. */

/* One side, as in disc.h, with its columns in the run and those that are
 * visible. */
struct side {
    int64_t d;
    int32_t u, columns, limit;
};

static PEL_NOINLINE void side_start(struct side *s, int64_t reach, int32_t u)
{
    s->d = (reach - pel_square(u)) >> 9;
    s->u = u;
    s->columns = 0;
}

/* The columns of the next row, and on to the row after it. */
static PEL_HOT int32_t side_next(struct side *s, int32_t v)
{
    pel_disc_side_settle(&s->d, &s->u, &s->columns, s->limit);
    s->d -= v + 128;
    return s->columns;
}

/* Around a corner or the centre of a pixel one side is the other's mirror
 * image, where neither is cut: a side has radius / 256 + 1 columns at most.
 * Around a centre, the column that has it counts to the right, in every row. */
static bool mirrored(const struct side *left, const struct side *right,
                     int32_t radius)
{
    return PEL_FAST_64BIT && (right->u == 0 || right->u == 128) &&
           pel_min(left->limit, right->limit) > radius >> 8;
}

void pel_circle(const struct pel_surface *surface, struct pel_point center,
                int32_t radius, const struct pel_paint *paint)
{
    bool legal = pel_point_legal(center) && pel_radius_legal(radius);
    PEL_ASSERT(legal);
    if (!legal || pel_rect_empty(&surface->clip))
        return;
    const struct pel_rect *clip = &surface->clip;
    struct pel_span span[PEL_BATCH_ROWS];
    struct pel_spans spans = {surface, span, 0, 0, 1};
    struct side left, right;
    spans.y = pel_max(pel_first_pixel(center.y - radius), clip->y0);
    int32_t end = pel_min(pel_pixel_of(center.y + radius + 128), clip->y1);
    int32_t v = pel_pixel_center(spans.y) - center.y;
    int64_t reach = pel_square(radius) - pel_square(v);
    int32_t split =
        pel_min(pel_max(pel_first_pixel(center.x), clip->x0), clip->x1);
    left.limit = split - clip->x0;
    right.limit = clip->x1 - split;
    side_start(&right, reach, pel_pixel_center(split) - center.x);
    side_start(&left, reach, center.x - pel_pixel_center(split - 1));
    const bool mirror = mirrored(&left, &right, radius);
    const int32_t middle = split + (right.u == 0);
    for (; spans.y < end; spans.y += spans.n) {
        spans.n = pel_min(end - spans.y, PEL_BATCH_ROWS);
        for (int32_t i = 0; i < spans.n; i++, v += 256) {
            int32_t columns = side_next(&left, v);
            span[i].x0 = split - columns;
            span[i].x1 =
                mirror ? middle + columns : split + side_next(&right, v);
        }
        paint->fill(paint, &spans);
    }
}
