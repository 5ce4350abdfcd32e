/* The panel of the examples: a PPM file on standard output. */
#ifndef EXAMPLES_PPM_H
#define EXAMPLES_PPM_H

#include <stdio.h>

#include <pel/pel.h>

/* The rows of a surface; on a board these bytes leave over SPI as they are. */
static inline void ppm_write(const struct pel_surface *s)
{
    for (int32_t y = s->clip.y0; y < s->clip.y1; y++)
        for (int32_t x = s->clip.x0; x < s->clip.x1; x++) {
            pel_color color;
            s->format->load(s, x, y, 1, &color);
            putchar((int)pel_red(color));
            putchar((int)pel_green(color));
            putchar((int)pel_blue(color));
        }
}

#endif
