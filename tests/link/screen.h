/* The little screen that the smallest programs draw on: 64 x 64 pixels of
 * RGB565, in a const surface. */
#ifndef TESTS_LINK_SCREEN_H
#define TESTS_LINK_SCREEN_H

#include "core/pel.h"

enum { SCREEN_SIDE = 64 };

static uint16_t pixels[SCREEN_SIDE * SCREEN_SIDE];

#define SCREEN(format_of_pixels)                     \
    {                                                \
        .pixels = pixels, .stride = SCREEN_SIDE * 2, \
        .bounds = {0, 0, SCREEN_SIDE, SCREEN_SIDE},  \
        .clip = {0, 0, SCREEN_SIDE, SCREEN_SIDE},    \
        .format = &(format_of_pixels),               \
    }

#endif
