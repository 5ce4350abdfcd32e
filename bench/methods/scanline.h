/* Rows of a triangle between two edges that are walked down, each with an
 * accumulator of its own kind. */
#ifndef BENCH_METHODS_SCANLINE_H
#define BENCH_METHODS_SCANLINE_H

#include "fill.h"

struct walk {
    int64_t fixed, fixed_step; /* 1/65,536 px */
    float x, step, y;          /* px; y from the upper end */
};

/* Starts at the first row of the edge from a down to b, a.y < b.y. */
typedef void walk_start(struct walk *w, const struct pel_point *a,
                        const struct pel_point *b);
typedef void walk_next(struct walk *w);
typedef int32_t walk_pixel(const struct walk *w);

struct scanline {
    walk_start *start;
    walk_next *next;
    walk_pixel *pixel;
};

static PEL_ALWAYS_INLINE void scanline_part(const struct pel_surface *s,
                                            const struct scanline *kind,
                                            struct walk w[2],
                                            struct pel_span rows,
                                            uint32_t pixel)
{
    for (int32_t y = rows.x0; y < rows.x1; y++) {
        if (y >= s->bounds.y0 && y < s->bounds.y1) {
            const int32_t p = kind->pixel(&w[0]), q = kind->pixel(&w[1]);
            const struct pel_span run = {pel_min(p, q), pel_max(p, q)};
            fill_run(s, y, run, pixel);
        }
        kind->next(&w[0]);
        kind->next(&w[1]);
    }
}

static inline void sort_down(const struct pel_point v[3],
                             const struct pel_point *sorted[3])
{
    for (int i = 0; i < 3; i++) {
        int k = i;
        for (; k > 0 &&
               (sorted[k - 1]->y > v[i].y ||
                (sorted[k - 1]->y == v[i].y && sorted[k - 1]->x > v[i].x));
             k--)
            sorted[k] = sorted[k - 1];
        sorted[k] = &v[i];
    }
}

/* Inlined with a constant kind, so that a kind's functions are too. */
static PEL_ALWAYS_INLINE void scanline_draw(const struct pel_surface *s,
                                            const struct scanline *kind,
                                            const struct pel_point v[3],
                                            uint32_t pixel)
{
    const struct pel_point *p[3];
    struct walk w[2];
    sort_down(v, p);
    const int32_t y0 = pel_first_pixel(p[0]->y), y1 = pel_first_pixel(p[1]->y);
    const int32_t y2 = pel_first_pixel(p[2]->y);
    const struct pel_span rows[2] = {{y0, y1}, {y1, y2}};
    if (y0 >= y2)
        return;
    kind->start(&w[0], p[0], p[2]);
    for (int i = 0; i < 2; i++)
        if (rows[i].x0 < rows[i].x1) {
            kind->start(&w[1], p[i], p[i + 1]);
            scanline_part(s, kind, w, rows[i], pixel);
        }
}

#endif
