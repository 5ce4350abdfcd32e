#include "sim/image/canvas.h"

#include <stdlib.h>
#include <string.h>

#include "core/raster/rectangle.h"
#include "sim/cli/message.h"

static bool is_paged(const struct pel_format *format)
{
    return format->id == PEL_FORMAT_MONO1_PAGES;
}

/* A packed canvas with these absolute bounds; a tile of a format with less than
 * 8 bits begins at a byte. The pixels are not set to a color. */
static bool init(struct canvas *canvas, const struct pel_format *format,
                 const struct pel_rect *bounds)
{
    const int32_t height = bounds->y1 - bounds->y0;
    const size_t lines = (size_t)(is_paged(format) ? (height + 7) / 8 : height);
    const size_t size =
        (size_t)pel_stride(format, bounds->x1 - bounds->x0) * lines;
    canvas->memory = calloc(size, 1);
    if (!canvas->memory)
        return message_error("no memory for a canvas of %zu bytes", size);
    pel_surface_init(&canvas->surface, format, canvas->memory, size, bounds);
    return true;
}

bool canvas_init(struct canvas *canvas, const struct pel_format *format,
                 int width, int height)
{
    const struct pel_rect bounds = {0, 0, width, height};
    canvas->memory = NULL;
    if (!picture_size_check(NULL, width, height) ||
        !init(canvas, format, &bounds))
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
    struct pel_rect band = whole->bounds;
    for (; band.y0 < whole->bounds.y1; band.y0 = band.y1) {
        struct canvas part;
        band.y1 = pel_min(band.y0 + rows, whole->bounds.y1);
        if (!init(&part, whole->format, &band))
            return false;
        copy_lines(&part.surface, whole, &band);
        draw(&part.surface, context);
        copy_lines(whole, &part.surface, &band);
        canvas_free(&part);
    }
    return true;
}
