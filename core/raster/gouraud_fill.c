#include "gouraud.h"

/* The four channels of one pixel, and the step to the next. */
static pel_color color_of(const uint32_t v[4])
{
    return (v[3] >> 24) << 24 | (v[2] >> 24) << 16 | (v[1] >> 24) << 8 |
           v[0] >> 24;
}

static void colors_of_run(const struct pel_gouraud *g, int32_t x, int32_t y,
                          int32_t n, pel_color *colors)
{
    uint32_t v[4];
    for (int k = 0; k < 4; k++)
        v[k] = g->at[k] + (uint32_t)x * g->dx[k] + (uint32_t)y * g->dy[k];
    for (; n > 0; n--) {
        *colors++ = color_of(v);
        for (int k = 0; k < 4; k++)
            v[k] += g->dx[k];
    }
}

/* One run, through a short buffer. */
static void fill_run(const struct pel_gouraud *g, const struct pel_surface *s,
                     int32_t y, const struct pel_row *row)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    for (int32_t x = row->x0, n; x < row->x1; x += n) {
        n = pel_min(row->x1 - x, PEL_BUFFER_PIXELS);
        colors_of_run(g, x, y, n, colors);
        if (!g->opaque)
            pel_put_colors(s, x, y, n, colors);
        else if (s->format->store)
            s->format->store(s, x, y, n, colors);
    }
}

void pel_gouraud_fill(const struct pel_paint *paint,
                      const struct pel_rows *rows)
{
    const struct pel_gouraud *g = (const struct pel_gouraud *)paint;
    int32_t y = rows->y;
    PEL_ASSERT(rows->surface->format->store); /* not a fill-only twin */
    for (int i = 0; i < rows->n; i++, y += rows->step)
        fill_run(g, rows->surface, y, &rows->row[i]);
}
