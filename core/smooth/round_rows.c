#include "round_rows.h"

#include <string.h>

enum { WINDOW = PEL_SMOOTH_WINDOW };

struct rows {
    struct pel_smooth smooth;
    struct pel_smooth_strips strips;
    int32_t image_y;   /* a row and its image add up to it */
    bool twins;        /* rows are painted with their images */
    bool twin_columns; /* the left side mirrors the right one, by columns */
    uint8_t coverage[2 * WINDOW];
};

static void paint_twins(struct rows *rows, struct pel_smooth_row *row)
{
    pel_smooth_paint(&rows->smooth, row);
    row->y = rows->image_y - row->y;
    if (rows->twins && rows->image_y != 2 * row->y)
        pel_smooth_paint(&rows->smooth, row);
}

static int32_t size_of(const struct pel_span *span)
{
    return pel_max(pel_min(span->x1 - span->x0, WINDOW), 0);
}

/* The coverage of a window of columns, into `to` and on by `step`, 1 or -1. The
 * first area. */
static PEL_NOINLINE uint32_t cross(const struct pel_smooth_strips *s,
                                   int32_t center,
                                   const struct pel_span *columns, uint8_t *to,
                                   int32_t step)
{
    uint16_t area[WINDOW];
    const int32_t n = size_of(columns);
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

static void find_parts(const struct rows *rows,
                       const struct pel_smooth_round *round, struct parts *p)
{
    const struct pel_rect *const clip = &rows->smooth.surface.clip;
    const struct pel_span r =
        pel_smooth_strips_side(&rows->strips, round->right);
    const struct pel_span l =
        pel_smooth_strips_side(&rows->strips, -round->left);
    p->height = pel_smooth_strips_height(&rows->strips);
    p->left.x0 = pel_max(l.x0, -clip->x1);
    p->left.x1 = pel_min(l.x1, -clip->x0);
    p->right.x0 = pel_max(r.x0, clip->x0);
    p->right.x1 = pel_min(r.x1, clip->x1);
    p->full.x0 = pel_max(-l.x0, clip->x0);
    p->full.x1 = pel_min(r.x0, clip->x1);
    p->shared = -1 - l.x0 == r.x0 && p->left.x0 == l.x0;
    p->twins = rows->twin_columns && size_of(&p->left) == l.x1 - l.x0 &&
               size_of(&p->right) == r.x1 - r.x0;
}

/* A window of each side and what is between them, which is taken away. */
static void paint_parts(struct rows *rows, const struct pel_smooth_round *round,
                        struct parts *p, int32_t y)
{
    uint8_t *const middle = rows->coverage + WINDOW;
    const int32_t n = size_of(&p->left), k = size_of(&p->right);
    const int32_t shared = p->shared && n > 0, left = n - shared;
    const int32_t full = pel_max(p->full.x1 - p->full.x0, 0);
    const int32_t x = n > 0 ? -p->left.x0 - n : full ? p->full.x0 : p->right.x0;
    struct pel_smooth_row row = {y, x, left, full, k, middle - left};
    uint32_t inner = 0;
    if (n && !p->twins)
        inner = cross(&rows->strips, -round->left, &p->left,
                      middle - 1 + shared, -1);
    if (k) {
        const uint32_t sum =
            cross(&rows->strips, round->right, &p->right, middle, 1);
        inner += p->twins ? 2 * sum : sum;
    }
    if (p->twins)
        for (int32_t i = 0; i < left; i++)
            middle[-1 - i] = middle[shared + i];
    if (shared)
        middle[0] = pel_smooth_coverage(inner - p->height);
    paint_twins(rows, &row);
    p->left.x0 += n;
    p->full.x0 += full;
    p->right.x0 += k;
}

static void paint_one(struct rows *rows, int32_t y, int32_t x, int32_t n)
{
    struct pel_smooth_row row = {y, x, n, 0, 0, rows->coverage};
    paint_twins(rows, &row);
}

/* The rest, a window at a time. */
static void paint_rest(struct rows *rows, const struct pel_smooth_round *round,
                       struct parts *p, int32_t y)
{
    for (int32_t n; (n = size_of(&p->full)) > 0; p->full.x0 += n) {
        memset(rows->coverage, pel_smooth_coverage(p->height), (size_t)n);
        paint_one(rows, y, p->full.x0, n);
    }
    for (int32_t n; (n = size_of(&p->left)) > 0; p->left.x0 += n) {
        cross(&rows->strips, -round->left, &p->left, rows->coverage + n - 1,
              -1);
        paint_one(rows, y, -p->left.x0 - n, n);
    }
    for (int32_t n; (n = size_of(&p->right)) > 0; p->right.x0 += n) {
        cross(&rows->strips, round->right, &p->right, rows->coverage, 1);
        paint_one(rows, y, p->right.x0, n);
    }
}

static void paint_row(struct rows *rows, const struct pel_smooth_round *round,
                      int32_t y)
{
    struct parts p;
    pel_smooth_strips_row(&rows->strips, round, y);
    if (rows->strips.n == 0)
        return;
    find_parts(rows, round, &p);
    if (p.height == 32768 || p.full.x0 >= p.full.x1)
        paint_parts(rows, round, &p, y);
    paint_rest(rows, round, &p, y);
}

void pel_smooth_round(const struct pel_surface *surface,
                      const struct pel_smooth_round *round,
                      const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    const int32_t top = pel_pixel_of(round->top - round->radius);
    const int32_t bottom = pel_pixel_of(round->bottom + round->radius + 255);
    const int32_t sum = round->top + round->bottom;
    int32_t y = pel_max(top, clip->y0), end = pel_min(bottom, clip->y1);
    struct rows rows;
    if (y >= end || clip->x0 >= clip->x1 ||
        !pel_smooth_begin(&rows.smooth, surface, paint))
        return;
    rows.image_y = pel_pixel_of(sum) - 1;
    rows.twins = (sum & 255) == 0 && y == top && end == bottom;
    rows.twin_columns = ((round->left + round->right) & 255) == 0;
    if (rows.twins)
        end = (rows.image_y >> 1) + 1;
    pel_smooth_strips_start(&rows.strips, round, y);
    for (; y < end; y++)
        paint_row(&rows, round, y);
}
