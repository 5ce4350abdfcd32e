/* Pixel formats: how colors enter and leave memory.
 *
 * A format is a const object in a file of core/format. A surface points to
 * its format, so a program links what it names. The layouts are those of
 * DRM's fourcc list where it has them: the word is little-endian on every CPU
 * (rgb888 is B, G, R in memory), except in rgb565_be. */
#ifndef PEL_BASE_FORMAT_H
#define PEL_BASE_FORMAT_H

#include "color.h"
#include "rect.h"

struct pel_surface;

/* Pixels of one row, half-open; empty when x0 >= x1. */
struct pel_span {
    int32_t x0, x1; /* px, absolute */
};

/* n >= 1 spans, all inside the surface's clip, no pixel twice. Span i lies in
 * row y + i * step: step is 1 (n rows downwards) or 0 (n spans of one row). */
struct pel_spans {
    const struct pel_surface *surface;
    const struct pel_span *span;
    int32_t y;
    int32_t n, step; /* n <= PEL_BATCH_ROWS */
};

/* No two formats of a program have the same id, but for palettes: copies
 * between surfaces of one id take their pixels as they are. Yours are 128..249.
 * Behind them come those of the library that are not plain memory: 250 a window
 * that counts, 251 its counts, 252 blend modes, 253 smooth shapes, 254 masks,
 * 255 dither. */
enum pel_format_id {
    PEL_FORMAT_RGB565_LE = 1, /* 16: R 15..11, G 10..5, B 4..0 */
    PEL_FORMAT_RGB565_BE,     /* the same, high byte first */
    PEL_FORMAT_BGR565_LE,     /* 16: B 15..11, G 10..5, R 4..0 */
    PEL_FORMAT_XRGB1555_LE,   /* 16: X 15, R 14..10, G 9..5, B 4..0 */
    PEL_FORMAT_RGB888,        /* 24: B, G, R in memory */
    PEL_FORMAT_BGR888,        /* 24: R, G, B in memory */
    PEL_FORMAT_XRGB8888,      /* 32: X 31..24, R, G, B 7..0 */
    PEL_FORMAT_XBGR8888,      /* 32: X 31..24, B, G, R 7..0 */
    PEL_FORMAT_RGBX8888,      /* 32: R 31..24, G, B, X 7..0 */
    PEL_FORMAT_BGRX8888,      /* 32: B 31..24, G, R, X 7..0 */
    PEL_FORMAT_RGB332,        /*  8: R 7..5, G 4..2, B 1..0 */
    PEL_FORMAT_GRAY8,         /*  8 */
    PEL_FORMAT_GRAY4,         /*  4: left pixel in the high half of the byte */
    PEL_FORMAT_MONO1,         /*  1: left pixel in the high bit */
    PEL_FORMAT_MONO1_PAGES,   /*  1: a byte is 8 rows of a column, top in bit 0;
                                  a surface's stride is that of a page of rows,
                                  its top row a multiple of 8 */
    PEL_FORMAT_ARGB8888,      /* 32: A 31..24, R, G, B 7..0: a source with alpha
                                  (format/argb8888.h), not a display's format */
    PEL_FORMAT_PALETTE4,      /*  4, 8: indices of colors (format/palette.h), */
    PEL_FORMAT_PALETTE8,      /*  sources too; as gray4 in memory */
    PEL_FORMAT_INKS2,         /*  2: white, black, red, yellow, of e-paper; left
                                  pixel in the high bits. Takes the nearest in
                                  RGB, of two the first */
    PEL_FORMAT_GRAY2          /*  2: left pixel in the high bits */
};

/* A row of the dither's matrix: 8 places for channels of 1 bit, 8 for 2 bits,
 * up to 7. */
typedef uint8_t pel_thresholds[7 * 8];

/* Blue, green and red in 8.24, modulo 2^32: of the first pixel of a row, and
 * from each to the next. */
struct pel_planes {
    uint32_t at[3], dx[3];
};

/* A color of a gradient: the upper bytes of four sums, of alpha and green, and
 * of red and blue, in the halves of words, which change from cell to cell. */
struct pel_mix {
    uint32_t high, low, high_change, low_change;
};

/* Steps from pixel to pixel through the cells of a gradient of mixed colors.
 * Each pixel adds `step` to the error. Where the error is 0 or more the cell
 * ends, and cell + cell_remainder / unit is subtracted from it. Cells are less
 * than 7 px wide. */
struct pel_walk {
    struct pel_mix mix;
    int32_t error, remainder, cell, cell_remainder, unit, step;
};

/* Functions that a format may have for dither, Gouraud and textures. */
struct pel_channels {
    /* Required for grey whose pixels share bytes; NULL elsewhere. Grey c of n
     * bits shows level ((2^n - 1) c + rows[y & 7][8 (n - 1) + (x & 7)]) / 256
     * at (x, y) of `surface`, which is drawn into instead of that of the spans.
     * fill: one opaque color. put: a color for each pixel of the one span, up
     * to the first that is not opaque; returns how many. */
    void (*fill)(const struct pel_surface *surface,
                 const struct pel_spans *spans, pel_color color,
                 const pel_thresholds *rows);
    int32_t (*put)(const struct pel_surface *surface,
                   const struct pel_spans *spans, const pel_color *colors,
                   const pel_thresholds *rows);

    /* Stores n >= 1 opaque pixels whose channels are planes. False: nothing was
     * stored. May be NULL. */
    bool (*planes)(const struct pel_surface *surface, int32_t x, int32_t y,
                   int32_t n, const struct pel_planes *planes);

    /* The same with the colors that a walk steps through. */
    bool (*walk)(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, const struct pel_walk *walk);

    /* For a format that passes its pixels on: the surface that they go to,
     * whose format's pixel values may be handed over as they are. May be NULL.
     */
    const struct pel_surface *(*target)(const struct pel_surface *surface);
};

struct pel_format {
    uint8_t id;   /* enum pel_format_id, or 128..249: a format of your own */
    uint8_t bits; /* of a pixel: 1, 2, 4, 8, 16, 24 or 32 */
    uint8_t word; /* bytes that pixels and stride are a multiple of */

    /* Bits of red, green and blue, 1 to 7, apart from each other in the pixel;
     * {n, 0, 0} where it is n bits of grey; all 0: dither is of no use. */
    uint8_t depth[3];

    /* Color (alpha ignored) to pixel and back (opaque, but for argb8888 and
     * palettes). 8 to n bits truncates, n to 8 replicates: pack(unpack(p)) == p
     * for every p that pack makes. Unused bits (X) are set, and ignored. A
     * pixel is the word as the CPU reads it from memory: on a little-endian one
     * that of rgb565_be has its bytes swapped. */
    uint32_t (*pack)(pel_color color);
    pel_color (*unpack)(uint32_t pixel);

    /* One opaque pixel value into every span. */
    void (*fill)(const struct pel_spans *spans, uint32_t pixel);

    /* The color over every span, weighted by its alpha, which is below 255; 0
     * leaves every bit as it is. NULL, like unpack, put and load, in the
     * fill-only formats pel_rgb565_le_fill and pel_rgb565_be_fill: paints that
     * need them draw nothing there. */
    void (*blend)(const struct pel_spans *spans, pel_color color);

    /* n >= 1 colors over the pixels (x, y) to (x + n - 1, y) of the surface,
     * each weighted by its alpha: 255 stores it, 0 leaves the pixel untouched,
     * the others are pel_mix'ed. load gives what unpack makes of each pixel. */
    void (*put)(const struct pel_surface *surface, int32_t x, int32_t y,
                int32_t n, const pel_color *colors);
    void (*load)(const struct pel_surface *surface, int32_t x, int32_t y,
                 int32_t n, pel_color *colors);

    const struct pel_channels *channels; /* NULL: none of this */
};

#endif
