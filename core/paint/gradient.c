#include "cells.h"

/* The middle of cell i of 256 from a to b, rounded: a + (b - a) (2 i + 1) /
 * 512, for two channels in the halves of a word, is the upper byte of
 * mix_sum(a, b, i), which changes by b - a from cell to cell. In each half it
 * is between 128 and 255 * 256 + 128, so nothing is left over between them,
 * though b - a may be negative. */
static uint32_t mix_sum(uint32_t a, uint32_t b, uint32_t i)
{
    const uint32_t half = (b + UINT32_C(0x01000100) - a) >> 1;
    return a * 256 + (half & UINT32_C(0x00FF00FF)) + (b - a) * i;
}

static pel_color mixed(uint32_t high, uint32_t low)
{
    return (high & UINT32_C(0xFF00FF00)) | (low >> 8 & 0xFF00FFu);
}

static pel_color ramp_color(const struct pel_gradient *g, int32_t cell)
{
    const pel_color a = g->ramp.colors[0], b = g->ramp.colors[1];
    const uint32_t i = (uint32_t)cell, mask = 0xFF00FFu;
    if (g->ramp.n != 2)
        return g->ramp.colors[cell];
    return mixed(mix_sum(a >> 8 & mask, b >> 8 & mask, i),
                 mix_sum(a & mask, b & mask, i));
}

int32_t pel_gradient_place(const struct pel_gradient *g, int32_t copy,
                           int32_t part)
{
    if (g->period == 0)
        return copy < 0 ? 0 : copy > 0 ? g->cells - 1 : part;
    return g->period > g->cells && (copy & 1) ? part + g->cells : part;
}

/* Sets the ink of the cell at c->place. */
static void dip(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    const struct pel_format *format = c->cell.surface->format;
    const int32_t place = c->place;
    const pel_color color =
        g->color(g, place < g->cells ? place : g->period - 1 - place);
    const bool opaque = pel_alpha(color) == 255;
    c->ink.draw = opaque ? format->fill : format->blend;
    c->ink.value = opaque ? format->pack(color) : color;
}

void pel_cells_open(struct pel_cells *c, const struct pel_gradient *gradient,
                    const struct pel_spans *spans)
{
    c->gradient = gradient;
    c->cell =
        (struct pel_spans){spans->surface, c->run, spans->y, 0, spans->step};
    c->span = spans->span;
}

/* Are pixels left of the batch? */
static bool find_left(struct pel_cells *c)
{
    c->lo = INT32_MAX;
    c->hi = INT32_MIN;
    for (int32_t i = 0; i < c->cell.n; i++)
        if (c->run[i].x1 < c->span[i].x1) {
            c->lo = pel_min(c->lo, c->run[i].x1);
            c->hi = pel_max(c->hi, c->span[i].x1);
        }
    return c->lo < c->hi;
}

bool pel_cells_next(struct pel_cells *c, const struct pel_spans *spans,
                    int32_t most)
{
    c->limit = INT32_MAX;
    c->way = 1;
    while (!find_left(c)) {
        c->span += c->cell.n;
        c->cell.y += c->cell.n * c->cell.step;
        c->cell.n = pel_min(spans->n - (int32_t)(c->span - spans->span), most);
        if (c->cell.n == 0)
            return false;
        for (int32_t i = 0; i < c->cell.n; i++)
            c->run[i].x1 = c->span[i].x0;
    }
    return true;
}

/* Row i's next run ends before pixel x, which may lie anywhere. Negative when
 * pixels are left. */
static inline int32_t end_run(struct pel_cells *c, int32_t i, int32_t x)
{
    struct pel_span *run = &c->run[i];
    const int32_t end = pel_min(c->span[i].x1, c->hi);
    run->x0 = run->x1;
    run->x1 = pel_max(run->x1, pel_min(x, end));
    return run->x1 - end;
}

bool pel_cells_end(struct pel_cells *c)
{
    const int32_t lo = c->lo, hi = c->hi, n = c->cell.n;
    struct pel_boundary b = c->end;
    int32_t rest = 0;
    for (int32_t i = 0; i < n; i++) {
        for (; b.error < 0 && b.x < hi; b.x++) {
            b.error += b.step;
            b.step += b.bend;
        }
        for (; b.x > lo && b.error >= b.step - b.bend; b.x--) {
            b.step -= b.bend;
            b.error -= b.step;
        }
        if (i == 0)
            c->end = b;
        rest |= end_run(c, i, b.x);
        if (c->cell.step) {
            b.error += b.row;
            b.row += b.row_bend;
        }
    }
    return rest < 0;
}

bool pel_cells_end_all(struct pel_cells *c)
{
    for (int32_t i = 0; i < c->cell.n; i++)
        end_run(c, i, INT32_MAX);
    return false;
}

int32_t pel_cells_pass(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    const struct pel_ink first = c->ink;
    const int32_t most = g->period ? pel_min(c->limit, g->period) : c->limit;
    int32_t count = 0;
    do {
        if (count == most)
            return 0;
        count++;
        c->place += c->way;
        if (g->period && c->place == g->period)
            c->place = 0;
        else if (g->period && c->place < 0)
            c->place = g->period - 1;
        dip(c);
    } while (c->ink.value == first.value && c->ink.draw == first.draw);
    c->limit -= count;
    return count;
}

void pel_cells_first(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    if (g->period == 0)
        c->limit =
            pel_min(c->limit, c->way > 0 ? g->cells - 1 - c->place : c->place);
    dip(c);
}

enum pel_status pel_gradient_init(struct pel_gradient *g,
                                  const struct pel_ramp *ramp)
{
    pel_paint_clear(&g->paint);
    const enum pel_status status = pel_ramp_check(ramp);
    if (status != PEL_OK)
        return status;
    g->color = ramp_color;
    g->ramp = *ramp;
    g->cells = ramp->n == 2 ? 256 : ramp->n;
    g->period = ramp->spread == PEL_PAD      ? 0
                : ramp->spread == PEL_REPEAT ? g->cells
                                             : 2 * g->cells;
    return PEL_OK;
}
