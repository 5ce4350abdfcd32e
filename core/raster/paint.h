/* Paints: what colours the pixels of a shape.
 *
 * A paint is a const struct whose first member is a struct pel_paint; shapes
 * hand it their rows, and it colours them as a function of absolute x and y
 * alone. It has no state, so one paint serves any number of shapes, threads
 * and bands, and it may live in flash. A program adds a paint of its own by
 * writing a fill function (examples/user_paint.c). */
#ifndef PEL_RASTER_PAINT_H
#define PEL_RASTER_PAINT_H

#include "../base/surface.h"
#include "../pel_config.h"

struct pel_paint;
struct pel_fast_triangle;

struct pel_paint {
    /* Colours every run of `rows`. Required. */
    void (*fill)(const struct pel_paint *paint, const struct pel_spans *spans);

    /* May colour a whole triangle that is not clipped, in its own row loop
     * (raster/fast_triangle.h); false when it did nothing. May be NULL, and is
     * not called where PEL_FAST_64BIT is 0. */
    bool (*fast)(const struct pel_paint *paint,
                 const struct pel_surface *surface,
                 const struct pel_fast_triangle *triangle);
};

/* Initialiser of a paint with both functions; the second is linked only where
 * it is called. */
#if PEL_FAST_64BIT
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

/* One colour. Alpha 255 stores it, 0 draws nothing, any other value blends it
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

void pel_flat_fill(const struct pel_paint *paint,
                   const struct pel_spans *spans);

bool pel_flat_fast(const struct pel_paint *paint,
                   const struct pel_surface *surface,
                   const struct pel_fast_triangle *triangle);

/* For fill functions: n >= 1 colours over the pixels from (x, y) on, each
 * weighted by its own alpha. A fill-only twin cannot: a broken contract. */
static inline void pel_put_colors(const struct pel_surface *surface, int32_t x,
                                  int32_t y, int32_t n, const pel_color *colors)
{
    PEL_ASSERT(surface->format->put);
    if (surface->format->put)
        surface->format->put(surface, x, y, n, colors);
}

#endif
