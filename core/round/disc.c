#include "disc.h"

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

static int64_t first_d(int64_t half_width2, int32_t u)
{
    return (half_width2 - pel_square(u)) >> 9;
}

void pel_disc_sides_start(struct pel_disc_sides *s, const int32_t center[2],
                          const struct pel_rect *clip, int64_t half_width2)
{
    const int32_t left = center[0], right = center[1];
    s->u[0] = first_left(left, split_at(left, clip));
    s->u[1] = first_right(right, split_at(right, clip));
    s->d[0] = first_d(half_width2, s->u[0]);
    s->d[1] = first_d(half_width2, s->u[1]);
}

/* The columns of a side in this row, at most `limit`, from `first` outwards. */
static PEL_INLINE_64 int32_t columns(int64_t *d, int32_t *u, int32_t first,
                                     int32_t limit)
{
    int32_t n = (*u - first) >> 8;
    pel_disc_side_adjust(d, u, &n, limit);
    return n;
}

void pel_disc_sides_row(struct pel_disc_sides *s, const int32_t center[2],
                        const struct pel_rect *clip, struct pel_span *span)
{
    const int32_t left = split_at(center[0], clip);
    const int32_t right = split_at(center[1], clip);
    span->x0 = left - columns(&s->d[0], &s->u[0], first_left(center[0], left),
                              left - clip->x0);
    span->x1 = right + columns(&s->d[1], &s->u[1],
                               first_right(center[1], right), clip->x1 - right);
}

/* All columns of a side have the same low 9 bits of u^2. */
void pel_disc_change(struct pel_disc *disc, int64_t from, int64_t to)
{
    struct pel_disc_sides *const s = &disc->sides;
    for (int k = 0; k < 2; k++) {
        const uint32_t low = (uint32_t)s->u[k] * (uint32_t)s->u[k] & 511;
        s->d[k] += ((to - low) >> 9) - ((from - low) >> 9);
    }
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
