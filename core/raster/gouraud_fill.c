#include "gouraud.h"
#include "gouraud_runs.h"

/* n colours from pixel (x, y) on, alpha included. */
static void colors_of_run(const struct pel_gouraud *g, const struct pel_row *at,
                          int32_t y, pel_color *colors)
{
    uint32_t v[3], x = (uint32_t)at->x0;
    pel_gouraud_at(g, at->x0, y, v);
    uint32_t alpha = g->at[3] + x * g->dx[3] + (uint32_t)y * g->dy[3];
    for (int32_t n = at->x1 - at->x0; n > 0; n--) {
        *colors++ = (pel_gouraud_xrgb(v) & 0xFFFFFFu) | (alpha >> 24) << 24;
        pel_gouraud_step(v, g->dx);
        alpha += g->dx[3];
    }
}

/* Any format, through a short buffer. */
static void fill_run(const struct pel_gouraud *g, const struct pel_surface *s,
                     int32_t y, const struct pel_row *row)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    struct pel_row part = *row;
    for (; part.x0 < row->x1; part.x0 = part.x1) {
        part.x1 = pel_min(row->x1, part.x0 + PEL_BUFFER_PIXELS);
        colors_of_run(g, &part, y, colors);
        if (g->opaque)
            s->format->store(s, part.x0, y, part.x1 - part.x0, colors);
        else
            pel_put_colors(s, part.x0, y, part.x1 - part.x0, colors);
    }
}

static void fill_run_xrgb(const struct pel_gouraud *g,
                          const struct pel_surface *s, int32_t y,
                          const struct pel_row *row)
{
    uint32_t v[3];
    pel_gouraud_at(g, row->x0, y, v);
    pel_gouraud_run_xrgb(pel_address32(s, row->x0, y), row->x1 - row->x0, v,
                         g->dx);
}

static void fill_run_rgb565(const struct pel_gouraud *g,
                            const struct pel_surface *s, int32_t y,
                            const struct pel_row *row)
{
    uint32_t v[3];
    pel_gouraud_at(g, row->x0, y, v);
    pel_gouraud_run_rgb565(pel_address16(s, row->x0, y), row->x1 - row->x0, v,
                           g->dx);
}

void pel_gouraud_fill(const struct pel_paint *paint,
                      const struct pel_rows *rows)
{
    const struct pel_gouraud *g = (const struct pel_gouraud *)paint;
    const struct pel_surface *s = rows->surface;
    int32_t y = rows->y;
    PEL_ASSERT(s->format->store); /* not a fill-only twin */
    if (!s->format->store)
        return;
    for (int32_t i = 0; i < rows->n; i++, y += rows->step)
        if (g->opaque && s->format->id == PEL_FORMAT_RGB565_LE)
            fill_run_rgb565(g, s, y, &rows->row[i]);
        else if (PEL_FAST_64BIT && g->opaque &&
                 s->format->id == PEL_FORMAT_XRGB8888)
            fill_run_xrgb(g, s, y, &rows->row[i]);
        else
            fill_run(g, s, y, &rows->row[i]);
}
