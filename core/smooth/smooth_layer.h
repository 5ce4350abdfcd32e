/* The surface before the surface, for the files that paint rows of coverage. */
#ifndef PEL_SMOOTH_SMOOTH_LAYER_H
#define PEL_SMOOTH_SMOOTH_LAYER_H

#include "smooth.h"

/* The format of colors as they are. What is not painted has alpha 0. */
extern const struct pel_format pel_smooth_colors;

/* Sets a buffer for colors, the first of them that of the first pixel of a span
 * in row y; the stride is the caller's to set, if there is more than a row. */
static inline void pel_smooth_buffer_set(struct pel_smooth_surface *buffer,
                                         const struct pel_surface *target,
                                         const struct pel_span *span, int32_t y,
                                         pel_color *colors)
{
    buffer->surface = *target;
    buffer->target = target;
    buffer->surface.format = &pel_smooth_colors;
    buffer->surface.pixels = colors;
    buffer->surface.bounds = (struct pel_rect){span->x0, y, span->x1, y + 1};
}

/* The paint, if it is one color; or NULL. */
static inline const struct pel_flat *pel_smooth_flat(
    const struct pel_smooth *smooth)
{
    const struct pel_paint *const paint = smooth->paint;
    return paint->fill == pel_flat_fill ? (const void *)paint : NULL;
}

/* With alpha = round(alpha coverage / 255). */
static inline pel_color pel_smooth_weighed(pel_color color, uint32_t coverage)
{
    return (color & UINT32_C(0xFFFFFF)) |
           pel_round_div255(pel_alpha(color) * coverage) << 24;
}

static inline void pel_smooth_weigh(pel_color *colors, int32_t n,
                                    const uint8_t *coverage)
{
    for (; n > 0; n--, colors++)
        *colors = pel_smooth_weighed(*colors, *coverage++);
}

static inline void pel_smooth_set_colors(pel_color *colors, int32_t n,
                                         pel_color color)
{
    for (; n > 0; n--)
        *colors++ = color;
}

static inline bool pel_smooth_has_pixels(const struct pel_span *span, int32_t n)
{
    while (n > 0 && span->x0 >= span->x1) {
        span++;
        n--;
    }
    return n > 0;
}

/* The full pixels of n rows. */
static PEL_NOINLINE_32 PEL_UNUSED void pel_smooth_paint_full(
    const struct pel_smooth *smooth, int32_t y, int32_t n,
    const struct pel_span *full)
{
    const struct pel_spans spans = {smooth->target, full, y, n, 1};
    if (pel_smooth_has_pixels(full, n))
        smooth->paint->fill(smooth->paint, &spans);
}

/* What follows is for where PEL_SMOOTH_TINY is 1. Pixels whose colors are
 * weighed at a time. */
enum { PEL_SMOOTH_PIXELS = 4 };

/* What a paint is given to color so many pixels of a row at most. */
struct pel_smooth_drawing {
    struct pel_spans spans;
    struct pel_smooth_surface buffer;
    pel_color colors[PEL_SMOOTH_PIXELS];
};

/* Sets what the paint is given to paint pixels of row y. */
static inline void pel_smooth_drawing_set(struct pel_smooth_drawing *drawing,
                                          const struct pel_smooth *smooth,
                                          int32_t y,
                                          const struct pel_span *span)
{
    drawing->spans = (struct pel_spans){smooth->target, span, y, 1, 0};
}

/* Begins with so many pixels at most, which are to be weighed. False: the paint
 * is one color, and need not be asked. Ends with a coverage each. */
bool pel_smooth_drawing_begin(struct pel_smooth_drawing *drawing,
                              const struct pel_smooth *smooth);
void pel_smooth_drawing_end(struct pel_smooth_drawing *drawing,
                            const uint8_t *coverage);

/* Paints so many pixels of row y, with a coverage each, and full ones. For
 * little stack the paint is called from the frame that has the drawing. */
static PEL_ALWAYS_INLINE void pel_smooth_draw(
    struct pel_smooth_drawing *drawing, const struct pel_smooth *smooth,
    int32_t y, const struct pel_span *span, const uint8_t *coverage)
{
    pel_smooth_drawing_set(drawing, smooth, y, span);
    if (pel_smooth_drawing_begin(drawing, smooth))
        smooth->paint->fill(smooth->paint, &drawing->spans);
    pel_smooth_drawing_end(drawing, coverage);
}

static PEL_ALWAYS_INLINE void pel_smooth_draw_full(
    struct pel_smooth_drawing *drawing, const struct pel_smooth *smooth,
    int32_t y, const struct pel_span *span)
{
    pel_smooth_drawing_set(drawing, smooth, y, span);
    if (span->x0 < span->x1)
        smooth->paint->fill(smooth->paint, &drawing->spans);
}

/* Pixels of a row that are painted next; behind them the row goes on. */
struct pel_smooth_pixels {
    struct pel_smooth smooth;
    int32_t y;
    struct pel_span span;
    uint8_t coverage[PEL_SMOOTH_PIXELS]; /* if the first is 255, so are all */
};

/* Takes from n pixels of a coverage each, where the row goes on, the first one,
 * if that is 0 or 255, or all, up to the last that is not 0: how many. */
int32_t pel_smooth_take_pixels(struct pel_smooth_pixels *pixels, int32_t n);

/* The same of pixels of one coverage. */
int32_t pel_smooth_take_alike(struct pel_smooth_pixels *pixels,
                              uint8_t coverage, int32_t n);

/* Begins to paint the pixels that are taken. False: the paint need not be asked
 * (pel_smooth_fill). Ends; the first time 255 is to be set, as nothing is
 * begun. */
bool pel_smooth_begin_span(const struct pel_smooth_pixels *pixels,
                           struct pel_smooth_drawing *drawing);
void pel_smooth_end_span(struct pel_smooth_pixels *pixels,
                         struct pel_smooth_drawing *drawing);

static inline void pel_smooth_fill(const struct pel_smooth_pixels *pixels,
                                   const struct pel_smooth_drawing *drawing)
{
    pixels->smooth.paint->fill(pixels->smooth.paint, &drawing->spans);
}

#endif
