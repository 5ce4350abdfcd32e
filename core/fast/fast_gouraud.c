#include "../raster/gouraud_spans.h"
#include "fast_triangle.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* Written out, as all work for a row here: compilers would keep a loop over
 * three channels, and the channels in memory. */
static PEL_ALWAYS_INLINE void at_column(const uint32_t start[3],
                                        const uint32_t dx[3], uint32_t x,
                                        uint32_t v[3])
{
    v[0] = start[0] + x * dx[0];
    v[1] = start[1] + x * dx[1];
    v[2] = start[2] + x * dx[2];
}

/* With constant `bytes` of a pixel, each of which has a loop of its own. */
static PEL_ALWAYS_INLINE void write_rows(const struct pel_gouraud *paint,
                                         const struct pel_surface *s,
                                         const struct pel_fast_triangle *t,
                                         int bytes)
{
    const struct pel_gouraud_steps steps = pel_gouraud_steps_make(paint, bytes);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, bytes);
    uint32_t start[3], v[3];
    pel_gouraud_at(paint, 0, t->y0, start);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        const uintptr_t p = w.row + (uintptr_t)bytes * (uintptr_t)x;
        if (bytes == 4)
            pel_prefetch_span(p + 2 * w.pitch, 4 * n);
        at_column(start, paint->dx, (uint32_t)x, v);
        pel_gouraud_span(p, n, v, &steps, bytes);
        pel_gouraud_step(start, paint->dy);
    }
}

bool pel_gouraud_fast(const struct pel_paint *paint,
                      const struct pel_surface *surface,
                      const struct pel_fast_triangle *triangle)
{
    const struct pel_gouraud *g = (const struct pel_gouraud *)paint;
    const int bytes = pel_gouraud_bytes(g, surface->format);
    if (bytes == 4)
        write_rows(g, surface, triangle, 4);
    else if (bytes == 2)
        write_rows(g, surface, triangle, 2);
    return bytes != 0;
}

#endif
