/* Paints that compute a color for every pixel: textures, and what a program
 * adds of its own.
 *
 * Such a paint gives one function, from absolute x and y to colors; this file
 * hands it runs of pixels and takes the colors to any format, opaque or
 * blended. A paint of one's own is
 *
 *     static void stripes(const struct pel_color_paint *paint, int32_t x,
 *                         int32_t y, int32_t n, pel_color *colors);
 *     static const struct pel_color_paint striped =
 *         PEL_COLOR_PAINT(stripes, true);
 *     pel_circle(&surface, center, radius, &striped.paint);
 *
 * or a struct that begins with a struct pel_color_paint, for one that needs
 * more (examples/user_paint.c). */
#ifndef PEL_PAINT_PAINT_COLORS_H
#define PEL_PAINT_PAINT_COLORS_H

#include "../format/word.h"
#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_color_paint;

/* The colors of pixels (x, y) to (x + n - 1, y), n >= 1, each at the pixel's
 * centre. Must be a function of the pixel alone: a run may come in any parts.
 * Where the surface's pixels are such colors, `colors` is the surface. */
typedef void pel_colors_function(const struct pel_color_paint *paint, int32_t x,
                                 int32_t y, int32_t n, pel_color *colors);

struct pel_color_paint {
    struct pel_paint paint;
    pel_colors_function *colors;
    bool opaque; /* all colors have alpha 255: nothing is blended */
};

#define PEL_COLOR_PAINT(colors, opaque)                           \
    {                                                             \
        PEL_PAINT(pel_color_paint_fill, NULL), (colors), (opaque) \
    }

/* Are opaque colors the surface's pixels themselves? In xrgb8888 on a
 * little-endian CPU. Not where code is to be small: that format is rare
 * there. */
static inline bool pel_colors_in_place(const struct pel_color_paint *paint,
                                       const struct pel_surface *surface)
{
    return !PEL_SMALL_CODE && paint->opaque &&
           surface->format->id == PEL_FORMAT_XRGB8888 &&
           PEL_LE32(UINT32_C(1)) == 1;
}

/* The fill function of all of them. */
void pel_color_paint_fill(const struct pel_paint *paint,
                          const struct pel_spans *spans);

/* For init functions. */
static inline void pel_color_paint_init(struct pel_color_paint *paint,
                                        pel_colors_function *colors,
                                        bool opaque)
{
    const struct pel_paint fill = PEL_PAINT(pel_color_paint_fill, NULL);
    paint->paint = fill;
    paint->colors = colors;
    paint->opaque = opaque;
}
PEL_END_DECLS
#endif
