/* Pictures of fewer colours: palettes, and dither. */
#ifndef SIM_IMAGE_REDUCE_H
#define SIM_IMAGE_REDUCE_H

#include "core/base/format.h"
#include "sim/image/picture.h"

enum picture_dither {
    PICTURE_DITHER_NONE,
    PICTURE_DITHER_ORDERED,  /* the 8 x 8 matrix of pel_dither */
    PICTURE_DITHER_DIFFUSION /* Floyd and Steinberg, rows to and fro */
};

/* What pictures are reduced to: the levels of a format, by its `depth`, or a
 * palette. */
struct picture_levels {
    const struct pel_format *format; /* NULL: the palette */
    const pel_color *palette;
    int colors;
};

/* Colours of the picture that stand for all, 256 at most; fewer where it has no
 * more. Clear ones are one, 0. How many there are; 0, with a message, when
 * memory is short. */
int picture_palette(const struct picture *picture, int most,
                    pel_color palette[256]);

/* Replaces every colour. Alpha of a palette is its own, of a format it stays.
 * False, with a message, when memory is short. */
bool picture_reduce(struct picture *picture,
                    const struct picture_levels *levels,
                    enum picture_dither dither);

#endif
