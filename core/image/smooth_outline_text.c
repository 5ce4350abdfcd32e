#include "smooth_outline_text.h"

#include "../path/sides.h"
#include "outline_glyphs.h"

enum pel_status pel_smooth_outline_text(
    const struct pel_surface *surface,
    const struct pel_outline_text_block *text, const struct pel_paint *paint,
    void *scratch, size_t size)
{
    if (!scratch)
        return PEL_ERROR_NULL;
    if ((uintptr_t)scratch % 8 || size < PEL_SMOOTH_PATH_SCRATCH_SIZE(0, 0))
        return PEL_ERROR_SCRATCH;
    struct pel_outline_drawing *const d =
        (void *)((char *)scratch + PEL_SMOOTH_PENS_AT);
    d->fill = (struct pel_outline_fill){
        pel_sides_begin_smooth, paint, {scratch, size}};
    return pel_outline_text_draw(d, surface, text);
}
