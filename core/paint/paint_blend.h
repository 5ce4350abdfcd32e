/* Blend modes: any paint, combined with what is on the surface already.
 *
 *     static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
 *     struct pel_blend invert;
 *     pel_blend_init(&invert, &white.paint, PEL_BLEND_XOR);
 *     pel_box(&screen, &cursor, &invert.paint);
 *
 * inverts a box; the same call again brings back what was there. */
#ifndef PEL_PAINT_PAINT_BLEND_H
#define PEL_PAINT_PAINT_BLEND_H

#include "../base/status.h"
#include "../raster/paint.h"

PEL_BEGIN_DECLS

/* What a channel becomes, where d is on the surface, as the format's `load`
 * gives it, and s is that of the paint, both 0..255. */
enum pel_blend_mode {
    PEL_BLEND_XOR,     /* d ^ s: white inverts. Twice changes nothing, whatever
                          the color, in the formats of red, green and blue; in
                          those of grey whatever the grey. Not in inks. */
    PEL_BLEND_ADD,     /* d + s, 255 at most: light on light */
    PEL_BLEND_MULTIPLY /* round(d s / 255): ink on paper */
};

/* The new channels are stored by the rule of all colors, with the alpha of the
 * paint: 255 stores them, 0 leaves the pixel, others mix them over it. The
 * edges of smooth shapes are weighed likewise, so that xor does not bring those
 * back. */
struct pel_blend {
    struct pel_paint paint;
    const struct pel_paint *source;
    enum pel_blend_mode mode;
};

/* The source may be any paint, and must live as long as this one. It draws into
 * a surface like the shape's with another format, of id 252: so it draws
 * through the format's functions alone. A dither goes around this paint, a mask
 * inside of it; the other way round, and in formats that cannot be read (the
 * _fill ones), nothing is drawn or dithered: a broken contract. PEL_ERROR_NULL,
 * PEL_ERROR_RANGE (the source is this paint; the mode). */
enum pel_status pel_blend_init(struct pel_blend *paint,
                               const struct pel_paint *source,
                               enum pel_blend_mode mode);
PEL_END_DECLS
#endif
