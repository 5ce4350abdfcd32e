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
    if (!picture_size_check(NULL, width, height))
        return false;
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

bool canvas_save(const struct canvas *canvas, const char *path)
{
    struct picture picture;
    const bool done =
        canvas_picture(canvas, &picture) && picture_save(&picture, path);
    picture_free(&picture);
    return done;
}

bool canvas_bands_legal(const struct pel_format *format, int rows)
{
    return rows >= 0 && (!is_paged(format) || rows % 8 == 0);
}

static uint8_t *line_at(const struct pel_surface *s, int32_t y, int32_t step)
{
    return (uint8_t *)s->pixels +
           (ptrdiff_t)((y - s->bounds.y0) / step) * (ptrdiff_t)s->stride;
}

/* The lines that the band holds, from one surface to the other: both have its
 * width and format. */
static void copy_lines(const struct pel_surface *to,
                       const struct pel_surface *from,
                       const struct pel_rect *band)
{
    const struct pel_format *format = to->format;
    const int32_t step = is_paged(format) ? 8 : 1;
    const size_t size = (size_t)pel_stride(format, band->x1 - band->x0);
    for (int32_t y = band->y0; y < band->y1; y += step)
        memcpy(line_at(to, y, step), line_at(from, y, step), size);
}

bool canvas_draw(struct canvas *canvas, int rows, canvas_draw_function *draw,
                 void *context)
{
    struct pel_surface *whole = &canvas->surface;
    whole->clip = whole->bounds;
    if (rows == 0) {
        draw(whole, context);
        whole->clip = whole->bounds;
        return true;
    }
    struct canvas_layout layout = {whole->bounds, 0, false};
    struct pel_rect *band = &layout.bounds;
    for (; band->y0 < whole->bounds.y1; band->y0 = band->y1) {
        struct canvas part;
        band->y1 = pel_min(band->y0 + rows, whole->bounds.y1);
        if (!canvas_init_layout(&part, whole->format, &layout))
            return false;
        copy_lines(&part.surface, whole, band);
        draw(&part.surface, context);
        copy_lines(whole, &part.surface, band);
        canvas_free(&part);
    }
    return true;
}
