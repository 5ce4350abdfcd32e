#include "fast_triangle.h"

#if PEL_FAST_64BIT

#include "gouraud_runs.h"

static void write_xrgb(const struct pel_surface *s,
                       const struct pel_fast_triangle *t,
                       const struct pel_gouraud *paint)
{
    const struct pel_gouraud_run run = pel_gouraud_run_make(paint, 1);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    uint32_t row[3], v[3];
    pel_gouraud_at(paint, 0, t->y0, row);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        uintptr_t p = w.line + 4 * (uintptr_t)x;
        pel_prefetch_run(p + 2 * w.pitch, 4 * n);
        for (int k = 0; k < 3; k++)
            v[k] = row[k] + (uint32_t)x * paint->dx[k];
        pel_gouraud_run_xrgb((pel_word32 *)p, n, v, &run);
        pel_gouraud_step(row, paint->dy);
    }
}

static void write_rgb565(const struct pel_surface *s,
                         const struct pel_fast_triangle *t,
                         const struct pel_gouraud *paint)
{
    const struct pel_gouraud_run run = pel_gouraud_run_make(paint, 2);
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 2);
    uint32_t row[3], v[3];
    pel_gouraud_at(paint, 0, t->y0, row);
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        uintptr_t p = w.line + 2 * (uintptr_t)x;
        for (int k = 0; k < 3; k++)
            v[k] = row[k] + (uint32_t)x * paint->dx[k];
        pel_gouraud_run_rgb565((pel_word16 *)p, n, v, &run);
        pel_gouraud_step(row, paint->dy);
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
