#include "sim/image/canvas.h"

#include <stdlib.h>
#include <string.h>

#include "core/raster/rectangle.h"
#include "sim/cli/message.h"

static bool is_paged(const struct pel_format *format)
{
    return format->id == PEL_FORMAT_MONO1_PAGES;
}

/* Lines of memory: those of pixels, or pages of 8 of them. */
static int32_t lines_of(const struct pel_format *format,
                        const struct pel_rect *bounds)
{
    const int32_t height = bounds->y1 - bounds->y0;
    return is_paged(format) ? (height + 7) / 8 : height;
}

bool canvas_init_layout(struct canvas *canvas, const struct pel_format *format,
                        const struct canvas_layout *layout)
{
    const struct pel_rect *bounds = &layout->bounds;
    canvas->memory = NULL;
    const int32_t width = bounds->x1 - bounds->x0;
    const int32_t height = bounds->y1 - bounds->y0;
    if (!picture_size_legal(width, height))
        return message_error("a canvas of %d x %d pixels: 1 to %d each way, "
                             "%d in all",
                             width, height, PICTURE_SIZE_MAX,
                             PICTURE_PIXELS_MAX);
    const int32_t lines = lines_of(format, bounds);
    int32_t stride = pel_stride(format, width) + layout->padding * format->word;
    const size_t size = (size_t)stride * (size_t)lines;
    uint8_t *pixels = canvas->memory = malloc(size);
    if (!pixels)
        return message_error("no memory for a canvas of %zu bytes", size);
    memset(pixels, 0xA5, size);
    if (layout->bottom_up && !is_paged(format)) {
        pixels += (size_t)(lines - 1) * (size_t)stride;
        stride = -stride;
    }
    const enum pel_status status =
        pel_surface_init_rect(&canvas->surface, format, pixels, stride, bounds);
    if (status == PEL_OK)
        return true;
    canvas_free(canvas);
    return message_error("a canvas that is no legal surface (status %d)",
                         (int)status);
}

bool canvas_init(struct canvas *canvas, const struct pel_format *format,
                 int width, int height)
{
    const struct canvas_layout layout = {{0, 0, width, height}, 0, false};
    if (!canvas_init_layout(canvas, format, &layout))
        return false;
    pel_clear(&canvas->surface, PEL_RGB(0, 0, 0));
    return true;
}

void canvas_free(struct canvas *canvas)
{
    free(canvas->memory);
    canvas->memory = NULL;
}

bool canvas_picture(const struct canvas *canvas, struct picture *picture)
{
    const struct pel_surface *s = &canvas->surface;
    const int32_t width = s->bounds.x1 - s->bounds.x0;
    const int32_t height = s->bounds.y1 - s->bounds.y0;
    if (!picture_init(picture, width, height, 0))
        return false;
    for (int32_t y = 0; y < height; y++)
        s->format->load(s, s->bounds.x0, s->bounds.y0 + y, width,
                        picture_row(picture, y));
    return true;
}
