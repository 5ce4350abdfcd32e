/* A paint that counts how often each pixel is painted. A pixel outside the
 * surface's clip fails the test at once, and so does a second hit, unless
 * `limit` allows it. No pixel memory is needed. */
#ifndef TESTS_SUPPORT_HITS_H
#define TESTS_SUPPORT_HITS_H

#include "core/pel.h"

enum { HITS_MAX = 160 * 160 };

struct hits {
    struct pel_paint paint;
    struct pel_surface surface;
    unsigned limit;                 /* of hits on a pixel: 1 */
    uint64_t batches, runs, pixels; /* handed to the paint; runs empty or not */
    uint8_t count[HITS_MAX];        /* row by row over the surface's bounds */
};

/* A surface with these bounds, at most HITS_MAX pixels. */
void hits_open(struct hits *h, const struct pel_rect *bounds);

/* 1 or 0 expected at (x, y)? Compares every pixel inside the clip. */
typedef bool hits_expected(const void *shape, int32_t x, int32_t y);
void hits_check(const struct hits *h, hits_expected *expected,
                const void *shape, const char *name);

uint8_t hits_at(const struct hits *h, int32_t x, int32_t y);

#endif
