#include "sim/image/canvas.h"

#include <stdlib.h>

#include "core/raster/rectangle.h"
#include "sim/cli/message.h"

static bool is_paged(const struct pel_format *format)
{
    return format->id == PEL_FORMAT_MONO1_PAGES;
}

bool canvas_init(struct canvas *canvas, const struct pel_format *format,
                 int width, int height)
{
    const struct pel_rect bounds = {0, 0, width, height};
    const size_t lines = (size_t)(is_paged(format) ? (height + 7) / 8 : height);
    canvas->memory = NULL;
    if (!picture_size_check(NULL, width, height))
        return false;
    const size_t size = (size_t)pel_stride(format, width) * lines;
    canvas->memory = calloc(size, 1);
    if (!canvas->memory)
        return message_error("no memory for a canvas of %zu bytes", size);
    pel_surface_init(&canvas->surface, format, canvas->memory, size, &bounds);
    pel_clear(&canvas->surface, PEL_RGB(0, 0, 0));
    return true;
}

void canvas_free(struct canvas *canvas)
{
    free(canvas->memory);
    canvas->memory = NULL;
}

static void load_row(const void *surface, int y, pel_color *row)
{
    const struct pel_surface *s = surface;
    s->format->load(s, s->bounds.x0, s->bounds.y0 + y,
                    s->bounds.x1 - s->bounds.x0, row);
}

static struct picture_rows rows_of(const struct canvas *canvas)
{
    const struct pel_rect *bounds = &canvas->surface.bounds;
    return (struct picture_rows){bounds->x1 - bounds->x0,
                                 bounds->y1 - bounds->y0, load_row,
                                 &canvas->surface};
}

bool canvas_picture(const struct canvas *canvas, struct picture *picture)
{
    const struct picture_rows rows = rows_of(canvas);
    if (!picture_init(picture, rows.width, rows.height, 0))
        return false;
    for (int y = 0; y < rows.height; y++)
        load_row(&canvas->surface, y, picture_row(picture, y));
    return true;
}

bool canvas_save(const struct canvas *canvas, const char *path)
{
    const struct picture_rows rows = rows_of(canvas);
    return picture_save_rows(&rows, path);
}

bool canvas_bands_legal(const struct pel_format *format, int rows)
{
    return rows >= 0 && (!is_paged(format) || rows % 8 == 0);
}

bool canvas_draw(struct canvas *canvas, int rows, canvas_draw_function *draw,
                 void *context)
{
    struct pel_surface *whole = &canvas->surface;
    const int32_t lines = is_paged(whole->format) ? 8 : 1;
    struct pel_surface band = *whole;
    if (!canvas_bands_legal(whole->format, rows))
        return message_error("bands of %d rows: expected a multiple of 8 for "
                             "mono1_pages",
                             rows);
    whole->clip = whole->bounds;
    if (rows == 0)
        draw(whole, context);
    while (rows > 0 && band.bounds.y0 < whole->bounds.y1) {
        band.bounds.y1 = pel_min(band.bounds.y0 + rows, whole->bounds.y1);
        band.clip = band.bounds;
        draw(&band, context);
        band.pixels = (uint8_t *)band.pixels + rows / lines * band.stride;
        band.bounds.y0 = band.bounds.y1;
    }
    whole->clip = whole->bounds;
    return true;
}
