/* Texture files, and the color of a point of one. */
#ifndef SIM_IMAGE_TEXTURE_H
#define SIM_IMAGE_TEXTURE_H

#include "sim/image/picture.h"

/* Reads the picture at `path`: PNG, JPEG, BMP, PPM, PGM, PBM and PAM, exactly,
 * as sim/image/decode.h says; TGA, GIF and whatever else it knows by
 * SDL2_image. False, with a message on standard error, when the file is wrong
 * or this build has no reader; the picture is then empty. */
bool texture_load(struct picture *picture, const char *path);

/* The same from a file's bytes in memory; `name` is for the message. */
bool texture_load_bytes(struct picture *picture, const char *name,
                        const void *bytes, size_t size);

/* The colours of the palette of a PNG or BMP file, in its order. How many; 0,
 * with a message, when it has none. */
int texture_load_palette(const char *path, pel_color palette[256]);

/* True when all texels have alpha 255. */
bool texture_opaque(const struct picture *picture);

/* The texel at column floor(u W), row floor(v H), repeated outside 0..1;
 * opaque. */
pel_color texture_at(const struct picture *picture, double u, double v);

#endif
