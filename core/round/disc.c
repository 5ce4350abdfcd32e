#include "disc.h"

#include "disc_side.h"

/* The first column of the right side of a disc around x, clamped to the clip;
 * the left side ends there. */
static int32_t split_at(int32_t x, const struct pel_rect *clip)
{
    return pel_min(pel_max(pel_first_pixel(x), clip->x0), clip->x1);
}

/* Distances of the first columns from x, 1/256 px. */
static int32_t first_left(int32_t x, int32_t split)
{
    return x - pel_pixel_center(split - 1);
}

static int32_t first_right(int32_t x, int32_t split)
{
    return pel_pixel_center(split) - x;
}

void pel_disc_start(struct pel_disc *disc, const struct pel_rect *clip,
                    int64_t half_width2)
{
    struct pel_disc_side *l = &disc->left, *r = &disc->right;
    l->u = first_left(l->center, split_at(l->center, clip));
    r->u = first_right(r->center, split_at(r->center, clip));
    l->d = (half_width2 - pel_square(l->u)) >> 9;
    r->d = (half_width2 - pel_square(r->u)) >> 9;
}

/* The columns of a side in this row, at most `limit`, from `first` outwards. */
static PEL_INLINE_64 int32_t columns(struct pel_disc_side *s, int32_t first,
                                     int32_t limit)
{
    int32_t n = (s->u - first) >> 8;
    pel_disc_side_adjust(&s->d, &s->u, &n, limit);
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

/* All columns of a side have the same low 9 bits of u^2. */
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

bool pel_disc_walk_box(struct pel_disc_walk *w, const struct pel_point *center,
                       int32_t radius, const struct pel_rect *clip)
{
    bool legal = pel_point_legal(*center) && pel_radius_legal(radius);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(center, 1, radius));
    if (!legal)
        return false;
    w->visible =
        pel_rect_around(*center, (struct pel_point){radius, radius}, clip);
    return !pel_rect_empty(&w->visible);
}

void pel_disc_walk_begin(struct pel_disc_walk *w,
                         const struct pel_point *center, int32_t radius)
{
    const int32_t v = pel_pixel_center(w->visible.y0) - center->y;
    pel_disc_center(&w->disc, center->x, center->x);
    pel_disc_start(&w->disc, &w->visible, pel_square(radius) - pel_square(v));
}
