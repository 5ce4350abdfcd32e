#include "display_memory.h"

static enum pel_status memory_flush(const struct pel_display *display,
                                    const struct pel_surface *surface)
{
    const struct pel_display_memory *memory = display->context;
    const struct pel_format *from = surface->format, *to = display->format;
    const struct pel_rect *clip = &surface->clip;
    const struct pel_copy_part part = {surface, *clip, clip->x0, clip->y0};
    if (from != to && (!from->load || !to->put))
        return PEL_ERROR_NULL;
    pel_copy(&memory->screen, &part);
    return PEL_OK;
}

enum pel_status pel_display_memory_init(struct pel_display *display,
                                        struct pel_display_memory *memory)
{
    if (!display || !memory || !memory->screen.pixels)
        return PEL_ERROR_NULL;
    const struct pel_rect *bounds = &memory->screen.bounds;
    if (bounds->x0 || bounds->y0)
        return PEL_ERROR_SIZE;
    *display = (struct pel_display){.context = memory,
                                    .width = bounds->x1,
                                    .height = bounds->y1,
                                    .format = memory->screen.format,
                                    .flush = memory_flush};
    return PEL_OK;
}
