#include "cells_fill.h"

enum { FAR = 1 << 20 }; /* px: to the right of every pixel */

int32_t pel_spans_hull(struct pel_span *hull, const struct pel_span *span,
                       int32_t n)
{
    int32_t pixels = 0;
    *hull = (struct pel_span){FAR, -FAR};
    for (; n > 0; n--, span++)
        if (span->x0 < span->x1) {
            hull->x0 = pel_min(hull->x0, span->x0);
            hull->x1 = pel_max(hull->x1, span->x1);
            pixels += span->x1 - span->x0;
        }
    return pixels;
}

/* A mixed color in less code: a + (b - a) part / 512, rounded. */
static inline pel_color mixed_by_channels(pel_color a, pel_color b,
                                          int32_t part)
{
    pel_color color = 0;
    for (int k = 4; k > 0; k--, a <<= 8, b <<= 8) {
        const int32_t from = (int32_t)(a >> 24), to = (int32_t)(b >> 24);
        const int32_t level = from + (((to - from) * part + 256) >> 9);
        color = (color << 8) + (uint32_t)level;
    }
    return color;
}

static pel_color ramp_color(const struct pel_gradient *g, int32_t index)
{
    const pel_color *const colors = g->ramp.colors;
    const int32_t cell = index < g->cells ? index : g->period - 1 - index;
    if (g->ramp.n != 2)
        return colors[cell];
    if (PEL_SMALL_CODE)
        return mixed_by_channels(colors[0], colors[1], 2 * cell + 1);
    struct pel_mix mix;
    pel_mix_start(&mix, g, cell, 1);
    return pel_mixed(mix);
}

void pel_cells_color(struct pel_cells *c)
{
    const pel_color color = c->gradient->color(c->gradient, c->index);
    const struct pel_format *format = c->cell.surface->format;
    const bool opaque = pel_alpha(color) == 255;
#if PEL_SHORT_STACK
    c->draw = opaque;
#else
    c->draw = opaque ? format->fill : format->blend;
#endif
    c->value = opaque ? format->pack(color) : color;
}

#if !PEL_SMALL_CODE

/* What can be seen of a color. */
static inline pel_color find_mask(const struct pel_surface *surface)
{
    pel_color mask = 0;
    for (int k = 0; k < 3; k++)
        mask = mask << 8 | (0xFF00u >> surface->format->depth[k] & 0xFF);
    return mask;
}

/* The mask, and the column where these rows have all ended, are kept, or found
 * anew where stack is short. */
#if PEL_SHORT_STACK

static inline void keep(struct pel_cells *c, int32_t end, pel_color mask)
{
    (void)c;
    (void)end;
    (void)mask;
}

static inline pel_color mask_of(const struct pel_cells *c)
{
    return find_mask(c->cell.surface);
}

static inline int32_t end_of(const struct pel_cells *c)
{
    struct pel_span hull;
    pel_spans_hull(&hull, c->span, c->cell.n);
    return hull.x1;
}

void pel_cells_fill_few(const struct pel_paint *paint,
                        const struct pel_spans *spans, int32_t most,
                        pel_cells_filler *fill)
{
    struct pel_span run[PEL_ROWS];
    fill(paint, spans, most, run);
}

void pel_cells_fill_many(const struct pel_paint *paint,
                         const struct pel_spans *spans, int32_t most,
                         pel_cells_filler *fill)
{
    struct pel_span run[PEL_CELL_ROWS];
    fill(paint, spans, most, run);
}

#else

static inline void keep(struct pel_cells *c, int32_t end, pel_color mask)
{
    c->end = end;
    c->mask = mask;
}

static inline pel_color mask_of(const struct pel_cells *c)
{
    return c->mask;
}

static inline int32_t end_of(const struct pel_cells *c)
{
    return c->end;
}

#endif

int32_t pel_cells_pass_mixed(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    const bool back = c->index >= g->cells, down = back == (c->direction > 0);
    const int32_t i = back ? g->period - 1 - c->index : c->index;
    const int32_t most = down ? i : 255 - i;
    struct pel_mix mix;
    pel_mix_start(&mix, g, i, down ? -1 : 1);
    const pel_color mask = mask_of(c), first = pel_mixed(mix) & mask;
    int32_t passed = 0;
    for (; passed < most; passed++) {
        mix.high += mix.high_change;
        mix.low += mix.low_change;
        if ((pel_mixed(mix) & mask) != first)
            break;
    }
    c->index = (pel_cell_index)(c->index + c->direction * passed);
    return passed;
}

void pel_cells_open(struct pel_cells *c, const struct pel_gradient *gradient,
                    const struct pel_spans *spans, int32_t most)
{
    const uint8_t *const depth = spans->surface->format->depth;
    const struct pel_ramp *const ramp = &gradient->ramp;
    c->gradient = gradient;
    c->cell =
        (struct pel_spans){spans->surface, NULL, spans->y, 0, spans->step};
    c->at.x1 = 0; /* no rows: the first batch is the next one */
    c->span = spans->span;
    c->left = (uint8_t)spans->n;
    /* at most PEL_CELL_ROWS: the mask tells compilers that no bit is lost */
    c->most = (unsigned)most & (PEL_CELL_ROWS_MOST | 31);
    c->mixed = ramp->n == 2 && depth[1] &&
               pel_alpha(ramp->colors[0] & ramp->colors[1]) == 255;
    keep(c, 0, PEL_SHORT_STACK ? 0 : find_mask(spans->surface));
}

/* The next batch of rows; false where none comes. */
static bool next_rows(struct pel_cells *c)
{
    const int32_t n = c->cell.n;
    c->span += n;
    c->cell.y += n * c->cell.step;
    c->left = (uint8_t)(c->left - n);
    c->cell.n = pel_min(c->left, pel_max(c->most, 1));
    return c->cell.n > 0;
}

bool pel_cells_next(struct pel_cells *c)
{
    struct pel_span hull = {0, end_of(c)};
    while (c->at.x1 >= hull.x1) {
        if (!next_rows(c))
            return false;
        const int32_t pixels = pel_spans_hull(&hull, c->span, c->cell.n);
        c->at.x1 = hull.x0;
        keep(c, hull.x1, PEL_SHORT_STACK ? 0 : mask_of(c));
        c->box = pixels == c->cell.n * (hull.x1 - hull.x0);
    }
    c->hi = c->most ? hull.x1 : c->at.x1 + 1;
    struct pel_span *const run = pel_cells_run(c);
    for (int32_t i = 0; i < c->cell.n; i++)
        run[i].x1 = pel_max(c->at.x1, c->span[i].x0);
    return true;
}

/* Keeps the runs in the spans of their rows: below 0 when pixels are left. */
static int32_t cut(struct pel_cells *c)
{
    const int32_t hi = c->hi;
    struct pel_span *const run = pel_cells_run(c);
    int32_t sign = 0;
    for (int32_t i = 0; i < c->cell.n; i++) {
        const int32_t end = pel_min(c->span[i].x1, hi);
        const int32_t x = pel_max(run[i].x0, pel_min(run[i].x1, end));
        run[i].x1 = x;
        sign |= x - end;
    }
    return sign;
}

/* From the first row, whose run has ended, to the others: below 0 when pixels
 * are left of a box. The error is not taken for more than +-2^30: that is
 * beyond 32 rows and every step. */
static int32_t end_rows(struct pel_cells *c, int32_t step, int32_t row,
                        int32_t bend)
{
    const int32_t hi = c->hi, most = 1 << 30;
    const int32_t row_bend = bend * c->cell.step;
    int32_t x = c->at.x1, sign = x - hi;
    int32_t error = c->error < -most  ? -most
                    : c->error > most ? most
                                      : (int32_t)c->error;
    row *= c->cell.step;
    step -= bend;
    struct pel_span *run = pel_cells_run(c);
    for (int32_t left = c->cell.n; --left > 0;) {
        run++;
        error += row;
        row += row_bend;
        if (error < 0 && x < hi)
            do {
                step += bend;
                error += step;
                x++;
            } while (error < 0 && x < hi);
        else
            for (; error >= step && x > run->x1; x--) {
                error -= step;
                step -= bend;
            }
        run->x0 = run->x1;
        run->x1 = x;
        sign |= x - hi;
    }
    return sign;
}

int32_t pel_cells_pass(struct pel_cells *c, int32_t most)
{
    return pel_cells_pass_here(c, most);
}

#endif

/* The first row by steps of 64 bits. */
bool pel_cells_end(struct pel_cells *c, int32_t step, int32_t row, int32_t bend)
{
    const int32_t hi = c->hi;
    int32_t x = c->at.x1;
    int64_t error = c->error;
    if (PEL_SHORT_STACK && step == PEL_CELL_ALL)
        x = hi;
    for (; error < 0 && x < hi; x++) {
        error += step;
        step += bend;
    }
    c->error = error;
#if !PEL_SMALL_CODE
    struct pel_span *const run = pel_cells_run(c);
    run->x0 = run->x1;
    run->x1 = c->at.x1 = x;
    const int32_t sign = end_rows(c, step, row, bend);
    return (c->box ? sign : cut(c)) < 0;
#else
    (void)row;
    c->at.x1 = x;
    return x < hi;
#endif
}

enum pel_status pel_gradient_init(struct pel_gradient *g,
                                  const struct pel_ramp *ramp)
{
    if (!g)
        return PEL_ERROR_NULL;
    pel_paint_clear(&g->paint);
    if (!ramp || !ramp->colors)
        return PEL_ERROR_NULL;
    if (ramp->n == 0 || (uint32_t)ramp->n >> 15)
        return PEL_ERROR_SIZE;
    g->color = ramp_color;
    g->ramp = *ramp;
    g->cells = ramp->n == 2 ? 256 : ramp->n;
    g->period = ramp->spread == PEL_REFLECT ? 2 * g->cells : g->cells;
    return PEL_OK;
}
