/* Paints color the pixels of shapes.
 *
 * All shapes: a coordinate, radius or width out of range (base/point.h) is a
 * broken contract: PEL_ASSERT, and nothing is drawn. What lies outside the clip
 * takes no time, but for the set-up of a shape.
 *
 * A paint is a const struct whose first member is a struct pel_paint. Shapes
 * give it their spans, and it colors them as a function of absolute x and y
 * alone. It has no state: one paint serves any number of shapes, threads and
 * bands, and may be in flash. A program adds a paint of its own by a function
 * that gives colors (paint/paint_colors.h), or by a fill function. */
#ifndef PEL_RASTER_PAINT_H
#define PEL_RASTER_PAINT_H

#include "../base/surface.h"
#include "../base/inline.h"

PEL_BEGIN_DECLS

struct pel_paint;
struct pel_fast_triangle;

/* The fill function that draws nothing. */
void pel_nothing_fill(const struct pel_paint *paint,
                      const struct pel_spans *spans);

struct pel_paint {
    /* Colors every span of `spans`. Required. */
    void (*fill)(const struct pel_paint *paint, const struct pel_spans *spans);

    /* Colors a whole triangle that is not clipped, in its own loop over the
     * rows (fast/fast_triangle.h), or returns false and does nothing. May be
     * NULL; not called where PEL_FAST_FILLS is 0. */
    bool (*fast)(const struct pel_paint *paint,
                 const struct pel_surface *surface,
                 const struct pel_fast_triangle *triangle);
};

/* Draws a legal triangle; false when it is clipped or too large. Linked where
 * PEL_FAST_FILLS is 1 (core/fast). */
bool pel_triangle_fast(const struct pel_surface *surface,
                       const struct pel_point v[3],
                       const struct pel_paint *paint);

/* Initialiser of a paint; `fast` is linked only where it is called. */
#if PEL_FAST_FILLS
#define PEL_PAINT(fill, fast) \
    {                         \
        fill, fast            \
    }
#else
#define PEL_PAINT(fill, fast) \
    {                         \
        fill, NULL            \
    }
#endif

/* For init functions that fail: the paint draws nothing. */
static inline void pel_paint_clear(struct pel_paint *paint)
{
    paint->fill = pel_nothing_fill;
    paint->fast = NULL;
}

/* One color. Alpha 255 stores it, 0 draws nothing, any other value blends it
 * over what is there (pel_mix). A const struct in flash will do:
 *     static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0)); */
struct pel_flat {
    struct pel_paint paint;
    pel_color color;
};

#define PEL_FLAT(color)                                  \
    {                                                    \
        PEL_PAINT(pel_flat_fill, pel_flat_fast), (color) \
    }

/* One color by the format's fill, as its pixel value, or by its blend, which
 * fill-only formats do not have: a broken contract. */
static inline void pel_fill_value(const struct pel_spans *spans, uint32_t value,
                                  void (*draw)(const struct pel_spans *,
                                               uint32_t))
{
    PEL_ASSERT(draw);
    if (draw)
        draw(spans, value);
}

static inline void pel_fill_color(const struct pel_spans *spans,
                                  pel_color color)
{
    const struct pel_format *format = spans->surface->format;
    const bool opaque = pel_alpha(color) == 255;
    pel_fill_value(spans, opaque ? format->pack(color) : color,
                   opaque ? format->fill : format->blend);
}

void pel_flat_fill(const struct pel_paint *paint,
                   const struct pel_spans *spans);

bool pel_flat_fast(const struct pel_paint *paint,
                   const struct pel_surface *surface,
                   const struct pel_fast_triangle *triangle);

/* For fill functions: puts n >= 1 colors from (x, y) on, each weighted by its
 * own alpha. Without `put` (fill-only formats) a broken contract. */
static inline void pel_put_colors(const struct pel_surface *surface, int32_t x,
                                  int32_t y, int32_t n, const pel_color *colors)
{
    PEL_ASSERT(surface->format->put);
    if (surface->format->put)
        surface->format->put(surface, x, y, n, colors);
}
PEL_END_DECLS
#endif
