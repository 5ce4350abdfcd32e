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

static pel_color color_at(const struct pel_gradient *g, int32_t place)
{
    return g->color(g, place < g->cells ? place : g->period - 1 - place);
}

int32_t pel_gradient_place(const struct pel_gradient *g, int32_t copy,
                           int32_t part)
{
    if (g->period == 0)
        return copy < 0 ? 0 : copy > 0 ? g->cells - 1 : part;
    return g->period > g->cells && (copy & 1) ? part + g->cells : part;
}

#if PEL_KNOW_SIDES

/* Formats drop the low bits of channels; those of grey show a sum: 0. */
static pel_color mask_of(const struct pel_format *format)
{
    pel_color mask = 0xFF;
    if (!format->dithering)
        return UINT32_MAX;
    if (format->dithering->depth[1] == 0)
        return 0;
    for (int k = 0; k < 3; k++)
        mask = mask << 8 | (0xFF00u >> format->dithering->depth[k] & 0xFF);
    return mask;
}

static void set_mask(struct pel_cells *c)
{
    c->mask = mask_of(c->cell.surface->format);
}

#else

static void set_mask(struct pel_cells *c)
{
    (void)c;
}

#endif

void pel_cells_open(struct pel_cells *c, const struct pel_gradient *gradient,
                    const struct pel_spans *spans)
{
    c->gradient = gradient;
    c->cell =
        (struct pel_spans){spans->surface, c->run, spans->y, 0, spans->step};
    c->span = spans->span;
    set_mask(c);
}

/* The first pixel that is left of the batch; INT32_MAX: none is. */
static int32_t first_left(const struct pel_cells *c)
{
    int32_t x0 = INT32_MAX;
    for (int32_t i = 0; i < c->cell.n; i++)
        if (c->run[i].x1 < c->span[i].x1)
            x0 = pel_min(x0, c->run[i].x1);
    return x0;
}

int32_t pel_cells_next(struct pel_cells *c, const struct pel_spans *spans,
                       int32_t most)
{
    int32_t x0;
    c->stop = INT32_MAX;
    c->limit = INT32_MAX;
    c->step = 1;
    while ((x0 = first_left(c)) == INT32_MAX) {
        c->span += c->cell.n;
        c->cell.y += c->cell.n * c->cell.step;
        c->cell.n = pel_min(spans->n - (int32_t)(c->span - spans->span), most);
        if (c->cell.n == 0)
            break;
        for (int32_t i = 0; i < c->cell.n; i++)
            c->run[i].x1 = c->span[i].x0;
    }
    return x0;
}

bool pel_cells_end_at(struct pel_cells *c, struct pel_edge *edge)
{
    const int32_t n = c->cell.n, step = c->cell.step;
    int32_t rest = 0;
    for (int32_t i = 0; i < n; i++) {
        rest |= pel_cells_end_run(c, i, edge->x);
        if (step)
            pel_edge_next(edge);
    }
    return rest < 0;
}

bool pel_cells_end_all(struct pel_cells *c)
{
    for (int32_t i = 0; i < c->cell.n; i++)
        pel_cells_end_run(c, i, INT32_MAX);
    return false;
}

/* Are both the same pixel value? */
static bool alike(const struct pel_format *format, pel_color a, pel_color b)
{
    return a == b ||
           (pel_alpha(a & b) == 255 && format->pack(a) == format->pack(b));
}

#if PEL_KNOW_SIDES

/* Passes cells of two mixed colours that are alike under the mask, at most
 * `most` of them and none but by steps. How many. */
static int32_t pass_mixed(const struct pel_cells *c, pel_color mask,
                          int32_t most)
{
    const struct pel_gradient *g = c->gradient;
    const bool back = c->place >= g->cells, down = back == (c->step > 0);
    const uint32_t i = (uint32_t)(back ? g->period - 1 - c->place : c->place);
    const uint32_t a = g->ramp.colors[0], b = g->ramp.colors[1], m = 0xFF00FFu;
    const uint32_t sign = down ? UINT32_MAX : 1;
    const uint32_t change0 = sign * ((b >> 8 & m) - (a >> 8 & m));
    const uint32_t change1 = sign * ((b & m) - (a & m));
    uint32_t high = mix_sum(a >> 8 & m, b >> 8 & m, i);
    uint32_t low = mix_sum(a & m, b & m, i);
    const uint32_t high0 = high, low0 = low;
    const uint32_t high_mask = mask & ~m, low_mask = (mask & m) << 8;
    most = pel_min(most, (int32_t)(down ? i : 255 - i));
    int32_t left = most;
    for (; left > 0; left--) {
        high += change0;
        low += change1;
        if (((high ^ high0) & high_mask) | ((low ^ low0) & low_mask))
            break;
    }
    return most - left;
}

/* Cells from the present one on that are passed at once, short of the first
 * other one. */
static int32_t pass(const struct pel_cells *c, int32_t most)
{
    const struct pel_gradient *g = c->gradient;
    if (g->ramp.n != 2 || c->mask == 0 || c->mask == UINT32_MAX)
        return 0;
    return pass_mixed(c, pel_alpha(c->color) == 255 ? c->mask : UINT32_MAX,
                      most);
}

#else

static int32_t pass(const struct pel_cells *c, int32_t most)
{
    (void)c;
    (void)most;
    return 0;
}

#endif

int32_t pel_cells_pass(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    const pel_color first = c->color;
    const int32_t most = g->period ? pel_min(c->limit, g->period) : c->limit;
    int32_t count = 0;
    do {
        const int32_t passed = pass(c, most - count);
        count += passed;
        if (count == most)
            return 0;
        count++;
        c->place += c->step * (passed + 1);
        if (g->period && c->place == g->period)
            c->place = 0;
        else if (g->period && c->place < 0)
            c->place = g->period - 1;
        c->color = color_at(g, c->place);
    } while (alike(c->cell.surface->format, first, c->color));
    c->limit -= count;
    return count;
}

void pel_cells_first(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    if (g->period == 0)
        c->limit =
            pel_min(c->limit, c->step > 0 ? g->cells - 1 - c->place : c->place);
    c->color = color_at(g, c->place);
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
