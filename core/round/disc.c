#include "disc.h"

#include "disc_side.h"

/* The first pixel on the right side of a disc around x, or the edge of the clip
 * that is next to it: there the left side ends, and the right one begins. */
static int32_t split_at(int32_t x, const struct pel_rect *clip)
{
    return pel_min(pel_max(pel_first_pixel(x), clip->x0), clip->x1);
}

/* The distances of the first columns. */
static int32_t first_left(int32_t x, int32_t split)
{
    return x - pel_pixel_center(split - 1);
}

static int32_t first_right(int32_t x, int32_t split)
{
    return pel_pixel_center(split) - x;
}

void pel_disc_start(struct pel_disc *disc, const struct pel_rect *clip,
                    int64_t reach)
{
    struct pel_disc_side *l = &disc->left, *r = &disc->right;
    l->u = first_left(l->center, split_at(l->center, clip));
    r->u = first_right(r->center, split_at(r->center, clip));
    l->d = (reach - pel_square(l->u)) >> 9;
    r->d = (reach - pel_square(r->u)) >> 9;
}

/* How many of `limit` columns, the first at the distance `first`, the present
 * row has. */
static PEL_HOT int32_t columns(struct pel_disc_side *s, int32_t first,
                               int32_t limit)
{
    int32_t n = (s->u - first) >> 8;
    pel_disc_side_settle(&s->d, &s->u, &n, limit);
    return n;
}

void pel_disc_row(struct pel_disc *disc, const struct pel_rect *clip,
                  struct pel_span *span)
{
    struct pel_disc_side *l = &disc->left, *r = &disc->right;
    span->x0 = split_at(l->center, clip);
    span->x1 = split_at(r->center, clip);
    span->x0 -=
        columns(l, first_left(l->center, span->x0), span->x0 - clip->x0);
    span->x1 +=
        columns(r, first_right(r->center, span->x1), clip->x1 - span->x1);
}

/* The low 9 bits of u^2 are the same in all columns. */
static void change_side(struct pel_disc_side *s, int64_t from, int64_t to)
{
    const uint32_t low = (uint32_t)s->u * (uint32_t)s->u & 511;
    s->d += ((to - low) >> 9) - ((from - low) >> 9);
}

void pel_disc_change(struct pel_disc *disc, int64_t from, int64_t to)
{
    change_side(&disc->left, from, to);
    change_side(&disc->right, from, to);
}
