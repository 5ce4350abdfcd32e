#include "outline.h"

#include "rim.h"

/* The rim's memory comes first: a row has n / 2 runs at most. */
static size_t rim_runs(int32_t n)
{
    return PEL_RIM_MEMORY((size_t)n / 2);
}

size_t pel_polygon_outline_scratch_size(int32_t n)
{
    size_t fill = pel_polygon_scratch_size(n);
    if (fill == 0 || (size_t)n > (size_t)-1 / 64)
        return 0;
    return fill + rim_runs(n) * sizeof(struct pel_row);
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
    if (!scratch)
        return PEL_ERROR_NULL;
    size_t needed = pel_polygon_outline_scratch_size(polygon->n);
    if (needed == 0 || size < needed || (uintptr_t)scratch % 4)
        return PEL_ERROR_SCRATCH;
    struct pel_row *memory = scratch;
    size_t runs = rim_runs(polygon->n), used = runs * sizeof *memory;
    struct pel_rim rim;
    if (!pel_rim_begin(&rim, surface, paint, memory, (int32_t)runs))
        return PEL_OK;
    enum pel_status status = pel_polygon(&rim.surface, polygon, &rim.paint,
                                         memory + runs, size - used);
    pel_rim_end(&rim);
    return status;
}
