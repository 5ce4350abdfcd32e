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
    PEL_BLEND_XOR,     /* d ^ s: white inverts. An opaque paint twice brings
                          back each color in the formats of red, green and
                          blue; a grey one in those of grey. Not in inks. */
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

/* The source may be any paint but a blend, and must live as long as this one.
 * It sees a surface of another format, of id 252: so code that is written for
 * one format is not used under a blend. To dither, put the dither around this
 * paint: as its source it does nothing. A mask is a source; around this paint
 * it draws nothing. Nothing is drawn in formats that cannot be read (the _fill
 * ones) or drawn into (palettes) either: broken contracts. PEL_ERROR_NULL,
 * PEL_ERROR_RANGE (the source is this paint; the mode). */
enum pel_status pel_blend_init(struct pel_blend *paint,
                               const struct pel_paint *source,
                               enum pel_blend_mode mode);
PEL_END_DECLS
#endif
