#include "window.h"

#include <string.h>

void pel_smooth_window_begin(struct pel_smooth_window *w, int32_t y, int32_t x,
                             int32_t end)
{
    w->y = y;
    w->x = x;
    w->n = pel_min(end - x, PEL_SMOOTH_COLUMNS);
    w->next = end;
    for (int32_t i = 0; i <= w->n; i++)
        w->sum[i] = 0;
}

/* Leaves the columns that are in the window; false: none. What is right of the
 * piece grows by `growth` up to their end. */
static bool find_columns(struct pel_smooth_window *w, struct pel_span *columns,
                         int32_t growth)
{
    const int32_t end = w->x + w->n;
    if (columns->x1 <= w->x)
        w->sum[0] += growth;
    if (columns->x1 > end)
        w->next = pel_min(w->next, pel_max(columns->x0, end));
    columns->x0 = pel_max(columns->x0, w->x);
    columns->x1 = pel_min(columns->x1, end);
    return columns->x0 < columns->x1;
}

static void add_areas(struct pel_smooth_window *w,
                      const struct pel_span *columns, const uint16_t *right,
                      int32_t growth)
{
    int32_t *sum = w->sum + (columns->x0 - w->x);
    const int32_t n = columns->x1 - columns->x0;
    int32_t before = 0;
    for (int32_t i = 0; i < n; i++) {
        const int32_t here = growth < 0 ? -right[i] : right[i];
        *sum++ += here - before;
        before = here;
    }
    *sum += growth - before;
}

/* In 2^-15 px: a unit of rise's areas is 2^-24 / 255 px. */
static uint32_t area_of(uint32_t area)
{
    return ((area >> 16) * 257 + 256) >> 9;
}

/* What lies right of a piece in column i of those it crosses, b the last. */
static uint32_t line_area(const struct pel_smooth_line_piece *p, int32_t i,
                          int32_t b)
{
    const uint32_t base = (uint32_t)p->base << 8, h = (uint32_t)p->h >> 1;
    const uint32_t low = (base + p->low) & 0xFFFF;
    const uint32_t high = (base + p->high) & 0xFFFF;
    if (b == 0)
        return (131072 - low - high) / 2 * h >> 16;
    if (i == 0)
        return area_of(pel_smooth_corner(&p->rise, 65536 - low));
    if (i == b)
        return h - area_of(pel_smooth_corner(&p->rise, high));
    return area_of(pel_smooth_between(&p->rise, 65536 - low) +
                   (uint32_t)(i - 1) * p->rise.value);
}

void pel_smooth_window_line(struct pel_smooth_window *w,
                            const struct pel_smooth_line_piece *p, bool rising)
{
    uint16_t right[PEL_SMOOTH_COLUMNS];
    const int32_t a = pel_pixel_of(p->base);
    const int32_t b = pel_pixel_of(p->base + (int32_t)(p->high >> 8));
    const int32_t growth = rising ? p->h >> 1 : -(p->h >> 1);
    struct pel_span columns = {a, b + 1};
    if (!find_columns(w, &columns, growth))
        return;
    for (int32_t x = columns.x0; x < columns.x1; x++)
        right[x - columns.x0] = (uint16_t)line_area(p, x - a, b - a);
    add_areas(w, &columns, right, growth);
}

/* n areas left of a side become those right of it. */
static void turn(uint16_t *area, int32_t n, int32_t h)
{
    for (int32_t i = 0; i < n; i++)
        area[i] = (uint16_t)(h - area[i]);
}

/* Of a mirrored picture. */
static void mirror(uint16_t *area, int32_t n)
{
    for (int32_t i = 0, k = n - 1; i < k; i++, k--) {
        const uint16_t a = area[i];
        area[i] = area[k];
        area[k] = a;
    }
}

void pel_smooth_window_strip(struct pel_smooth_window *w,
                             struct pel_smooth_strip *s, int32_t center,
                             bool left, bool rising)
{
    uint16_t area[PEL_SMOOTH_COLUMNS];
    const int32_t h = pel_smooth_height(s);
    const int32_t a = pel_smooth_column(center, s->at_far);
    const int32_t b = pel_smooth_column(center, s->at_near);
    struct pel_span columns = {left ? -1 - b : a, left ? -a : b + 1};
    if (!find_columns(w, &columns, rising ? h : -h))
        return;
    const int32_t n = columns.x1 - columns.x0;
    pel_smooth_strip_set(s);
    pel_smooth_strip_areas(s, center, left ? -columns.x1 : columns.x0, n, area);
    if (left)
        mirror(area, n);
    else
        turn(area, n, h);
    add_areas(w, &columns, area, rising ? h : -h);
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

/* Another pixel of a row. */
static void add_pixel(struct pel_smooth_row *row, uint8_t *bytes,
                      uint8_t coverage)
{
    if (coverage == 255 && row->right == 0) {
        row->full++;
        return;
    }
    bytes[row->left + row->right] = coverage;
    *(row->full ? &row->right : &row->left) += 1;
}

void pel_smooth_window_paint(const struct pel_smooth_window *w,
                             struct pel_smooth *smooth)
{
    uint8_t bytes[PEL_SMOOTH_COLUMNS];
    struct pel_smooth_row row = {w->y, w->x, 0, 0, 0, bytes};
    struct pel_span run = {w->x + w->n, w->next};
    int32_t sum = 0;
    for (int32_t i = 0; i < w->n; i++) {
        sum += w->sum[i];
        add_pixel(&row, bytes, coverage_of(sum));
    }
    const uint8_t coverage = coverage_of(sum + w->sum[w->n]);
    if (coverage == 255 && row.right == 0) {
        row.full += run.x1 - run.x0;
        run.x0 = run.x1;
    }
    pel_smooth_paint(smooth, &row);
    paint_run(smooth, w->y, run, coverage);
}
