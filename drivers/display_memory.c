#include "display_memory.h"

#include <string.h>

/* Bytes of lines [y0, y1), columns [x0, x1) of `from` into `to`: both have one
 * format, and columns that are whole bytes. */
static void copy_lines(const struct pel_surface *to,
                       const struct pel_surface *from, const struct pel_rect *a)
{
    const int32_t bits = from->format->bits;
    const size_t length = (size_t)((a->x1 - a->x0) * bits + 7) / 8;
    for (int32_t y = a->y0; y < a->y1; y++)
        memcpy(pel_surface_line(to, y) + (a->x0 - to->bounds.x0) * bits / 8,
               pel_surface_line(from, y) + (a->x0 - from->bounds.x0) * bits / 8,
               length);
}

/* Any other surface goes through colors. */
static void convert_lines(const struct pel_surface *to,
                          const struct pel_surface *from,
                          const struct pel_rect *a)
{
    pel_color colors[16];
    for (int32_t y = a->y0; y < a->y1; y++)
        for (int32_t x = a->x0; x < a->x1; x += 16) {
            int32_t n = pel_min(16, a->x1 - x);
            from->format->load(from, x, y, n, colors);
            to->format->put(to, x, y, n, colors);
        }
}

static enum pel_status memory_flush(const struct pel_display *display,
                                    const struct pel_surface *surface)
{
    const struct pel_display_memory *memory = display->context;
    const struct pel_surface *screen = &memory->screen;
    struct pel_rect area = pel_rect_intersect(&surface->clip, &screen->bounds);
    if (pel_rect_empty(&area))
        return PEL_OK;
    if (surface->format == screen->format && surface->format->bits >= 8) {
        copy_lines(screen, surface, &area);
        return PEL_OK;
    }
    if (!surface->format->load || !screen->format->put)
        return PEL_ERROR_NULL;
    convert_lines(screen, surface, &area);
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
