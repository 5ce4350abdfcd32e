#include "depth.h"

#include <string.h>

size_t pel_depth_size(const struct pel_rect *bounds, int bits)
{
    if (!pel_bounds_legal(bounds) || (bits != 16 && bits != 32))
        return 0;
    const uint64_t pixels = (uint64_t)(uint32_t)(bounds->x1 - bounds->x0) *
                            (uint32_t)(bounds->y1 - bounds->y0);
    const uint64_t bytes = pixels * (uint32_t)(bits / 8);
    return bytes <= SIZE_MAX ? (size_t)bytes : 0;
}

enum pel_status pel_depth_init(struct pel_depth *depth,
                               const struct pel_rect *bounds, int bits,
                               void *memory, size_t size)
{
    if (!depth || !bounds || !memory)
        return PEL_ERROR_NULL;
    const size_t needed = pel_depth_size(bounds, bits);
    if (needed == 0)
        return PEL_ERROR_SIZE;
    if (size < needed || (uintptr_t)memory % (size_t)(bits / 8))
        return PEL_ERROR_SCRATCH;
    depth->values = memory;
    depth->bounds = *bounds;
    depth->bits = (uint8_t)bits;
    pel_depth_clear(depth);
    return PEL_OK;
}

void pel_depth_clear(const struct pel_depth *depth)
{
    memset(depth->values, 0, pel_depth_size(&depth->bounds, depth->bits));
}
