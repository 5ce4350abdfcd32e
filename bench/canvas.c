#define _POSIX_C_SOURCE 200809L
#include "canvas.h"

#include <stdlib.h>
#include <string.h>

bool canvas_open(struct canvas *c, int width, int height, int bits)
{
    void *memory;
    *c = (struct canvas){NULL, width, height, bits, width * bits / 8};
    if (posix_memalign(&memory, 4096, canvas_bytes(c)))
        return false;
    c->pixels = memory;
    memset(c->pixels, 0, canvas_bytes(c));
    return true;
}

void canvas_close(struct canvas *c)
{
    free(c->pixels);
    c->pixels = NULL;
}

void canvas_clear(const struct canvas *c, const struct box *box)
{
    size_t bytes =
        (size_t)(canvas_address(c, box->x1, 0) - canvas_address(c, box->x0, 0));
    for (int y = box->y0; y < box->y1; y++)
        memset(canvas_address(c, box->x0, y), 0, bytes);
}

static uint8_t green(const struct canvas *c, const uint8_t *p)
{
    uint32_t word = 0;
    memcpy(&word, p, (size_t)c->bits / 8);
    return (uint8_t)(c->bits == 32 ? word >> 8
                                   : (word >> 5 & 63) << 2 | (word >> 9 & 3));
}

long canvas_mask(const struct canvas *c, const struct box *box, uint8_t *mask)
{
    long n = 0;
    for (int y = box->y0; y < box->y1; y++) {
        const uint8_t *p = canvas_address(c, box->x0, y);
        for (int x = box->x0; x < box->x1; x++, p += c->bits / 8) {
            *mask = green(c, p);
            n += *mask++ != 0;
        }
    }
    return n;
}
