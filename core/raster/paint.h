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
    void (*fill)(const struct pel_paint *paint, const struct pel_rows *rows);

    /* May colour a whole triangle that is not clipped, in its own row loop
     * (raster/fast_triangle.h); false when it did nothing. May be NULL. */
    bool (*fast)(const struct pel_paint *paint,
                 const struct pel_surface *surface,
                 const struct pel_fast_triangle *triangle);
};

/* One colour. Alpha 255 stores it, 0 draws nothing, any other value blends it
 * over what is there (pel_mix). A const struct in flash will do:
 *     static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0)); */
struct pel_flat {
    struct pel_paint paint;
    pel_color color;
};

#define PEL_FLAT(color)                         \
    {                                           \
        {pel_flat_fill, PEL_FLAT_FAST}, (color) \
    }

void pel_flat_fill(const struct pel_paint *paint, const struct pel_rows *rows);

#if PEL_FAST_64BIT
#define PEL_FLAT_FAST pel_flat_fast
bool pel_flat_fast(const struct pel_paint *paint,
                   const struct pel_surface *surface,
                   const struct pel_fast_triangle *triangle);
#else
#define PEL_FLAT_FAST NULL
#endif

/* For fill functions: n colours, 1 <= n <= PEL_BUFFER_PIXELS, onto the pixels
 * from (x, y) on, each weighted by its own alpha. */
void pel_put_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                    int32_t n, const pel_color *colors);

#endif
