/* A surface in fenced memory: a guard page on both sides, poisoned padding, and
 * pixels that hold noise. canvas_check() finds every write outside the clip. */
#ifndef TESTS_SUPPORT_CANVAS_H
#define TESTS_SUPPORT_CANVAS_H

#include "hits.h"
#include "layouts.h"

enum canvas_style {
    CANVAS_UP = 1,     /* negative stride, where the format has it */
    CANVAS_PADDED = 2, /* lines are longer than their pixels */
    CANVAS_AT_END = 4, /* the memory ends at the guard page, not begins there */
    CANVAS_STYLES = 8
};

/* Start with all zero; static: may be opened again and again, and are
 * never closed. */
struct canvas {
    struct pel_surface surface;
    const struct layout *layout;
    uint8_t *map; /* guard page, memory, guard page */
    size_t map_size;
    uint8_t *memory, *before; /* of the lines; as they were when opened */
    size_t size, first;       /* bytes; where the line of bounds.y0 begins */
};

/* The noise is a function of absolute x and y: every canvas that shows a pixel
 * starts with the same value there. */
void canvas_open(struct canvas *c, const struct pel_format *format,
                 const struct pel_rect *bounds, unsigned style);

uint32_t canvas_pixel(const struct canvas *c, int32_t x, int32_t y);
uint32_t canvas_pixel_before(const struct canvas *c, int32_t x, int32_t y);

/* Gives every pixel of `c` the value that the pixel at the same place from the
 * top left has in `from`, as if it had been opened so. */
void canvas_copy(struct canvas *c, const struct canvas *from);

/* Every pixel of both canvases, which have the same size and format, is the
 * same; the test fails with the first difference. */
void canvas_check_same(const struct canvas *a, const struct canvas *b);

/* The largest difference between two of one size, of pixels of 8 bits a
 * channel. */
int32_t canvas_difference(const struct canvas *a, const struct canvas *b);

/* Inside the clip of `part` both have the same pixels at the same places, and
 * canvas_check(part). */
void canvas_check_part(const struct canvas *whole, const struct canvas *part);

/* Checks what was drawn over a canvas: each pixel that `shape` has hit, or each
 * one when it is NULL, holds the function's color, mixed with what was there as
 * its alpha says, and packed; all others are as they were. */
typedef pel_color canvas_color(const void *paint, int32_t x, int32_t y);
void canvas_check_drawn(const struct canvas *c, const struct hits *shape,
                        canvas_color *color, const void *paint);

/* The colors of a pel_flat and of a pel_gouraud. */
pel_color canvas_flat(const void *flat, int32_t x, int32_t y);
pel_color canvas_gouraud(const void *gouraud, int32_t x, int32_t y);

/* Nothing outside the present clip has changed. */
void canvas_check(const struct canvas *c);

#endif
