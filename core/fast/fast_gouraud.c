#include "../raster/gouraud_spans.h"
#include "fast_triangle.h"

#if PEL_FAST_FILLS

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

static void write_xrgb(const struct pel_surface *s,
                       const struct pel_fast_triangle *t,
                       const struct pel_gouraud *paint)
{
    const struct pel_gouraud_steps steps = pel_gouraud_steps_make(paint, 1);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    uint32_t start[3], v[3];
    pel_gouraud_at(paint, 0, t->y0, start);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        uintptr_t p = w.row + 4 * (uintptr_t)x;
        pel_prefetch_span(p + 2 * w.pitch, 4 * n);
        at_column(start, paint->dx, (uint32_t)x, v);
        pel_gouraud_span_xrgb((pel_word32 *)p, n, v, &steps);
        pel_gouraud_step(start, paint->dy);
    }
}

static void write_rgb565(const struct pel_surface *s,
                         const struct pel_fast_triangle *t,
                         const struct pel_gouraud *paint)
{
    const struct pel_gouraud_steps steps = pel_gouraud_steps_make(paint, 2);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 2);
    uint32_t start[3], v[3];
    pel_gouraud_at(paint, 0, t->y0, start);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        uintptr_t p = w.row + 2 * (uintptr_t)x;
        at_column(start, paint->dx, (uint32_t)x, v);
        pel_gouraud_span_rgb565((pel_word16 *)p, n, v, &steps);
        pel_gouraud_step(start, paint->dy);
    }
}

bool pel_gouraud_fast(const struct pel_paint *paint,
                      const struct pel_surface *surface,
                      const struct pel_fast_triangle *triangle)
{
    const struct pel_gouraud *g = (const struct pel_gouraud *)paint;
    if (!pel_gouraud_opaque(g) || !surface->format->put)
        return false;
    if (surface->format->id == PEL_FORMAT_XRGB8888)
        write_xrgb(surface, triangle, g);
    else if (surface->format->id == PEL_FORMAT_RGB565_LE)
        write_rgb565(surface, triangle, g);
    else
        return false;
    return true;
}

#endif
