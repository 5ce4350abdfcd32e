#include "smooth_dither.h"
#include "smooth_layer.h"

#include "../format/word.h"

static pel_color *color_at(const struct pel_surface *s, int32_t x, int32_t y)
{
    if (PEL_SMOOTH_TINY) /* there is one row */
        return (pel_color *)s->pixels + (x - s->bounds.x0);
    return (void *)pel_address(s, x, y, 4);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    for (pel_color *at = color_at(s, x, y); n > 0; n--)
        *at++ = *colors++;
}

/* Of one row, for little code and stack. */
static void fill(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    for (; span < spans->span + spans->n; span++)
        for (int32_t x = span->x0; x < span->x1; x++)
            *color_at(spans->surface, x, spans->y) = color;
}

static void load(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, pel_color *colors)
{
    const struct pel_surface *const target =
        ((const struct pel_smooth_surface *)(const void *)surface)->target;
    target->format->load(target, x, y, n, colors);
}

static pel_color same(uint32_t color)
{
    return color;
}

/* The colors of a walk through a gradient. */
static bool put_walk(const struct pel_surface *surface, int32_t x, int32_t y,
                     int32_t n, const struct pel_walk *walk)
{
    pel_color *at = color_at(surface, x, y), *const end = at + n;
    uint32_t high = walk->mix.high, low = walk->mix.low;
    int32_t error = walk->error, remainder = walk->remainder;
    const int32_t step = walk->step;
    do {
        const pel_color color =
            (high & UINT32_C(0xFF00FF00)) | (low >> 8 & UINT32_C(0x00FF00FF));
        for (; error < 0 && at < end; error += step)
            *at++ = color;
        error -= walk->cell;
        remainder -= walk->cell_remainder;
        if (remainder < 0) {
            remainder += walk->unit;
            error--;
        }
        high += walk->mix.high_change;
        low += walk->mix.low_change;
    } while (at < end);
    return true;
}

static const struct pel_channels channels = {.fill = pel_smooth_dither_fill,
                                             .put = pel_smooth_dither_put,
                                             .walk = put_walk};

const struct pel_format pel_smooth_colors = {
    .id = PEL_SMOOTH_FORMAT,
    .bits = 32,
    .word = 4,
    .pack = same,
    .unpack = same,
    .fill = PEL_SMOOTH_TINY ? fill : pel_fill32,
    .blend = PEL_SMOOTH_TINY ? fill : pel_fill32,
    .put = put,
    .load = load,
    .channels = PEL_SMOOTH_TINY ? NULL : &channels};

bool pel_smooth_begin(struct pel_smooth *smooth,
                      const struct pel_surface *surface,
                      const struct pel_paint *paint)
{
    const bool legal = !surface->format || surface->format->put;
    PEL_ASSERT(legal);
    *smooth = (struct pel_smooth){surface, paint};
    return legal;
}

bool pel_smooth_drawing_begin(struct pel_smooth_drawing *d,
                              const struct pel_smooth *smooth)
{
    const struct pel_flat *const flat = pel_smooth_flat(smooth);
    const struct pel_span *const span = d->spans.span;
    d->buffer.target = smooth->target;
    pel_smooth_set_colors(d->colors, span->x1 - span->x0,
                          flat ? flat->color : 0);
    if (flat)
        return false;
    pel_smooth_buffer_set(&d->buffer, smooth->target, span, d->spans.y,
                          d->colors);
    d->spans.surface = &d->buffer.surface;
    return true;
}

static PEL_NOINLINE void weigh(pel_color *colors, int32_t n,
                               const uint8_t *coverage)
{
    pel_smooth_weigh(colors, n, coverage);
}

void pel_smooth_drawing_end(struct pel_smooth_drawing *d,
                            const uint8_t *coverage)
{
    const struct pel_surface *const target = d->buffer.target;
    const struct pel_span *const span = d->spans.span;
    const int32_t n = span->x1 - span->x0;
    weigh(d->colors, n, coverage);
    if (target->format)
        target->format->put(target, span->x0, d->spans.y, n, d->colors);
}

PEL_STATIC_ASSERT(pel_smooth_pixels_are_4, PEL_SMOOTH_PIXELS == 4);

int32_t pel_smooth_take_alike(struct pel_smooth_pixels *p, uint8_t coverage,
                              int32_t n)
{
    if (coverage > 0 && coverage < 255)
        n = pel_min(n, PEL_SMOOTH_PIXELS);
    p->coverage[0] = coverage ? coverage : 255;
    p->coverage[1] = p->coverage[2] = p->coverage[3] = coverage;
    p->span.x0 = p->span.x1 + (coverage ? 0 : n);
    p->span.x1 += n;
    return n;
}

int32_t pel_smooth_take_pixels(struct pel_smooth_pixels *p, int32_t n)
{
    const uint8_t first = p->coverage[0];
    if (first == 0 || first == 255)
        return pel_smooth_take_alike(p, first, 1);
    while (p->coverage[n - 1] == 0)
        n--;
    p->span.x0 = p->span.x1;
    p->span.x1 += n;
    return n;
}

bool pel_smooth_begin_span(const struct pel_smooth_pixels *p,
                           struct pel_smooth_drawing *d)
{
    if (p->span.x0 >= p->span.x1)
        return false;
    pel_smooth_drawing_set(d, &p->smooth, p->y, &p->span);
    return p->coverage[0] == 255 || pel_smooth_drawing_begin(d, &p->smooth);
}

void pel_smooth_end_span(struct pel_smooth_pixels *p,
                         struct pel_smooth_drawing *d)
{
    if (p->coverage[0] < 255)
        pel_smooth_drawing_end(d, p->coverage);
    p->coverage[0] = 255;
}

#if PEL_SMOOTH_TINY

static PEL_NOINLINE void paint_flat(const struct pel_smooth *smooth, int32_t y,
                                    const struct pel_span *span,
                                    const uint8_t *coverage)
{
    const struct pel_surface *const target = smooth->target;
    const int32_t n = span->x1 - span->x0;
    pel_color colors[PEL_SMOOTH_PIXELS];
    pel_smooth_set_colors(colors, n, pel_smooth_flat(smooth)->color);
    weigh(colors, n, coverage);
    if (target->format)
        target->format->put(target, span->x0, y, n, colors);
}

static PEL_NOINLINE void paint_colors(const struct pel_smooth *smooth,
                                      int32_t y, const struct pel_span *span,
                                      const uint8_t *coverage)
{
    struct pel_smooth_drawing d;
    pel_smooth_draw(&d, smooth, y, span, coverage);
}

/* The next pixels whose coverage is not 0, from the ith byte on, among those
 * before the full ones or those behind them: where their bytes begin. */
static PEL_NOINLINE int32_t next_pixels(const struct pel_smooth_row *row,
                                        int32_t i, struct pel_span *span)
{
    const int32_t left = row->left, all = left + row->right;
    while (i < all && row->coverage[i] == 0)
        i++;
    const int32_t x = row->x + i + (i < left ? 0 : row->full);
    int32_t n = pel_min((i < left ? left : all) - i, PEL_SMOOTH_PIXELS);
    while (n > 0 && row->coverage[i + n - 1] == 0)
        n--;
    *span = (struct pel_span){x, x + n};
    return i;
}

void pel_smooth_paint(const struct pel_smooth *smooth,
                      const struct pel_smooth_row *row)
{
    const int32_t x = row->x + row->left;
    struct pel_span span = {x, x + row->full};
    pel_smooth_paint_full(smooth, row->y, 1, &span);
    for (int32_t i = 0;; i += span.x1 - span.x0) {
        i = next_pixels(row, i, &span);
        if (span.x0 == span.x1)
            return;
        if (pel_smooth_flat(smooth))
            paint_flat(smooth, row->y, &span, row->coverage + i);
        else
            paint_colors(smooth, row->y, &span, row->coverage + i);
    }
}

void pel_smooth_paint_batch(const struct pel_smooth *smooth,
                            const struct pel_smooth_batch *b)
{
    const struct pel_span *const full = b->at.full;
    const struct pel_smooth_row row = {b->y,        full->x0 - b->count[0],
                                       b->count[0], full->x1 - full->x0,
                                       b->count[1], b->coverage};
    if (b->n > 0)
        pel_smooth_paint(smooth, &row);
}

#endif

void pel_smooth_clip_batch(struct pel_smooth_batch *b,
                           const struct pel_rect *clip)
{
    const uint8_t *from = b->coverage;
    uint8_t *to = b->coverage;
    for (int32_t i = 0; i < 2 * b->n; i++) {
        const int32_t n = b->count[i];
        const int32_t end = b->at.x[i] + (i & 1 ? n : 0);
        const uint8_t *const kept = to;
        b->at.x[i] = pel_max(clip->x0, pel_min(b->at.x[i], clip->x1));
        for (int32_t x = end - n; x < end; x++, from++)
            if (x >= clip->x0 && x < clip->x1)
                *to++ = *from;
        b->count[i] = (uint8_t)(to - kept);
    }
}
