/* Rows of coverage in a paint. It is asked for the colors of many rows at once:
 * to begin takes longer than the few pixels of an edge. */
#include "../format/word.h"
#include "smooth_layer.h"
#include "smooth_mix.h"

#if !PEL_SMOOTH_TINY

/* Colors that are weighed at a time, as many as a batch has and more; and full
 * pixels of a row that are weighed with the others. */
enum { COLORS = PEL_64BIT ? 128 : 48, NARROW = 8 };

/* The pixels before the full ones, those behind them, or all. */
enum part { LEFT, RIGHT, ALL };

/* A row of pixels, as in struct pel_smooth_row. */
struct row {
    const uint8_t *coverage;
    int32_t x;
    uint8_t left, full, right;
};

/* Rows whose colors come in one call. In the buffer a row begins `pitch` colors
 * behind the one before, and as many more as it begins further right: pitch is
 * so large that none reaches into the next, and as edges go on from row to row,
 * little is left free between them. */
struct rows {
    int32_t n, pitch, y, step;
    struct row row[PEL_SMOOTH_BATCH_ROWS];
    struct pel_span span[PEL_SMOOTH_BATCH_ROWS];
    pel_color colors[COLORS];
};

/* Without the pixels of 0 at both ends; a row without full pixels has no right
 * ones. */
static PEL_ALWAYS_INLINE void drop_zeros(struct pel_smooth_row *row)
{
    const uint8_t *coverage = row->coverage;
    int32_t left = row->left, right = row->right;
    for (; left > 0 && *coverage == 0; left--, row->x++)
        coverage++;
    for (; right > 0 && coverage[left + right - 1] == 0; right--)
        ;
    for (; row->full == 0 && left > 0 && coverage[left - 1] == 0; left--)
        ;
    row->left = left;
    row->right = right;
    row->coverage = coverage;
}

/* A part of the first row. */
static PEL_ALWAYS_INLINE void set_row(struct row *to, struct pel_span *span,
                                      const struct pel_smooth_runs *runs,
                                      enum part part)
{
    const int32_t left = runs->count[0], right = runs->count[1];
    const int32_t x0 = runs->x[0], x1 = runs->x[1];
    struct pel_smooth_row row = {0, x0 - left, left, 0, 0, runs->coverage};
    if (part == RIGHT) {
        row.coverage += left;
        row.x = x1;
        row.left = right;
    } else if (part == ALL && x0 < x1) {
        row.full = x1 - x0;
        row.right = right;
    } else if (part == ALL) {
        row.left = left + right;
    }
    drop_zeros(&row);
    *to = (struct row){row.coverage, row.x, (uint8_t)row.left,
                       (uint8_t)row.full, (uint8_t)row.right};
    span->x0 = row.x;
    span->x1 = row.x + row.left + row.full + row.right;
}

static PEL_ALWAYS_INLINE void next_row(struct pel_smooth_runs *runs)
{
    runs->coverage += runs->count[0] + runs->count[1];
    runs->count += 2;
    runs->x += 2;
    runs->y += runs->step;
    runs->n--;
}

/* Takes a row, and more while there is room for their colors. */
static PEL_ALWAYS_INLINE void take_rows(struct rows *r,
                                        struct pel_smooth_runs *runs,
                                        enum part part)
{
    struct pel_span *span = r->span;
    int32_t n = 0, most = 0;
    r->y = runs->y;
    r->step = runs->step;
    for (; runs->n > 0; next_row(runs), span++) {
        set_row(&r->row[n], span, runs, part);
        const int32_t pitch = n ? pel_max(most, span[-1].x1 - span->x0) : 0;
        if (n > 0 && n * pitch + span->x1 - r->span->x0 > COLORS)
            break;
        most = pitch;
        n++;
    }
    r->pitch = most;
    r->n = n;
}

static void turn_over(struct pel_span *span, int32_t n)
{
    for (int32_t i = 0; i < --n; i++) {
        const struct pel_span other = span[i];
        span[i] = span[n];
        span[n] = other;
    }
}

static PEL_NOINLINE_32 void take_colors(const struct pel_smooth *smooth,
                                        struct rows *r)
{
    const struct pel_span *const first = r->span;
    const int32_t last = r->n - 1;
    const int32_t y = r->y;
    struct pel_smooth_surface buffer;
    struct pel_spans spans = {&buffer.surface, first, y, r->n, 1};
    pel_smooth_buffer_set(&buffer, smooth->target, first, y, r->colors);
    buffer.surface.stride = r->pitch * r->step * (int32_t)sizeof(pel_color);
    pel_smooth_set_colors(r->colors,
                          last * r->pitch + first[last].x1 - first->x0, 0);
    if (r->step < 0) {
        spans.y -= last;
        turn_over(r->span, r->n);
    }
    smooth->paint->fill(smooth->paint, &spans);
}

static void put_row(const struct pel_surface *target, const struct row *row,
                    int32_t y, pel_color *colors)
{
    const int32_t behind = row->left + row->full, n = behind + row->right;
    pel_smooth_weigh(colors, row->left, row->coverage);
    pel_smooth_weigh(colors + behind, row->right, row->coverage + row->left);
    if (n > 0)
        target->format->put(target, row->x, y, n, colors);
}

static void mix_row(const struct pel_surface *target, const struct row *row,
                    int32_t y, const pel_color *colors, pel_smooth_mixer *mix)
{
    const int32_t bytes = target->format->bits >> 3, left = row->left;
    const int32_t behind = left + row->full;
    const uintptr_t at = pel_address(target, row->x, y, bytes);
    mix(at, left, colors, row->coverage);
    if (row->full > 0)
        target->format->put(target, row->x + left, y, row->full, colors + left);
    if (row->right > 0)
        mix(at + (uintptr_t)(behind * bytes), row->right, colors + behind,
            row->coverage + left);
}

static PEL_NOINLINE_32 void put_rows(const struct pel_surface *target,
                                     struct rows *r)
{
    pel_smooth_mixer *const mix = pel_smooth_mixer_of(target->format);
    const struct row *row = r->row;
    int32_t from = -row->x, y = r->y;
    for (int32_t i = r->n; i > 0; i--, row++, from += r->pitch, y += r->step)
        if (mix)
            mix_row(target, row, y, r->colors + (from + row->x), mix);
        else
            put_row(target, row, y, r->colors + (from + row->x));
}

static PEL_NOINLINE_32 void paint_part(const struct pel_smooth *smooth,
                                       const struct pel_smooth_runs *all,
                                       enum part part)
{
    struct pel_smooth_runs runs = *all;
    struct rows r;
    while (runs.n > 0) {
        take_rows(&r, &runs, part);
        if (!pel_smooth_has_pixels(r.span, r.n))
            continue;
        take_colors(smooth, &r);
        if (smooth->target->format)
            put_rows(smooth->target, &r);
    }
}

/* Weighs the full pixels with the others, where they are few: a paint of many
 * colors begins once, not three times. */
static bool paint_narrow(const struct pel_smooth *smooth,
                         const struct pel_smooth_runs *runs)
{
    for (int32_t i = 0; i < 2 * runs->n; i += 2)
        if ((uint32_t)(runs->x[i + 1] - runs->x[i]) > NARROW ||
            runs->count[i] + runs->count[i + 1] > COLORS - NARROW)
            return false;
    paint_part(smooth, runs, ALL);
    return true;
}

static PEL_NOINLINE_32 void put_flat(const struct pel_surface *target,
                                     const struct pel_smooth_runs *runs,
                                     pel_color color)
{
    const uint8_t *coverage = runs->coverage;
    int32_t y = runs->y;
    pel_color colors[COLORS];
    for (int32_t i = 0; i < 2 * runs->n; i++) {
        const int32_t n = runs->count[i];
        const int32_t x = runs->x[i] - (i & 1 ? 0 : n);
        pel_smooth_set_colors(colors, n, color);
        pel_smooth_weigh(colors, n, coverage);
        if (n > 0)
            target->format->put(target, x, y, n, colors);
        coverage += n;
        y += i & 1 ? runs->step : 0;
    }
}

static void paint_edges(const struct pel_smooth *smooth,
                        const struct pel_smooth_runs *runs,
                        const struct pel_flat *flat)
{
    if (!flat) {
        paint_part(smooth, runs, LEFT);
        paint_part(smooth, runs, RIGHT);
    } else if (pel_smooth_mixes(smooth->target)) {
        pel_smooth_mix(smooth->target, runs, flat->color);
    } else {
        put_flat(smooth->target, runs, flat->color);
    }
}

static struct pel_smooth_runs runs_of(const struct pel_smooth_batch *b,
                                      int32_t y, int32_t step)
{
    return (struct pel_smooth_runs){y,       step,     b->n,
                                    b->at.x, b->count, b->coverage};
}

void pel_smooth_paint_batch(const struct pel_smooth *smooth,
                            const struct pel_smooth_batch *b)
{
    const struct pel_flat *const flat = pel_smooth_flat(smooth);
    const struct pel_smooth_runs runs = runs_of(b, b->y, 1);
    if (!flat && paint_narrow(smooth, &runs))
        return;
    pel_smooth_paint_full(smooth, b->y, b->n, b->at.full);
    paint_edges(smooth, &runs, flat);
}

void pel_smooth_paint_upwards(const struct pel_smooth *smooth,
                              struct pel_smooth_batch *b, int32_t y)
{
    const struct pel_flat *const flat = pel_smooth_flat(smooth);
    const struct pel_smooth_runs runs = runs_of(b, y, -1);
    if (!flat && paint_narrow(smooth, &runs))
        return;
    turn_over(b->at.full, b->n);
    pel_smooth_paint_full(smooth, y - b->n + 1, b->n, b->at.full);
    turn_over(b->at.full, b->n);
    paint_edges(smooth, &runs, flat);
}

static void paint_row(const struct pel_smooth *smooth,
                      const struct pel_smooth_row *row)
{
    const struct pel_flat *const flat = pel_smooth_flat(smooth);
    const int32_t full = row->x + row->left;
    const int32_t x[2] = {full, full + row->full};
    const struct pel_span span = {x[0], x[1]};
    const uint8_t count[2] = {(uint8_t)row->left, (uint8_t)row->right};
    const struct pel_smooth_runs runs = {row->y, 1, 1, x, count, row->coverage};
    if (!flat && paint_narrow(smooth, &runs))
        return;
    pel_smooth_paint_full(smooth, row->y, 1, &span);
    paint_edges(smooth, &runs, flat);
}

/* Of a long run so many pixels at a time as there is room for their colors. */
void pel_smooth_paint(const struct pel_smooth *smooth,
                      const struct pel_smooth_row *row)
{
    struct pel_smooth_row part = *row;
    int32_t left = row->left, full = row->full, right = row->right;
    do {
        part.left = pel_min(left, COLORS);
        left -= part.left;
        part.full = left > 0 ? 0 : full;
        full -= part.full;
        part.right = left > 0 ? 0 : pel_min(right, COLORS);
        right -= part.right;
        paint_row(smooth, &part);
        part.x += part.left + part.full + part.right;
        part.coverage += part.left + part.right;
    } while (left + right > 0);
}

#endif
