#include "copy.h"

#include "copy_lines.h"

static void weigh(pel_color *colors, int32_t n, uint32_t alpha)
{
    for (int32_t i = 0; i < n; i++) {
        uint32_t weight = pel_round_div255(pel_alpha(colors[i]) * alpha);
        colors[i] = (colors[i] & UINT32_C(0xFFFFFF)) | weight << 24;
    }
}

void pel_copy_alpha(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, uint8_t alpha)
{
    pel_copy_lines(surface, copy, alpha < 255 ? weigh : NULL, alpha);
}
