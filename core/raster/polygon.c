#include "polygon.h"

#include "sweep.h"

PEL_STATIC_ASSERT(pel_polygon_side_fits, PEL_POLYGON_SCRATCH_SIZE(1) ==
                                             sizeof(struct pel_sweep) +
                                                 sizeof(struct pel_sweep_side) +
                                                 sizeof(int32_t));

size_t pel_polygon_scratch_size(int32_t n)
{
    if (n < 1 || (size_t)n > (size_t)-1 / PEL_POLYGON_SCRATCH_SIZE(1))
        return 0;
    return PEL_POLYGON_SCRATCH_SIZE(n);
}

int pel_polygon_visible(const struct pel_polygon_shape *polygon,
                        const struct pel_rect *clip)
{
    const struct pel_rect box = pel_points_box(polygon->v, polygon->n);
    const struct pel_point corners[2] = {{box.x0, box.y0}, {box.x1, box.y1}};
    if (!pel_points_legal(corners, 2))
        return PEL_ERROR_RANGE;
    const struct pel_rect seen = pel_rect_pixels(&box, clip);
    return pel_rect_empty(&seen) ? PEL_OK : 1;
}

/* As pel_polygon_visible. */
static int check(const struct pel_polygon_shape *p, const void *scratch,
                 size_t size, const struct pel_rect *clip)
{
    if (!p->v || !scratch)
        return PEL_ERROR_NULL;
    size_t needed = pel_polygon_scratch_size(p->n);
    if (needed == 0 || size < needed || (uintptr_t)scratch % 4)
        return PEL_ERROR_SCRATCH;
    PEL_HINT(pel_in_subpixels(p->v, p->n, 0));
    return pel_polygon_visible(p, clip);
}

int pel_polygon_begin(const struct pel_polygon_shape *polygon, void *scratch,
                      size_t size, const struct pel_rect *clip)
{
    const int visible = check(polygon, scratch, size, clip);
    if (visible <= 0)
        return visible;
    struct pel_sweep *const w =
        pel_sweep_begin(scratch, polygon->n, polygon->rule);
    const struct pel_point *previous = &polygon->v[polygon->n - 1];
    for (int32_t i = 0; i < polygon->n; i++) {
        pel_sweep_add(w, previous, &polygon->v[i], clip->y0, clip->y1);
        previous = &polygon->v[i];
    }
    return visible;
}

enum pel_status pel_polygon(const struct pel_surface *surface,
                            const struct pel_polygon_shape *polygon,
                            const struct pel_paint *paint, void *scratch,
                            size_t size)
{
    if (!surface || !polygon || !paint)
        return PEL_ERROR_NULL;
    if (polygon->n < 3)
        return PEL_OK;
    const int visible =
        pel_polygon_begin(polygon, scratch, size, &surface->clip);
    return visible > 0 ? pel_sweep_paint(scratch, surface, paint)
                       : (enum pel_status)visible;
}
