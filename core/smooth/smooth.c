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

#if PEL_SMOOTH_TINY

/* Colors that are weighed at a time. */
enum { COLORS = PEL_SMALL_CODE ? 4 : 8 };

/* Into colors that are 0. */
static PEL_NOINLINE_32 void take_colors(const struct pel_smooth *smooth,
                                        const struct pel_span *span, int32_t y,
                                        pel_color *colors)
{
    struct pel_smooth_surface buffer;
    const struct pel_spans spans = {&buffer.surface, span, y, 1, 0};
    pel_smooth_buffer_set(&buffer, smooth->target, span, y, colors);
    smooth->paint->fill(smooth->paint, &spans);
}

/* In parts without pixels of 0 at their ends. Inlined into two functions, for
 * less stack. */
static PEL_ALWAYS_INLINE void paint_row(const struct pel_smooth *smooth,
                                        const struct pel_smooth_row *row)
{
    const struct pel_flat *const flat = pel_smooth_flat(smooth);
    const struct pel_surface *const target = smooth->target;
    const uint8_t *const coverage = row->coverage;
    const int32_t left = row->left, all = left + row->right;
    struct pel_span part = {row->x + left, row->x + left + row->full};
    pel_color colors[COLORS];
    pel_smooth_paint_full(smooth, row->y, 1, &part);
    for (int32_t i = 0, n; i < all; i += n) {
        n = 1;
        if (coverage[i] == 0)
            continue;
        n = pel_min((i < left ? left : all) - i, COLORS);
        while (coverage[i + n - 1] == 0)
            n--;
        part.x0 = row->x + i + (i < left ? 0 : row->full);
        part.x1 = part.x0 + n;
        pel_smooth_set_colors(colors, n, flat ? flat->color : 0);
        if (!flat)
            take_colors(smooth, &part, row->y, colors);
        pel_smooth_weigh(colors, n, coverage + i);
        if (target->format)
            target->format->put(target, part.x0, row->y, n, colors);
    }
}

void pel_smooth_paint(const struct pel_smooth *smooth,
                      const struct pel_smooth_row *row)
{
    paint_row(smooth, row);
}

void pel_smooth_paint_batch(const struct pel_smooth *smooth,
                            const struct pel_smooth_batch *b)
{
    const struct pel_span *const full = b->at.full;
    const struct pel_smooth_row row = {b->y,        full->x0 - b->count[0],
                                       b->count[0], full->x1 - full->x0,
                                       b->count[1], b->coverage};
    if (b->n > 0)
        paint_row(smooth, &row);
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
