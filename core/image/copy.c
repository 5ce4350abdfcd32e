#include "copy.h"

#include "copy_lines.h"

static void make_opaque(pel_color *colors, int32_t n, uint32_t option)
{
    (void)option;
    for (int32_t i = 0; i < n; i++)
        colors[i] |= PEL_RGB(0, 0, 0);
}

void pel_copy(const struct pel_surface *surface,
              const struct pel_copy_part *copy)
{
    if (!pel_copy_same(surface, copy, NULL))
        pel_copy_lines(surface, copy, make_opaque, 0);
}
