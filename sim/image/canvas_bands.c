#include <string.h>

#include "sim/image/canvas.h"

bool canvas_bands_legal(const struct pel_format *format, int rows)
{
    if (format->id == PEL_FORMAT_MONO1_PAGES && rows % 8 != 0)
        return false;
    return rows >= 0;
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
    const int32_t step = format->id == PEL_FORMAT_MONO1_PAGES ? 8 : 1;
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
