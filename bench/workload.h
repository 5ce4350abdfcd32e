/* Workloads: what every method has to draw. TARGETS of the budgets define
 * them: vertices on whole pixels, uniform in a square box at a random place,
 * kept when the area is in the range. */
#ifndef BENCH_WORKLOAD_H
#define BENCH_WORKLOAD_H

#include <stdbool.h>
#include <stdint.h>

#include "random.h"

enum { SHAPE_VERTICES = 8 };

enum form { FORM_TRIANGLE, FORM_SLIVER, FORM_CIRCLE, FORM_POLYGON, FORM_LINE };
enum paint { PAINT_FLAT, PAINT_ALPHA, PAINT_GOURAUD };

/* Alpha of PAINT_ALPHA, of 255. */
enum { WORKLOAD_ALPHA = 128 };

/* px. A circle's centre is the centre of pixel (x[0], y[0]), a line runs
 * between two pixels; the vertices of the others are corners of pixels. */
struct shape {
    int x[SHAPE_VERTICES], y[SHAPE_VERTICES];
    uint32_t color[3]; /* 0xRRGGBB; only Gouraud needs all three. Every channel
                          is 64 or more: drawing on black changes a pixel. */
};

struct workload {
    const char *name;
    enum form form;
    enum paint paint;
    int width, height; /* of the canvas, px */
    int bits;          /* of a pixel: 32 is XRGB8888, 16 is RGB565 */
    int size;          /* box, radius or length, px */
    int area_min, area_max;
    int count;           /* shapes in a pass */
    struct shape *shape; /* `count` of them, owned by the workload */
};

/* The table of workloads, without shapes; ends with a NULL name. */
extern const struct workload workloads[];

int workload_vertices(const struct workload *w);

/* Allocates and makes the shapes; false when memory is short. */
bool workload_open(struct workload *w);
void workload_close(struct workload *w);

/* One shape each: workload_*.c. */
void triangle_make(const struct workload *w, struct random *r, struct shape *s);
void sliver_make(const struct workload *w, struct random *r, struct shape *s);
void circle_make(const struct workload *w, struct random *r, struct shape *s);
void polygon_make(const struct workload *w, struct random *r, struct shape *s);
void line_make(const struct workload *w, struct random *r, struct shape *s);

#endif
