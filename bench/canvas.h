/* The memory that all methods draw into, one after the other. */
#ifndef BENCH_CANVAS_H
#define BENCH_CANVAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct canvas {
    uint8_t *pixels;   /* owned; aligned to a page */
    int width, height; /* px */
    int bits;          /* of a pixel: 32 (XRGB8888) or 16 (RGB565) */
    int stride;        /* bytes, without padding */
};

static inline size_t canvas_bytes(const struct canvas *c)
{
    return (size_t)c->stride * (size_t)c->height;
}

/* Where pixel (x, y) lies. */
static inline uint8_t *canvas_address(const struct canvas *c, int x, int y)
{
    return c->pixels + (ptrdiff_t)y * c->stride + x * c->bits / 8;
}

/* All black; false when memory is short. */
bool canvas_open(struct canvas *c, int width, int height, int bits);
void canvas_close(struct canvas *c);

/* Pixels [x0, x1) x [y0, y1), inside the canvas. */
struct box {
    int x0, y0, x1, y1;
};

/* Makes the box black. */
void canvas_clear(const struct canvas *c, const struct box *box);

/* mask[i] = green of the i-th pixel of the box, row by row, 0 to 255: every
 * color that is drawn has some. Returns how many have. */
long canvas_mask(const struct canvas *c, const struct box *box, uint8_t *mask);

#endif
