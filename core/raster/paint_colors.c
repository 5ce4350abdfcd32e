#include "paint_colors.h"

#include "../format/word32.h"

/* Colours between a paint and a format, a power of two: more where stack is
 * cheap, because a paint then starts less often. */
#if PEL_FAST_64BIT
enum { RUN_PIXELS = 64 };
#else
enum { RUN_PIXELS = PEL_BUFFER_PIXELS < 16 ? 8 : 16 };
#endif

/* Is an opaque colour the pixel itself? In xrgb8888 on a little-endian CPU. */
static bool color_is_pixel(const struct pel_format *format)
{
    return format->id == PEL_FORMAT_XRGB8888 && PEL_LE32(UINT32_C(1)) == 1;
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    for (int32_t part; n > 0; n -= part, x += part, colors += part) {
        part = pel_min(n, PEL_BUFFER_PIXELS);
        pel_put_colors(s, x, y, part, colors);
    }
}

/* One run, through a short buffer; parts begin at multiples of its length,
 * where the pieces of curve.h do. */
static void fill_run(const struct pel_color_paint *p,
                     const struct pel_surface *s, int32_t y,
                     const struct pel_row *row)
{
    pel_color colors[RUN_PIXELS];
    for (int32_t x = row->x0, n; x < row->x1; x += n) {
        n = pel_min(row->x1 - x, RUN_PIXELS - (x & (RUN_PIXELS - 1)));
        p->colors(p, x, y, n, colors);
        if (p->opaque)
            s->format->put(s, x, y, n, colors);
        else
            put(s, x, y, n, colors);
    }
}

void pel_color_paint_fill(const struct pel_paint *paint,
                          const struct pel_rows *rows)
{
    const struct pel_color_paint *p = (const void *)paint;
    const struct pel_surface *s = rows->surface;
    const bool in_place = p->opaque && color_is_pixel(s->format);
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    PEL_ASSERT(s->format->put); /* not a fill-only twin */
    if (!s->format->put || (p->direct && p->direct(p, rows)))
        return;
    for (int i = 0; i < rows->n; i++, row++, y += rows->step) {
        if (!in_place)
            fill_run(p, s, y, row);
        else if (row->x0 < row->x1)
            p->colors(p, row->x0, y, row->x1 - row->x0,
                      pel_address32(s, row->x0, y));
    }
}
