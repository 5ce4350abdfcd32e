/* Canvases: a surface with memory of its own, of any format, drawn whole or in
 * bands. */
#ifndef SIM_IMAGE_CANVAS_H
#define SIM_IMAGE_CANVAS_H

#include "core/base/surface.h"
#include "sim/image/picture.h"

struct canvas {
    struct pel_surface surface;
    void *memory; /* malloc'ed */
};

/* Black pixels 0..width, 0..height, packed. False, with a message on standard
 * error, when the size is not that of a legal picture or memory is short. */
bool canvas_init(struct canvas *canvas, const struct pel_format *format,
                 int width, int height);

void canvas_free(struct canvas *canvas);

/* The pixels of the surface as a new picture, read with format->load. */
bool canvas_picture(const struct canvas *canvas, struct picture *picture);

/* The same, written to a file. */
bool canvas_save(const struct canvas *canvas, const char *path);

/* Draws onto a surface whose clip is the whole surface. */
typedef void canvas_draw_function(struct pel_surface *surface, void *context);

/* True when bands of `rows` rows are possible: 0 (no bands), or rows >= 1, and
 * a multiple of 8 for mono1_pages. */
bool canvas_bands_legal(const struct pel_format *format, int rows);

/* Calls draw once for the canvas (rows = 0), or once for each band of `rows`
 * rows from the top: a surface of its own, with its absolute bounds. False,
 * with a message, when such bands are not possible. */
bool canvas_draw(struct canvas *canvas, int rows, canvas_draw_function *draw,
                 void *context);

#endif
