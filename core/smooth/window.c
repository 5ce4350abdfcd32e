#include "window.h"

#include <string.h>

void pel_smooth_window_begin(struct pel_smooth_window *w, int32_t y, int32_t x,
                             int32_t end)
{
    w->y = y;
    w->x = x;
    w->n = pel_min(end - x, PEL_SMOOTH_COLUMNS);
    w->used = 0;
    w->next = end;
    for (int32_t i = 0; i <= w->n; i++)
        w->sum[i] = 0;
}

bool pel_smooth_window_find(struct pel_smooth_window *w,
                            struct pel_smooth_crossing *c)
{
    const int32_t end = w->x + w->n,
                  growth = c->rising ? c->height : -c->height;
    const int32_t first = c->left ? -c->columns.x1 : c->columns.x0;
    const int32_t last = c->left ? -c->columns.x0 : c->columns.x1;
    if (last <= w->x)
        w->sum[0] += growth;
    if (last > end)
        w->next = pel_min(w->next, pel_max(first, end));
    c->columns.x0 = pel_max(c->columns.x0, c->left ? -end : w->x);
    c->columns.x1 = pel_min(c->columns.x1, c->left ? -w->x : end);
    return c->columns.x0 < c->columns.x1;
}

void pel_smooth_window_add(struct pel_smooth_window *w,
                           const struct pel_smooth_crossing *c,
                           const uint16_t *area)
{
    const int32_t first = c->left ? -c->columns.x1 : c->columns.x0;
    const int32_t n = c->columns.x1 - c->columns.x0, h = c->height;
    int32_t *sum = w->sum + (first - w->x), before = 0;
    w->used = pel_max(w->used, first - w->x + n);
    for (int32_t i = 0; i < n; i++) {
        const int32_t here = c->left ? area[n - 1 - i] : h - area[i];
        *sum++ += c->rising ? here - before : before - here;
        before = here;
    }
    *sum += c->rising ? h - before : before - h;
}

/* In 2^-15 px: a unit of rise's areas is 2^-24 / 255 px. */
static uint32_t area_of(uint32_t area)
{
    return ((area >> 16) * 257 + 256) >> 9;
}

/* What lies left of a piece in column i of those it crosses, b the last. */
static uint32_t line_area(const struct pel_smooth_line_piece *p, int32_t i,
                          int32_t b)
{
    const uint32_t base = (uint32_t)p->base << 8, h = (uint32_t)p->h >> 1;
    const uint32_t low = (base + p->low) & 0xFFFF;
    const uint32_t high = (base + p->high) & 0xFFFF;
    if (b == 0)
        return (low + high) / 2 * h >> 16;
    if (i == 0)
        return h - area_of(pel_smooth_corner(&p->rise, 65536 - low));
    if (i == b)
        return area_of(pel_smooth_corner(&p->rise, high));
    return h - area_of(pel_smooth_between(&p->rise, 65536 - low) +
                       (uint32_t)(i - 1) * p->rise.value);
}

void pel_smooth_window_line(struct pel_smooth_window *w,
                            const struct pel_smooth_line_piece *p, bool rising)
{
    uint16_t area[PEL_SMOOTH_COLUMNS];
    const int32_t a = pel_pixel_of(p->base);
    const int32_t b = pel_pixel_of(p->base + (int32_t)(p->high >> 8));
    struct pel_smooth_crossing c = {{a, b + 1}, p->h >> 1, false, rising};
    if (!pel_smooth_window_find(w, &c))
        return;
    for (int32_t x = c.columns.x0; x < c.columns.x1; x++)
        area[x - c.columns.x0] = (uint16_t)line_area(p, x - a, b - a);
    pel_smooth_window_add(w, &c, area);
}

void pel_smooth_window_strip(struct pel_smooth_window *w,
                             struct pel_smooth_strip *s, int32_t center,
                             bool left, bool rising)
{
    uint16_t area[PEL_SMOOTH_COLUMNS];
    struct pel_smooth_crossing c = {{pel_smooth_column(center, s->at_far),
                                     pel_smooth_column(center, s->at_near) + 1},
                                    pel_smooth_height(s),
                                    left,
                                    rising};
    if (!pel_smooth_window_find(w, &c))
        return;
    pel_smooth_strip_set(s);
    pel_smooth_strip_areas(s, center, c.columns.x0, c.columns.x1 - c.columns.x0,
                           area);
    pel_smooth_window_add(w, &c, area);
}

/* Where ends meet a sum may be more than a pixel. */
static uint8_t coverage_of(int32_t sum)
{
    return pel_smooth_coverage((uint32_t)pel_min(sum, 32768));
}

/* Pixels of one coverage. */
static void paint_run(struct pel_smooth *smooth, int32_t y, struct pel_span run,
                      uint8_t coverage)
{
    uint8_t bytes[PEL_SMOOTH_COLUMNS];
    struct pel_smooth_row row = {y, run.x0, 0, 0, 0, bytes};
    for (; row.x < run.x1 && coverage; row.x += row.left + row.full) {
        const int32_t n = run.x1 - row.x;
        row.full = coverage == 255 ? n : 0;
        row.left = row.full ? 0 : pel_min(n, PEL_SMOOTH_COLUMNS);
        memset(bytes, coverage, (size_t)row.left);
        pel_smooth_paint(smooth, &row);
    }
}

/* Another pixel of a row, which begins with the first that has a part of the
 * shape. */
static void add_pixel(struct pel_smooth_row *row, uint8_t *bytes,
                      uint8_t coverage)
{
    const bool full = coverage == 255 && row->right == 0;
    if (coverage == 0 && row->left + row->full == 0) {
        row->x++;
        return;
    }
    if (!full)
        bytes[row->left + row->right] = coverage;
    *(full ? &row->full : row->full ? &row->right : &row->left) += 1;
}

/* Takes pixels of coverage 0 from its end. */
static void trim(struct pel_smooth_row *row)
{
    int32_t *const n = row->full ? &row->right : &row->left;
    while (*n > 0 && row->coverage[row->left + row->right - 1] == 0)
        --*n;
}

void pel_smooth_window_paint(const struct pel_smooth_window *w,
                             struct pel_smooth *smooth)
{
    uint8_t bytes[PEL_SMOOTH_COLUMNS];
    struct pel_smooth_row row = {w->y, w->x, 0, 0, 0, bytes};
    struct pel_span run = {w->x + w->used, w->next};
    int32_t sum = 0;
    for (int32_t i = 0; i < w->used; i++) {
        sum += w->sum[i];
        add_pixel(&row, bytes, coverage_of(sum));
    }
    const uint8_t coverage = coverage_of(sum + w->sum[w->used]);
    if (coverage == 255 && row.right == 0) {
        row.full += run.x1 - run.x0;
        run.x0 = run.x1;
    }
    trim(&row);
    pel_smooth_paint(smooth, &row);
    paint_run(smooth, w->y, run, coverage);
}
