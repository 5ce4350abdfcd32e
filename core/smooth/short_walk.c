/* Rows of a walk: which pixels are painted next. */
#include "short_walk.h"

static int32_t clipped(const struct pel_smooth_short_walk *k, int32_t x)
{
    const struct pel_rect *const clip = &k->pixels.smooth.target->clip;
    return pel_max(clip->x0, pel_min(x, clip->x1));
}

/* The pixels of a row, whose left side crosses the span. */
static PEL_NOINLINE void set_row(struct pel_smooth_short_walk *k)
{
    const struct pel_span left = k->pixels.span, right = k->work.row.crossed;
    const int32_t x = clipped(k, pel_min(left.x0, right.x0));
    const int32_t end = clipped(k, pel_max(left.x1, right.x1));
    int32_t x0 = end, x1 = end;
    if (left.x1 <= right.x0) {
        x0 = clipped(k, left.x1);
        x1 = clipped(k, right.x0);
    }
    k->pixels.span.x1 = x;
    k->left = (uint16_t)(x0 - x);
    k->alike = (uint16_t)(x1 - x0);
    k->right = (uint16_t)(end - x1);
}

/* The columns that side i crosses; or the one that it begins in, and more
 * follow (note_piece). */
static PEL_NOINLINE void find_columns(struct pel_smooth_short_walk *k, int i)
{
    const struct pel_smooth_short_side *const s = &k->side[i];
    struct pel_span *const crossed = &k->work.row.crossed;
    const int32_t x = (int32_t)(s->at >> 32);
    int32_t below = x;
    k->height = 0;
    if (k->rows > 0)
        below = (int32_t)((s->at + s->step) >> 32);
    crossed->x0 = pel_min(x, below);
    crossed->x1 = pel_max(x, below) + 1;
}

/* Moves side i on to the next row. */
static void pass_row(struct pel_smooth_short_walk *k, int i)
{
    struct pel_smooth_short_side *const s = &k->side[i];
    if (k->rows > 0) {
        s->at += s->step;
    } else {
        pel_smooth_follow(k, i, 0);
        pel_smooth_copy_side(s, &k->work.row.side);
    }
}

/* False at the end. */
static PEL_NOINLINE bool next_row(struct pel_smooth_short_walk *k)
{
    for (int i = 0; i < 2; i++)
        pass_row(k, i);
    k->pixels.y++;
    if (k->rows > 0)
        k->rows--;
    if (k->rows == 0 && !pel_smooth_look_down(k))
        return false;
    for (int i = 0; i < 2; i++) {
        k->pixels.span = k->work.row.crossed;
        find_columns(k, i);
        if (k->rows == 0)
            pel_smooth_follow(k, i, 0);
    }
    set_row(k);
    return true;
}

/* Of pixels that are covered as high as the row is. */
static uint32_t area_between(const struct pel_smooth_short_walk *k)
{
    const uint32_t height = (uint8_t)(k->height - 1) + UINT32_C(1);
    return PEL_SMOOTH_HALF + height * (UINT32_C(255) << 16);
}

/* Adds the areas right of side i in n pixels, or takes them away. */
static PEL_ALWAYS_INLINE void add_side(struct pel_smooth_short_walk *k, int i,
                                       int32_t n)
{
    if (k->rows == 0) {
        pel_smooth_follow(k, i, n);
    } else {
        pel_smooth_set_whole(&k->side[i], &k->work.row.piece);
        pel_smooth_use_piece(k, i, n);
    }
}

/* The coverage of n pixels that side i alone crosses, of a whole row. */
static PEL_NOINLINE void cover_whole(struct pel_smooth_short_walk *k, int i,
                                     int32_t n)
{
    struct pel_smooth_piece p;
    const uint32_t flip = 0 - (uint32_t)i;
    const uint32_t outer = i ? area_between(k) : PEL_SMOOTH_HALF;
    int32_t x = k->pixels.span.x1;
    pel_smooth_set_whole(&k->side[i], &p);
    p.height = 65536;
    for (uint8_t *to = k->pixels.coverage; n > 0; n--, x++) {
        const uint32_t area = pel_smooth_area_in(&p, x);
        *to++ = (uint8_t)((outer + (area ^ flip) - flip) >> 24);
    }
}

static PEL_NOINLINE void set_areas(struct pel_smooth_short_walk *k,
                                   uint32_t area)
{
    for (int i = 0; i < PEL_SMOOTH_PIXELS; i++)
        k->work.row.area[i] = area;
}

static PEL_NOINLINE void read_areas(struct pel_smooth_short_walk *k)
{
    for (int i = 0; i < PEL_SMOOTH_PIXELS; i++)
        k->pixels.coverage[i] = (uint8_t)(k->work.row.area[i] >> 24);
}

/* The coverage of n pixels, left of those that are alike, or right of them. */
static PEL_NOINLINE void find_coverage(struct pel_smooth_short_walk *k,
                                       int32_t n)
{
    int i = k->left == 0;
    if (!PEL_SMALL_CODE && k->rows > 0 && (i || k->alike + k->right > 0)) {
        cover_whole(k, i, n);
        return;
    }
    set_areas(k, i ? area_between(k) : PEL_SMOOTH_HALF);
    do
        add_side(k, i, n);
    while (i++ == 0 && k->alike + k->right == 0);
    read_areas(k);
}

/* Of a part of the row the first pixels: how many are passed. */
static int32_t take(struct pel_smooth_short_walk *k, const uint16_t *part)
{
    if (part == &k->alike)
        return pel_smooth_take_alike(&k->pixels,
                                     (uint8_t)(area_between(k) >> 24), *part);
    const int32_t n = pel_min(*part, PEL_SMOOTH_PIXELS);
    find_coverage(k, n);
    return pel_smooth_take_pixels(&k->pixels, n);
}

bool pel_smooth_short_next(struct pel_smooth_short_walk *k)
{
    do {
        uint16_t *part = &k->left;
        pel_smooth_end_span(&k->pixels, &k->work.drawing);
        while (k->left + k->alike + k->right == 0)
            if (!next_row(k))
                return false;
        while (*part == 0)
            part++;
        const int32_t n = take(k, part);
        *part = (uint16_t)(*part - n);
    } while (!pel_smooth_begin_span(&k->pixels, &k->work.drawing));
    return true;
}
