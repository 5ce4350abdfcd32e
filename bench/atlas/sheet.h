/* Draws single triangles and says which pixels are wrong. */
#ifndef BENCH_ATLAS_SHEET_H
#define BENCH_ATLAS_SHEET_H

#include "../methods/fill.h"
#include "atlas.h"

/* The pixels of row y that the triangle covers, by exact 64-bit arithmetic;
 * vertices in 2^-bits px. */
struct pel_span exact_row(const struct pel_point v[3], int32_t y, int bits);

struct sheet {
    struct pel_surface surface; /* xrgb8888, all 0 between triangles */
    uint32_t *pixels;
    struct atlas *atlas;
};

void sheet_open(struct sheet *s, struct atlas *a, struct pel_rect bounds);
void sheet_close(struct sheet *s);

/* Shows other pixels, as many. */
void sheet_move(struct sheet *s, int32_t x, int32_t y);

/* What a method did to many triangles. */
struct tally {
    double covered, wrong; /* pixels */
    double triangles, damaged;
};

/* Draws one triangle, compares every pixel of the sheet, and clears them. A
 * vertex loses the sub-pixel bits that the method is not made for. */
void sheet_judge(struct sheet *s, const struct fill_method *m,
                 const struct pel_point v[3], struct tally *t);

/* Puts the wrong pixels of all, in ppm, with x, y and metric of `f`; promises 0
 * of Pel. */
void tally_put(struct atlas *a, const struct fill_method *m,
               const struct tally *t, struct figure f);

#endif
