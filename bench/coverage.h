/* Does a method draw what Pel draws? */
#ifndef BENCH_COVERAGE_H
#define BENCH_COVERAGE_H

#include "method.h"

/* The pixels that a shape may touch, with a little more around. */
struct box shape_box(const struct workload *w, const struct shape *s);

/* A method that draws single shapes on black. */
struct drawing {
    const struct method *method;
    const struct workload *workload;
    const struct canvas *canvas;
    void *job;
    uint8_t *mask; /* green of its box, as large as the canvas */
};

struct drawing drawing_open(const struct method *m, const struct workload *w,
                            const struct canvas *c);
void drawing_close(struct drawing *d);

/* Shape i, alone in its box; the mask says where. Returns its pixels. */
long drawing_draw(const struct drawing *d, const struct box *box, int i);

/* Pixels of a workload's mean shape, as Pel covers it. Draws on the canvas. */
double coverage_mean(const struct workload *w, const struct canvas *c);

struct coverage {
    bool known;   /* false: nothing was compared */
    double more;  /* pixels more (or less) than Pel draws, percent of Pel's */
    double wrong; /* pixels that one of the two draws alone, percent of Pel's */
    int worst;    /* of smooth shapes, of 255: from Pel's level, which is within
                     1 of the exact area, at the edges' worst pixel */
    double mean;  /* and in the mean of the edges' pixels */
};

/* Compares shape by shape, on black; of large workloads a part. */
struct coverage coverage_of(const struct method *m, const struct workload *w,
                            const struct canvas *c);

#endif
