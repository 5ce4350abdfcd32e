#include "smooth_polygon.h"

#include "smooth_sweep.h"

/* Of the scratch memory, before the edges, which are aligned to 8. */
enum { HEAD = PEL_SMOOTH_POLYGON_SCRATCH_SIZE(0, 0) - sizeof(int32_t) };

#if PEL_SMOOTH_TINY
enum { DRAWING = sizeof(struct pel_smooth_drawing) };
#else
enum { DRAWING = 0 };
#endif

PEL_STATIC_ASSERT(pel_smooth_polygon_fits,
                  sizeof(struct pel_smooth_sweep) + DRAWING <= HEAD &&
                      PEL_SMOOTH_POLYGON_SCRATCH_SIZE(1, 0) -
                              PEL_SMOOTH_POLYGON_SCRATCH_SIZE(0, 0) >=
                          sizeof(struct pel_smooth_edge) + sizeof(int32_t));

size_t pel_smooth_polygon_scratch_size(int32_t n, int32_t width)
{
    const size_t head = PEL_SMOOTH_POLYGON_SCRATCH_SIZE(0, 0);
    const size_t edge = PEL_SMOOTH_POLYGON_SCRATCH_SIZE(1, 0) - head;
    const size_t most = (size_t)-1 - head;
    if (n < 1 || width < 0 || (size_t)width >= most / 4 ||
        (size_t)n > (most - (size_t)width * 4) / edge)
        return 0;
    return PEL_SMOOTH_POLYGON_SCRATCH_SIZE(n, width);
}

/* Is all of it left of the clip, or all right of it? */
static PEL_NOINLINE_32 bool is_beside(const struct pel_rect *clip,
                                      const struct pel_polygon_shape *p)
{
    bool left = true, right = true;
    for (int32_t i = 0; i < p->n; i++) {
        left = left && pel_pixel_of(p->v[i].x) < clip->x0;
        right = right && pel_pixel_of(p->v[i].x) >= clip->x1;
    }
    return left || right;
}

static PEL_NOINLINE_32 void add_edges(struct pel_smooth_sweep *w,
                                      const struct pel_polygon_shape *p)
{
    const struct pel_point *a = &p->v[p->n - 1];
    for (int32_t i = 0; i < p->n; a = &p->v[i++])
        pel_smooth_sweep_add(w, a, &p->v[i]);
}

static PEL_NOINLINE_32 enum pel_status check(const struct pel_surface *surface,
                                             const struct pel_polygon_shape *p,
                                             const void *scratch, size_t size)
{
    const int32_t width = pel_max(surface->clip.x1 - surface->clip.x0, 0);
    const size_t need = pel_smooth_polygon_scratch_size(p->n, width);
    if (!p->v || !scratch)
        return PEL_ERROR_NULL;
    if ((uintptr_t)scratch % 8 || need == 0 || size < need)
        return PEL_ERROR_SCRATCH;
    PEL_HINT(pel_in_subpixels(p->v, p->n, 0));
    return pel_points_legal(p->v, p->n) ? PEL_OK : PEL_ERROR_RANGE;
}

enum pel_status pel_smooth_polygon(const struct pel_surface *surface,
                                   const struct pel_polygon_shape *polygon,
                                   const struct pel_paint *paint, void *scratch,
                                   size_t size)
{
    if (!surface || !polygon || !paint)
        return PEL_ERROR_NULL;
    if (polygon->n < 3)
        return PEL_OK;
    const enum pel_status status = check(surface, polygon, scratch, size);
    struct pel_smooth_sweep *const w = scratch;
    if (status != PEL_OK || !pel_smooth_begin(&w->smooth, surface, paint) ||
        pel_rect_empty(&surface->clip) || is_beside(&surface->clip, polygon))
        return status;
#if PEL_SMOOTH_TINY
    w->drawing = (void *)(w + 1);
#endif
    pel_smooth_sweep_begin(w, (char *)scratch + HEAD, polygon->n,
                           polygon->rule);
    pel_smooth_sweep_set_rows(w, surface->clip.y0, surface->clip.y1);
    add_edges(w, polygon);
    pel_smooth_sweep_paint(w);
    return PEL_OK;
}
