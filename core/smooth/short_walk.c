/* Rows of a walk: which pixels are painted next. */
#include "short_walk.h"

static int32_t clipped(const struct pel_smooth_short_walk *k, int32_t x)
{
    const struct pel_rect *const clip = &k->smooth.target->clip;
    return pel_max(clip->x0, pel_min(x, clip->x1));
}

/* The pixels of a row, whose left side crosses the span. */
static PEL_NOINLINE void set_row(struct pel_smooth_short_walk *k)
{
    const struct pel_span left = k->span, right = k->work.row.crossed;
    const int32_t x = clipped(k, pel_min(left.x0, right.x0));
    const int32_t end = clipped(k, pel_max(left.x1, right.x1));
    int32_t x0 = end, x1 = end;
    if (left.x1 <= right.x0) {
        x0 = clipped(k, left.x1);
        x1 = clipped(k, right.x0);
    }
    k->x = x;
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
    if (k->rows > 0) {
        below = (int32_t)((s->at + s->step) >> 32);
        k->height = 256;
    }
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
    k->y++;
    if (k->rows > 0)
        k->rows--;
    if (k->y == k->end)
        return false;
    if (k->rows == 0)
        pel_smooth_look_down(k);
    for (int i = 0; i < 2; i++) {
        k->span = k->work.row.crossed;
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
    return PEL_SMOOTH_HALF + k->height * (UINT32_C(255) << 16);
}

/* Adds the areas right of side i in n pixels, or takes them away. */
static void add_side(struct pel_smooth_short_walk *k, int i, int32_t n)
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
    int32_t x = k->x;
    pel_smooth_set_whole(&k->side[i], &p);
    p.height = 65536;
    for (uint8_t *to = k->coverage; n > 0; n--, x++) {
        const uint32_t area = pel_smooth_area_in(&p, x);
        *to++ = (uint8_t)((outer + (area ^ flip) - flip) >> 24);
    }
}

/* The same of all kinds of pixels, left of those that are alike, or right. */
static PEL_NOINLINE void cover(struct pel_smooth_short_walk *k, bool left,
                               int32_t n)
{
    const uint32_t outer = left ? PEL_SMOOTH_HALF : area_between(k);
    uint32_t *const area = k->work.row.area;
    for (int32_t i = 0; i < n; i++)
        area[i] = outer;
    if (left)
        add_side(k, 0, n);
    if (!left || k->alike + k->right == 0)
        add_side(k, 1, n);
    for (int32_t i = 0; i < n; i++)
        k->coverage[i] = (uint8_t)(area[i] >> 24);
}

static void find_coverage(struct pel_smooth_short_walk *k, int32_t n)
{
    const bool left = k->left > 0;
    if (!PEL_SMALL_CODE && k->rows > 0 && (!left || k->alike + k->right > 0))
        cover_whole(k, left ? 0 : 1, n);
    else
        cover(k, left, n);
}

/* Takes from n pixels the first ones, those of coverage 255 or 0, or all up to
 * the last that is not 0: how many are done with. */
static PEL_NOINLINE int32_t take_pixels(struct pel_smooth_short_walk *k,
                                        int32_t n)
{
    const uint8_t first = k->coverage[0];
    int32_t end = 1;
    k->span.x0 = k->span.x1 = k->x;
    if (first == 0 || first == 255) {
        while (end < n && k->coverage[end] == first)
            end++;
        k->coverage[0] = 255;
        if (first)
            k->span.x1 += end;
        return end;
    }
    for (end = n; k->coverage[end - 1] == 0; end--)
        ;
    k->span.x1 += end;
    return n;
}

/* Of pixels that are crossed the first ones: how many are done with. */
static int32_t take_crossed(struct pel_smooth_short_walk *k, int32_t n)
{
    n = pel_min(n, PEL_SMOOTH_PIXELS);
    find_coverage(k, n);
    return take_pixels(k, n);
}

/* The same of those between the sides, but that empty ones are not painted. */
static PEL_NOINLINE int32_t take_alike(struct pel_smooth_short_walk *k,
                                       int32_t n)
{
    const uint8_t coverage = (uint8_t)(area_between(k) >> 24);
    k->span.x0 = k->span.x1 = k->x;
    if (coverage == 0)
        return n;
    if (coverage < 255)
        n = pel_min(n, PEL_SMOOTH_PIXELS);
    for (int i = 0; i < PEL_SMOOTH_PIXELS; i++)
        k->coverage[i] = coverage;
    k->span.x1 += n;
    return n;
}

/* False: the paint need not be asked. */
static PEL_NOINLINE bool begin_span(struct pel_smooth_short_walk *k)
{
    struct pel_smooth_drawing *const drawing = &k->work.drawing;
    if (k->span.x0 >= k->span.x1)
        return false;
    if (k->coverage[0] < 255)
        return pel_smooth_drawing_begin(drawing, &k->smooth, k->y, &k->span);
    pel_smooth_drawing_set(drawing, &k->smooth, k->y, &k->span);
    return true;
}

static void end_span(struct pel_smooth_short_walk *k)
{
    if (k->coverage[0] < 255)
        pel_smooth_drawing_end(&k->work.drawing, k->coverage);
    k->coverage[0] = 255;
}

bool pel_smooth_short_next(struct pel_smooth_short_walk *k)
{
    do {
        uint16_t *part = &k->left;
        end_span(k);
        while (k->left + k->alike + k->right == 0)
            if (!next_row(k))
                return false;
        while (*part == 0)
            part++;
        const int32_t n =
            part == &k->alike ? take_alike(k, *part) : take_crossed(k, *part);
        *part = (uint16_t)(*part - n);
        k->x += n;
    } while (!begin_span(k));
    return true;
}
