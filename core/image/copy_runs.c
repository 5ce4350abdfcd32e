#include "copy_runs.h"

#include <string.h>

#include "../format/word.h"
#include "../raster/paint.h"

/* A copy, and the row that is drawn. */
struct copy {
    const struct pel_surface *surface;
    int32_t y;
    struct pel_span visible;  /* px of the surface, not empty */
    struct pel_surface words; /* those behind a count, as a row */
    int32_t bytes, pixels;    /* of a word */
    uint32_t alpha;
    bool as_they_are; /* pixels are those of the surface in memory */
};

/* The colors of the words' pixels from x on, weighed. */
static void load(const struct copy *c, int32_t x, int32_t n, pel_color *colors)
{
    c->words.format->load(&c->words, x, 0, n, colors);
    for (int32_t i = 0; i < n && c->alpha < 255; i++)
        colors[i] = pel_weighed(colors[i], c->alpha);
}

/* All pixels of the span get the color of the first of the words: of the usual
 * screens by its value. */
static void put_run(const struct copy *c, const struct pel_span *span)
{
    const struct pel_spans spans = {c->surface, span, c->y, 1, 1};
    pel_color color;
    if (c->as_they_are && c->bytes == 2) {
        c->surface->format->fill(&spans, *(const pel_word16 *)c->words.pixels);
        return;
    }
    load(c, c->words.bounds.x0, 1, &color);
    if (pel_alpha(color) != 0)
        pel_fill_color(&spans, color);
}

static PEL_NOINLINE void put_words(const struct copy *c, struct pel_span span)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    for (int32_t n; span.x0 < span.x1; span.x0 += n) {
        n = pel_min(span.x1 - span.x0, PEL_BUFFER_PIXELS);
        load(c, span.x0, n, colors);
        pel_put_colors(c->surface, span.x0, c->y, n, colors);
    }
}

static void copy_words(const struct copy *c, const struct pel_span *span)
{
    const int32_t at = (span->x0 - c->words.bounds.x0) * c->bytes;
    memcpy((void *)pel_address(c->surface, span->x0, c->y, c->bytes),
           (const uint8_t *)c->words.pixels + at,
           (size_t)((span->x1 - span->x0) * c->bytes));
}

static void put(const struct copy *c, const struct pel_span *span, bool is_run)
{
    if (span->x0 >= span->x1)
        return;
    if (is_run)
        put_run(c, span);
    else if (c->as_they_are)
        copy_words(c, span);
    else
        put_words(c, *span);
}

/* Draws a row of `left` words. x is below 2^17, and grows by 32,767 at most. */
static void copy_row(struct copy *c, const uint8_t *p, uint32_t left)
{
    const int32_t bytes = c->bytes;
    for (int32_t x = c->words.bounds.x0, end; x < c->visible.x1 && left > 0;
         x = end) {
        const uint32_t count = p[0] | (bytes > 1 ? (uint32_t)p[1] << 8 : 0);
        const uint32_t n = count & 1 ? 1 : count >> 1;
        if (count < 2 || n >= left)
            return;
        end = x + (int32_t)(count >> 1) * c->pixels;
        const struct pel_span span = {pel_max(x, c->visible.x0),
                                      pel_min(end, c->visible.x1)};
        p += bytes;
        c->words.pixels = (void *)(uintptr_t)p;
        c->words.bounds.x0 = x;
        put(c, &span, count & 1);
        p += (int32_t)n * bytes;
        left -= n + 1;
    }
}

/* A format of a program's own keeps pixels in a way of its own. */
static bool same_pixels(const struct pel_format *a, const struct pel_format *b)
{
    return a->id == b->id && a->id < 128 && a->bits >= 8 && a->pack(0) == 0;
}

void pel_copy_runs(const struct pel_surface *surface,
                   const struct pel_runs_part *copy, uint8_t alpha)
{
    const struct pel_runs_asset *const s = copy->source;
    const struct pel_format *const f = copy->format;
    const bool legal = pel_offset_legal(copy->x, copy->y);
    PEL_ASSERT(legal);
    if (!legal)
        return;
    struct pel_rect r = {copy->x, copy->y, copy->x + s->width,
                         copy->y + s->height};
    struct copy c = {.surface = surface,
                     .words = {NULL, 0, r, r, f},
                     .bytes = f->bits / 8,
                     .pixels = 1,
                     .alpha = alpha};
    if (f->bits < 8) {
        c.bytes = 1;
        c.pixels = 8 >> (f->bits >> 1);
    }
    r = pel_rect_intersect(&r, &surface->clip);
    if (pel_rect_empty(&r))
        return;
    c.as_they_are = alpha == 255 && same_pixels(f, surface->format);
    c.visible = (struct pel_span){r.x0, r.x1};
    for (c.y = r.y0; c.y < r.y1; c.y++) {
        const int32_t y = c.y - copy->y;
        const uint32_t at = s->rows16 ? s->rows16[y] : s->rows32[y];
        c.words.bounds.x0 = copy->x;
        if (at < s->size)
            copy_row(&c, (const uint8_t *)s->words + at * (size_t)c.bytes,
                     s->size - at);
    }
}
