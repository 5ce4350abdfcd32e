#include "smooth_outline_text.h"

#include "../path/sides.h"
#include "outline_glyphs.h"

enum pel_status pel_smooth_outline_text(
    const struct pel_surface *surface,
    const struct pel_outline_text_block *text, const struct pel_paint *paint,
    void *scratch, size_t size)
{
    const struct pel_outline_fill fill = {
        pel_sides_smooth, paint, {scratch, size}};
    return pel_outline_text_fill(surface, text, &fill);
}
