/* One file per picture format; picture.c chooses by the ending. Only for
 * picture*.c. */
#ifndef SIM_IMAGE_PICTURE_FILE_H
#define SIM_IMAGE_PICTURE_FILE_H

#include <stdio.h>

#include "sim/image/picture.h"

/* Reads a PPM or PGM; `name` is for messages. */
bool picture_read_ppm(struct picture *picture, FILE *file, const char *name);

/* The first three channels of row y as bytes, red first. */
void picture_bytes(const struct picture *picture, int y, unsigned char *to);

/* Write to a stream that holds the file in memory; false when a library
 * refuses. Errors of the stream are the caller's to check. */
bool picture_write_ppm(const struct picture *picture, FILE *file);
bool picture_write_bmp(const struct picture *picture, FILE *file);
#ifdef HAVE_LIBPNG
bool picture_write_png(const struct picture *picture, FILE *file);
#endif

#endif
