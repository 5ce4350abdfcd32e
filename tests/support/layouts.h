/* Pixel formats as their specification has them, written independently of
 * core. A pixel is the number that its bytes in memory make, the first byte
 * lowest; of packed formats, its bits. */
#ifndef TESTS_SUPPORT_LAYOUTS_H
#define TESTS_SUPPORT_LAYOUTS_H

#include "core/pel.h"

struct layout {
    const char *name;
    const struct pel_format *format;
    int bits;
    bool gray, swapped;            /* swapped: high byte first in memory */
    int red[2], green[2], blue[2]; /* lowest bit, bits */
    uint32_t unused;               /* X bits, written as ones */
    bool inks;                     /* indices of four colors instead */
};

enum { LAYOUT_COUNT = 17 };
extern const struct layout layouts[LAYOUT_COUNT];

const struct layout *layout_of(const struct pel_format *format);
uint32_t layout_pack(const struct layout *l, pel_color color);
pel_color layout_unpack(const struct layout *l, uint32_t pixel);

/* Source over: round((s a + d (255 - a)) / 255) per channel, opaque. */
pel_color layout_mix(pel_color d, pel_color s, uint32_t a);

/* What a pixel becomes when `color` is drawn over it with its own alpha. */
uint32_t layout_over(const struct layout *l, uint32_t pixel, pel_color color);

/* Bounds from (0, 0) on; the test fails when core refuses them. */
struct pel_surface surface_of(const struct pel_format *format, void *memory,
                              size_t size, int32_t width, int32_t height);

#endif
