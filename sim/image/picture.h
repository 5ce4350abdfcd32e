/* Pictures in memory, and the files they come from and go to. */
#ifndef SIM_IMAGE_PICTURE_H
#define SIM_IMAGE_PICTURE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "core/base/color.h"

/* Rows from the top, no padding, 0xAARRGGBB. The pixels are malloc'ed and owned
 * by the picture. */
struct picture {
    int width, height;
    pel_color *pixels;
};

enum {
    PICTURE_SIZE_MAX = 32767,    /* px each way */
    PICTURE_PIXELS_MAX = 1 << 28 /* in all: 1 GB */
};

bool picture_size_legal(int width, int height);

/* The same; false with a message, that names `path` unless it is NULL. */
bool picture_size_check(const char *path, int64_t width, int64_t height);

/* A picture of one color. False, with a message on standard error, when the
 * size is out of range or memory is short; the picture is then empty, as
 * picture_free leaves it. */
bool picture_init(struct picture *picture, int width, int height,
                  pel_color color);

/* Frees the pixels; an empty picture ({0}) may be freed too. */
void picture_free(struct picture *picture);

static inline pel_color *picture_row(const struct picture *picture, int y)
{
    return picture->pixels + (size_t)y * (size_t)picture->width;
}

/* Reads a PPM, PGM, PBM or PAM file (one picture) from a stream; `name` is that
 * of messages. Memory grows with the data that is really there, so a header
 * that lies costs nothing. False, with a message on standard error that names
 * file, line (text) or byte (binary), what is wrong and what is expected; the
 * picture is then empty. */
bool picture_read_ppm(struct picture *picture, FILE *file, const char *name);

/* Writes the picture, alpha left out, in the format of the ending of `path`:
 * .ppm (P6), .bmp (24 bits), .png (needs libpng at build time); "-" is PPM on
 * standard output. The file appears whole or not at all. False, with a message
 * on standard error, when that failed. */
bool picture_save(const struct picture *picture, const char *path);

/* Rows that are made while they are written, from the top or from the bottom.
 */
struct picture_rows {
    int width, height;
    void (*row)(const void *context, int y, pel_color *row);
    const void *context;
};

/* The same of such a picture. */
bool picture_save_rows(const struct picture_rows *rows, const char *path);

/* True when picture_save writes the ending of `path`; false with a message.
 * Commands call it before they start. */
bool picture_path_check(const char *path);

/* True when the name ends as one of `endings`, " .ppm .pgm ", in any case. */
bool path_has_ending(const char *path, const char *endings);

/* The best compressed ending that this build writes: ".png", or ".bmp" where
 * libpng was missing. */
const char *picture_best_ending(void);

#endif
