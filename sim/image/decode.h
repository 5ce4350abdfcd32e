/* Readers of picture files whose bytes are in memory, for the child process
 * that reads one file (sim/cli/child.h): what they leave behind ends with it.
 * Each makes `picture` and returns true, or false, with a message. */
#ifndef SIM_IMAGE_DECODE_H
#define SIM_IMAGE_DECODE_H

#include "sim/image/picture.h"

struct encoded {
    const char *name; /* of the file, for messages */
    const uint8_t *bytes;
    size_t size;
};

/* Exact: grey and colours with tRNS at every depth, all interlacings; 16 bits
 * are round(v 255 / 65,535). Chunks of gamma and profiles change nothing. */
bool decode_png(struct picture *picture, const struct encoded *from);

/* Upright, as its EXIF data says; of CMYK and YCCK the product of ink and
 * black. */
bool decode_jpeg(struct picture *picture, const struct encoded *from);

/* All that Windows writes but pictures of JPEG and PNG: 1, 2, 4, 8, 16, 24 and
 * 32 bits, any masks, RLE, from either end. Channels of less than 8 bits are
 * repeated, as in core; pixels that RLE leaves out are clear. Without a mask
 * alpha is 255. */
bool decode_bmp(struct picture *picture, const struct encoded *from);

/* Their palettes: how many colours; 0 where there is none; -1 with a message.
 */
int decode_png_palette(const struct encoded *from, pel_color palette[256]);
int decode_bmp_palette(const struct encoded *from, pel_color palette[256]);

/* The error of a file that is cut short. False. */
bool decode_refuse_end(const struct encoded *from);

#endif
