/* Draws single triangles and says which pixels are wrong. */
#ifndef BENCH_ATLAS_SHEET_H
#define BENCH_ATLAS_SHEET_H

#include "../methods/fill.h"
#include "atlas.h"

/* The pixels of row y that the triangle covers, by exact 64-bit arithmetic. */
struct pel_span exact_row(const struct pel_point v[3], int32_t y);

struct sheet {
    struct pel_surface surface; /* xrgb8888, all 0 between triangles */
    uint32_t *pixels;
    struct pel_point smallest[3]; /* of the wrong triangles */
    int32_t smallest_size;        /* sub-pixels; INT32_MAX: there is none */
    int32_t wrong_x, wrong_y;     /* its first wrong pixel */
};

void sheet_open(struct sheet *s, struct pel_rect bounds);
void sheet_close(struct sheet *s);

/* What a method did to many triangles. */
struct tally {
    double covered, wrong; /* pixels */
    double triangles, damaged;
};

/* Draws one triangle, compares every pixel of the sheet, and clears them. A
 * vertex loses the sub-pixel bits that the method is not made for. */
void sheet_judge(struct sheet *s, const struct fill_method *m,
                 const struct pel_point v[3], struct tally *t);

/* Puts metric `wrong_ppm`, or another name for it, promises 0 of Pel, and
 * prints the smallest wrong triangle when the run asks for that of the method.
 */
void sheet_report(struct atlas *a, const struct sheet *s,
                  const struct fill_method *m, const struct tally *t,
                  struct figure f);

#endif
