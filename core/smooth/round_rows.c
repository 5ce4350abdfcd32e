#include "round_rows.h"

#include <string.h>

enum { WINDOW = PEL_SMOOTH_WINDOW };

void pel_smooth_rows_put(struct pel_smooth_rows *rows,
                         struct pel_smooth_row *row)
{
    rows->paint(&rows->smooth, row);
    row->y = rows->image_y - row->y;
    if (rows->twins && rows->image_y != 2 * row->y)
        rows->paint(&rows->smooth, row);
}

/* The coverage of a window of columns, into `to` and on by `step`, 1 or -1. The
 * first area. */
static PEL_NOINLINE uint32_t cross(const struct pel_smooth_strips *s,
                                   int32_t center,
                                   const struct pel_span *columns, uint8_t *to,
                                   int32_t step)
{
    uint16_t area[WINDOW];
    const int32_t n = pel_smooth_window(columns);
    pel_smooth_strips_areas(s, center, columns->x0, n, area);
    for (int32_t i = 0; i < n; i++, to += step)
        *to = pel_smooth_coverage(area[i]);
    return area[0];
}

/* What a row shows of a round: columns of the left side in the mirrored
 * picture, full ones, and those of the right side. */
struct parts {
    struct pel_span left, full, right;
    uint32_t height; /* 2^-15 px */
    bool shared;     /* the first column of the left side is that of the right
                        one, too */
    bool twins;      /* the left side mirrors the right one */
};

static bool is_same(const struct pel_span *a, const struct pel_span *b)
{
    return a->x0 == b->x0 && a->x1 == b->x1 && a->x1 - a->x0 <= WINDOW;
}

static void find_parts(const struct pel_smooth_rows *rows,
                       const struct pel_smooth_round *round, struct parts *p)
{
    const struct pel_smooth_strips *const s = &rows->strips;
    const struct pel_rect *const clip = &rows->smooth.surface.clip;
    const struct pel_span r = pel_smooth_strips_side(s, round->right);
    const struct pel_span l = pel_smooth_strips_side(s, -round->left);
    const struct pel_span full = {-l.x0, r.x0};
    p->height = pel_smooth_strips_height(s);
    p->left = pel_smooth_clipped(l, -clip->x1, -clip->x0);
    p->right = pel_smooth_clipped(r, clip->x0, clip->x1);
    p->full = pel_smooth_clipped(full, clip->x0, clip->x1);
    p->shared = full.x0 > full.x1 && p->left.x0 == l.x0;
    p->twins =
        rows->twin_columns && is_same(&p->left, &l) && is_same(&p->right, &r);
}

static void copy_twins(uint8_t *middle, int32_t n, int32_t shared)
{
    for (int32_t i = 0; i < n; i++)
        middle[-1 - i] = middle[shared + i];
}

/* A window of each side, which goes on from `middle`. */
static void cross_both(const struct pel_smooth_rows *rows,
                       const struct pel_smooth_round *round,
                       const struct parts *p, uint8_t *middle, int32_t shared)
{
    const struct pel_smooth_strips *const s = &rows->strips;
    uint32_t inner = 0, sum = 0;
    if (!p->twins && !pel_smooth_empty(&p->left))
        inner = cross(s, -round->left, &p->left, middle - 1 + shared, -1);
    if (!pel_smooth_empty(&p->right))
        sum = cross(s, round->right, &p->right, middle, 1);
    if (p->twins) {
        copy_twins(middle, pel_smooth_window(&p->left) - shared, shared);
        inner = sum;
    }
    if (shared)
        *middle = pel_smooth_coverage(inner + sum - p->height);
}

/* A window of each side and what is between them, which is taken away. */
static void paint_parts(struct pel_smooth_rows *rows,
                        const struct pel_smooth_round *round, struct parts *p)
{
    uint8_t *const middle = rows->coverage + WINDOW;
    const int32_t n = pel_smooth_window(&p->left);
    const int32_t k = pel_smooth_window(&p->right);
    const int32_t shared = p->shared && n > 0, left = n - shared;
    const int32_t full = pel_max(p->full.x1 - p->full.x0, 0);
    const int32_t x = n ? -p->left.x0 - n : full ? p->full.x0 : p->right.x0;
    struct pel_smooth_row row = {rows->rows.x0, x, left,
                                 full,          k, middle - left};
    cross_both(rows, round, p, middle, shared);
    pel_smooth_rows_put(rows, &row);
    p->left.x0 += n;
    p->full.x0 += full;
    p->right.x0 += k;
}

static void put_window(struct pel_smooth_rows *rows, int32_t x, int32_t n)
{
    struct pel_smooth_row row = {rows->rows.x0, x, n, 0, 0, rows->coverage};
    pel_smooth_rows_put(rows, &row);
}

/* Of a row that is not covered to its whole height. */
static void paint_even(struct pel_smooth_rows *rows, struct parts *p)
{
    for (int32_t n; (n = pel_smooth_window(&p->full)) > 0; p->full.x0 += n) {
        memset(rows->coverage, pel_smooth_coverage(p->height), (size_t)n);
        put_window(rows, p->full.x0, n);
    }
}

/* The rest, a window at a time. */
static void paint_left(struct pel_smooth_rows *rows, int32_t center,
                       struct pel_span *left)
{
    for (int32_t n; (n = pel_smooth_window(left)) > 0; left->x0 += n) {
        cross(&rows->strips, center, left, rows->coverage + n - 1, -1);
        put_window(rows, -left->x0 - n, n);
    }
}

static void paint_right(struct pel_smooth_rows *rows, int32_t center,
                        struct pel_span *right)
{
    for (int32_t n; (n = pel_smooth_window(right)) > 0; right->x0 += n) {
        cross(&rows->strips, center, right, rows->coverage, 1);
        put_window(rows, right->x0, n);
    }
}

/* Most rows: the same as below, in half the time. */
static void paint_whole(struct pel_smooth_rows *rows,
                        const struct pel_smooth_round *round)
{
    const struct pel_smooth_strip *const strip = rows->strips.strip;
    uint8_t *const middle = rows->coverage + WINDOW;
    const struct pel_span r =
        pel_smooth_whole_side(strip, round->right, middle, 1);
    const int32_t n = r.x1 - r.x0, sum = (round->left + round->right) >> 8;
    struct pel_span l = {r.x0 - sum, r.x1 - sum};
    if (rows->twin_columns)
        copy_twins(middle, n, 0);
    else
        l = pel_smooth_whole_side(strip, -round->left, middle - 1, -1);
    struct pel_smooth_row row = {rows->rows.x0, -l.x1, l.x1 - l.x0,
                                 r.x0 + l.x0,   n,     middle - (l.x1 - l.x0)};
    pel_smooth_rows_put(rows, &row);
}

void pel_smooth_rows_paint(struct pel_smooth_rows *rows,
                           const struct pel_smooth_round *round)
{
    struct parts p;
    if (rows->strips.n == 0)
        return;
    if (!PEL_SMALL_CODE && rows->inside && rows->strips.n == 1 &&
        pel_smooth_is_whole(rows->strips.strip, WINDOW)) {
        paint_whole(rows, round);
        return;
    }
    find_parts(rows, round, &p);
    if (p.height == 32768 || pel_smooth_empty(&p.full))
        paint_parts(rows, round, &p);
    paint_even(rows, &p);
    paint_left(rows, -round->left, &p.left);
    paint_right(rows, round->right, &p.right);
}

bool pel_smooth_rows_begin(struct pel_smooth_rows *rows,
                           const struct pel_surface *surface,
                           const struct pel_smooth_round *round,
                           const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    const int32_t top = pel_pixel_of(round->top - round->radius);
    const int32_t bottom = pel_pixel_of(round->bottom + round->radius + 255);
    const int32_t sum = round->top + round->bottom;
    struct pel_span *const seen = &rows->rows;
    rows->paint = pel_smooth_paint;
    seen->x0 = pel_max(top, clip->y0);
    seen->x1 = pel_min(bottom, clip->y1);
    rows->image_y = pel_pixel_of(sum) - 1;
    rows->twins = (sum & 255) == 0 && seen->x0 == top && seen->x1 == bottom;
    rows->inside = pel_pixel_of(round->left - round->radius) >= clip->x0 &&
                   pel_pixel_of(round->right + round->radius) < clip->x1;
    rows->twin_columns = ((round->left + round->right) & 255) == 0;
    if (rows->twins)
        seen->x1 = (rows->image_y >> 1) + 1;
    if (seen->x0 >= seen->x1 || clip->x0 >= clip->x1 ||
        pel_pixel_of(round->right + round->radius) < clip->x0 ||
        pel_pixel_of(round->left - round->radius) >= clip->x1 ||
        !pel_smooth_begin(&rows->smooth, surface, paint))
        return false;
    pel_smooth_strips_start(&rows->strips, round, seen->x0);
    return true;
}

void pel_smooth_round(const struct pel_surface *surface,
                      const struct pel_smooth_round *round,
                      const struct pel_paint *paint)
{
    struct pel_smooth_rows rows;
    if (!pel_smooth_rows_begin(&rows, surface, round, paint))
        return;
    for (; rows.rows.x0 < rows.rows.x1; rows.rows.x0++) {
        pel_smooth_strips_row(&rows.strips, round, rows.rows.x0);
        pel_smooth_rows_paint(&rows, round);
    }
}
