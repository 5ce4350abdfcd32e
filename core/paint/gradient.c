#include "gradient.h"

/* The middle of cell i of 256 from a to b, rounded: a + (b - a) (2 i + 1) /
 * 512, for two channels in the halves of a word, is the upper byte of start(a,
 * b) + i (b - a). In each half the sum is between 128 and 255 * 256 + 128, so
 * nothing is left over between them, though b - a may be negative. */
static uint32_t start(uint32_t a, uint32_t b)
{
    const uint32_t half = (b + UINT32_C(0x01000100) - a) >> 1;
    return a * 256 + (half & UINT32_C(0x00FF00FF));
}

static pel_color mixed(const uint32_t sum[2])
{
    return (sum[0] & UINT32_C(0xFF00FF00)) | (sum[1] >> 8 & 0xFF00FFu);
}

static void mix_start(const struct pel_ramp *ramp, uint32_t i, uint32_t sum[2],
                      uint32_t change[2])
{
    for (int k = 0; k < 2; k++) {
        const uint32_t a = ramp->colors[0] >> (8 - 8 * k) & 0xFF00FFu;
        const uint32_t b = ramp->colors[1] >> (8 - 8 * k) & 0xFF00FFu;
        change[k] = b - a;
        sum[k] = start(a, b) + (b - a) * i;
    }
}

static pel_color ramp_color(const struct pel_gradient *g, int32_t cell)
{
    return g->ramp.colors[cell];
}

/* The color of the cell at c->place. */
static PEL_NOINLINE void set_color(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    const bool back = c->place >= g->cells;
    const int32_t cell = back ? g->period - 1 - c->place : c->place;
    if (g->color) {
        c->color = g->color(g, cell);
        return;
    }
    mix_start(&g->ramp, (uint32_t)cell, c->sum, c->change);
    for (int k = 0; k < 2; k++)
        if (back == (c->step > 0))
            c->change[k] = 0 - c->change[k];
    c->color = mixed(c->sum);
}

/* Moves on to the next cell. */
static void next_color(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    c->place += c->step;
    if (g->period && c->place == g->period)
        c->place = 0;
    else if (g->period && c->place < 0)
        c->place = g->period - 1;
    set_color(c);
}

int32_t pel_gradient_place(const struct pel_gradient *g, int32_t way,
                           int32_t part)
{
    if (g->period == 0)
        return way < 0 ? 0 : way > 0 ? g->cells - 1 : part;
    return g->period > g->cells && (way & 1) ? part + g->cells : part;
}

/* Formats drop the low bits of channels; those of grey ask pack. */
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

bool pel_cells_begin(struct pel_cells *c, const struct pel_gradient *gradient,
                     const struct pel_spans *spans)
{
    c->gradient = gradient;
    c->spans = spans;
    c->stop = INT32_MAX;
    c->step = 1;
    c->limit = INT32_MAX;
    c->mask = mask_of(spans->surface->format);
    c->all = (struct pel_span){INT32_MAX, INT32_MIN};
    for (int32_t i = 0; i < spans->n; i++) {
        const struct pel_span *span = &spans->span[i];
        c->run[i].x1 = span->x0;
        if (span->x0 < span->x1) {
            c->all.x0 = pel_min(c->all.x0, span->x0);
            c->all.x1 = pel_max(c->all.x1, span->x1);
        }
    }
    return c->all.x0 < c->all.x1;
}

/* Are both the same pixel value? */
static bool alike(const struct pel_cells *c, pel_color a, pel_color b)
{
    if (pel_alpha(a & b) != 255)
        return a == b;
    if (c->mask)
        return ((a ^ b) & c->mask) == 0;
    const struct pel_format *format = c->spans->surface->format;
    return a == b || format->pack(a) == format->pack(b);
}

/* Moves on through cells of two mixed colours, at most `count` of them and not
 * past the last of the 256 that are stepped, while they are alike. How many it
 * left. */
static int32_t pass_mixed(struct pel_cells *c, int32_t count)
{
    const pel_color mask = pel_alpha(c->color) == 255 ? c->mask : UINT32_MAX;
    const uint32_t mask0 = mask & UINT32_C(0xFF00FF00), mask1 = mask << 8;
    const uint32_t change0 = c->change[0], change1 = c->change[1];
    const uint32_t first0 = c->sum[0], first1 = c->sum[1];
    uint32_t sum0 = first0, sum1 = first1;
    const int32_t most =
        pel_min(c->step > 0 ? 255 - (c->place & 255) : c->place & 255, count);
    int32_t left = most;
    while (left > 0) {
        sum0 += change0;
        sum1 += change1;
        left--;
        if (((sum0 ^ first0) & mask0) |
            ((sum1 ^ first1) & mask1 & UINT32_C(0xFF00FF00)))
            break;
    }
    c->sum[0] = sum0;
    c->sum[1] = sum1;
    c->color = mixed(c->sum);
    c->place += (most - left) * c->step;
    return most - left;
}

/* How many cells from the present one on have its color; 0: all that may come.
 * Moves on to the first other one. */
static PEL_NOINLINE int32_t count_alike(struct pel_cells *c)
{
    const pel_color first = c->color;
    const int32_t period = c->gradient->period;
    const int32_t most = period ? pel_min(c->limit, period) : c->limit;
    const bool mixes = !c->gradient->color && c->mask;
    int32_t count = 0;
    do {
        int32_t passed = 0;
        if (count == most)
            return 0;
        if (mixes)
            passed = pass_mixed(c, most - count);
        if (passed == 0) {
            passed = 1;
            next_color(c);
        }
        count += passed;
    } while (alike(c, first, c->color));
    c->limit -= count;
    return count;
}

static void end_all(struct pel_cells *c)
{
    for (int32_t i = 0; i < c->spans->n; i++)
        pel_cells_end_run(c, i, INT32_MAX);
    c->rest = false;
}

void pel_cells_draw(struct pel_cells *c)
{
    const struct pel_gradient *g = c->gradient;
    if (g->period == 0)
        c->limit =
            pel_min(c->limit, c->step > 0 ? g->cells - 1 - c->place : c->place);
    set_color(c);
    do {
        const pel_color present = c->color;
        const int32_t count = count_alike(c);
        if (count)
            c->end(c, count);
        else
            end_all(c);
        const struct pel_spans cell = {c->spans->surface, c->run, c->spans->y,
                                       c->spans->n, c->spans->step};
        pel_fill_color(&cell, present);
    } while (c->rest);
}

void pel_gradient_parts(const struct pel_gradient *g,
                        const struct pel_spans *spans, int32_t width,
                        void (*draw)(const struct pel_gradient *,
                                     const struct pel_spans *))
{
    struct pel_span part;
    struct pel_spans one = {spans->surface, &part, spans->y, 1, 1};
    for (int32_t i = 0; i < spans->n; i++, one.y += spans->step) {
        part = (struct pel_span){spans->span[i].x0, spans->span[i].x0};
        for (; part.x0 < spans->span[i].x1; part.x0 = part.x1) {
            part.x1 = pel_min(part.x0 + width, spans->span[i].x1);
            draw(g, &one);
        }
    }
}

enum pel_status pel_gradient_init(struct pel_gradient *g,
                                  const struct pel_ramp *ramp)
{
    pel_paint_clear(&g->paint);
    const enum pel_status status = pel_ramp_check(ramp);
    if (status != PEL_OK)
        return status;
    g->color = ramp->n == 2 ? NULL : ramp_color;
    g->ramp = *ramp;
    g->cells = ramp->n == 2 ? 256 : ramp->n;
    g->period = ramp->spread == PEL_PAD      ? 0
                : ramp->spread == PEL_REPEAT ? g->cells
                                             : 2 * g->cells;
    return PEL_OK;
}
