/* Ways to fill a triangle: Pel's, and those that others use. */
#ifndef BENCH_METHODS_FILL_H
#define BENCH_METHODS_FILL_H

#include <pel/pel.h>

struct fill_method {
    const char *name;

    /* Sub-pixel bits that the method is made for, at most 8: vertices are
     * multiples of 2^(8 - bits). */
    int bits;

    /* Stores the pixel, an opaque one, where it sees the triangle, inside the
     * bounds of an xrgb8888 surface. Which vertex is the first does not matter.
     */
    void (*draw)(const struct pel_surface *surface, const struct pel_point v[3],
                 uint32_t pixel);
};

/* The first one is Pel's; ends with NULL. */
extern const struct fill_method *const fill_methods[];

bool fill_is_pel(const struct fill_method *m);

extern const struct fill_method fill_pel;
extern const struct fill_method fill_fixed_rounded, fill_fixed_truncated;
extern const struct fill_method fill_float_scanline, fill_float_stepped;
extern const struct fill_method fill_barycentric, fill_barycentric_ties,
    fill_barycentric_derived;
extern const struct fill_method fill_half_space_64, fill_half_space_32,
    fill_half_space_32_4;

/* Stores pixels [x0, x1) of row y, as far as they lie inside the bounds. */
static inline void fill_run(const struct pel_surface *s, int32_t y,
                            struct pel_span run, uint32_t pixel)
{
    uint32_t *line = (uint32_t *)(void *)pel_surface_line(s, y);
    line -= s->bounds.x0;
    const int32_t x1 = pel_min(run.x1, s->bounds.x1);
    for (int32_t x = pel_max(run.x0, s->bounds.x0); x < x1; x++)
        line[x] = pixel;
}

/* The pixels of the surface that the triangle's box holds. */
static inline struct pel_rect fill_box(const struct pel_surface *s,
                                       const struct pel_point v[3])
{
    struct pel_rect b = {
        pel_min(v[0].x, pel_min(v[1].x, v[2].x)) >> 8,
        pel_min(v[0].y, pel_min(v[1].y, v[2].y)) >> 8,
        (pel_max(v[0].x, pel_max(v[1].x, v[2].x)) >> 8) + 1,
        (pel_max(v[0].y, pel_max(v[1].y, v[2].y)) >> 8) + 1,
    };
    b.x0 = pel_max(b.x0, s->bounds.x0);
    b.y0 = pel_max(b.y0, s->bounds.y0);
    b.x1 = pel_min(b.x1, s->bounds.x1);
    b.y1 = pel_min(b.y1, s->bounds.y1);
    return b;
}

#endif
