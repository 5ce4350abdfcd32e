#include "outline.h"

#include "rim.h"

/* The scratch memory: the rim, aligned like a pointer, its runs (a row has n /
 * 2 at most), and that of the polygon. A rim on the stack would be the larger
 * part of what the outline takes there. */
enum { RIM_BYTES = sizeof(struct pel_rim) + sizeof(void *) - 4 };

static size_t rim_runs(int32_t n)
{
    return PEL_RIM_MEMORY((size_t)n / 2);
}

static size_t rim_size(int32_t n)
{
    return RIM_BYTES + rim_runs(n) * sizeof(struct pel_span);
}

size_t pel_polygon_outline_scratch_size(int32_t n)
{
    size_t fill = pel_polygon_scratch_size(n);
    if (fill == 0 || (size_t)n > ((size_t)-1 - RIM_BYTES) / 64)
        return 0;
    return fill + rim_size(n);
}

static struct pel_rim *rim_in(void *scratch)
{
    const uintptr_t mask = sizeof(void *) - 1;
    return (struct pel_rim *)(((uintptr_t)scratch + mask) & ~mask);
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
    struct pel_rim *rim = rim_in(scratch);
    uint8_t *const memory = scratch;
    void *const runs = memory + RIM_BYTES;
    const size_t used = rim_size(polygon->n);
    if (!pel_rim_begin(rim, surface, paint, runs,
                       (int32_t)rim_runs(polygon->n)))
        return PEL_OK;
    enum pel_status status = pel_polygon(&rim->surface, polygon, &rim->paint,
                                         memory + used, size - used);
    pel_rim_end(rim);
    return status;
}
