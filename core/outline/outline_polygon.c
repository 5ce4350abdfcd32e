#include "outline.h"

#include "../raster/sweep.h"
#include "outline_filter.h"

/* The scratch memory: the filter, aligned like a pointer, its spans, and that
 * of the polygon. On the stack the filter would be the larger part of what the
 * outline takes. */
enum { FILTER_BYTES = sizeof(struct pel_outline_filter) + sizeof(void *) - 4 };

size_t pel_polygon_outline_scratch_size(int32_t n)
{
    size_t fill = pel_polygon_scratch_size(n);
    if (fill == 0 || (size_t)n > ((size_t)-1 - FILTER_BYTES) / 64)
        return 0;
    return PEL_POLYGON_OUTLINE_SCRATCH_SIZE(n);
}

static struct pel_outline_filter *filter_in(void *scratch)
{
    const uintptr_t mask = sizeof(void *) - 1;
    return (struct pel_outline_filter *)(((uintptr_t)scratch + mask) & ~mask);
}

enum pel_status pel_polygon_outline(const struct pel_surface *surface,
                                    const struct pel_polygon_shape *polygon,
                                    const struct pel_paint *paint,
                                    void *scratch, size_t size)
{
    if (!surface || !polygon || !paint)
        return PEL_ERROR_NULL;
    if (polygon->n < 3)
        return PEL_OK;
    if (!scratch || !polygon->v)
        return PEL_ERROR_NULL;
    size_t needed = pel_polygon_outline_scratch_size(polygon->n);
    if (needed == 0 || size < needed || (uintptr_t)scratch % 4)
        return PEL_ERROR_SCRATCH;
    const int visible = pel_polygon_visible(polygon, &surface->clip);
    if (visible <= 0)
        return (enum pel_status)visible;
    struct pel_outline_filter *filter = filter_in(scratch);
    uint8_t *const memory = scratch;
    void *const spans = memory + FILTER_BYTES;
    const int32_t n = PEL_OUTLINE_FILTER_SPANS(polygon->n / 2);
    const size_t used = FILTER_BYTES + (size_t)n * sizeof(struct pel_span);
    pel_outline_filter_begin(filter, surface, paint, spans, n);
    if (pel_polygon_begin(polygon, memory + used, size - used,
                          &filter->surface.clip) > 0)
        pel_sweep_paint((void *)(memory + used), &filter->surface,
                        &filter->paint);
    pel_outline_filter_end(filter);
    return PEL_OK;
}
