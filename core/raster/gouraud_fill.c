#include "gouraud.h"
#include "gouraud_spans.h"

/* n colors from pixel (x, y) on, alpha included. */
static PEL_NOINLINE void colors_of_span(const struct pel_gouraud *g, int32_t x,
                                        int32_t y, int32_t n, pel_color *colors)
{
    uint32_t v[3];
    pel_gouraud_at(g, x, y, v);
    uint32_t alpha = g->at[3] + (uint32_t)x * g->dx[3] + (uint32_t)y * g->dy[3];
    for (; n > 0; n--) {
        *colors++ = (pel_gouraud_xrgb(v) & 0xFFFFFFu) | (alpha >> 24) << 24;
        pel_gouraud_step(v, g->dx);
        alpha += g->dx[3];
    }
}

/* With constant `bytes` of a pixel, each of which has a loop of its own. */
static PEL_ALWAYS_INLINE void fill_words(const struct pel_gouraud *g,
                                         const struct pel_spans *spans,
                                         int bytes)
{
    const struct pel_gouraud_steps steps =
        pel_gouraud_steps_make(g, 4u / (unsigned)bytes);
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        const int32_t x = spans->span[i].x0, n = spans->span[i].x1 - x;
        uint32_t v[3];
        pel_gouraud_at(g, x, y, v);
        if (bytes == 4)
            pel_gouraud_span_xrgb(pel_address32(spans->surface, x, y), n, v,
                                  &steps);
        else
            pel_gouraud_span_rgb565(pel_address16(spans->surface, x, y), n, v,
                                    &steps);
    }
}

static PEL_NOINLINE void fill_xrgb(const struct pel_gouraud *g,
                                   const struct pel_spans *spans)
{
    fill_words(g, spans, 4);
}

static PEL_NOINLINE void fill_rgb565(const struct pel_gouraud *g,
                                     const struct pel_spans *spans)
{
    fill_words(g, spans, 2);
}

/* False: the format has no writer of planes. */
static PEL_NOINLINE bool fill_planes(const struct pel_gouraud *g,
                                     const struct pel_surface *s, int32_t y,
                                     const struct pel_span *span)
{
    const struct pel_channels *const c = s->format->channels;
    struct pel_planes planes = {{0}, {g->dx[0], g->dx[1], g->dx[2]}};
    if (!c || !c->planes || !pel_gouraud_opaque(g) || span->x0 >= span->x1)
        return false;
    pel_gouraud_at(g, span->x0, y, planes.at);
    return c->planes(s, span->x0, y, span->x1 - span->x0, &planes);
}

/* Through the format's writer of planes, or a short buffer. */
static PEL_NOINLINE void fill_any(const struct pel_gouraud *g,
                                  const struct pel_spans *spans)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        struct pel_span part = spans->span[i];
        if (PEL_KNOW_SIDES && fill_planes(g, spans->surface, y, &part))
            continue;
        for (int32_t n; part.x0 < part.x1; part.x0 += n) {
            n = pel_min(part.x1 - part.x0, PEL_BUFFER_PIXELS);
            colors_of_span(g, part.x0, y, n, colors);
            pel_put_colors(spans->surface, part.x0, y, n, colors);
        }
    }
}

void pel_gouraud_fill(const struct pel_paint *paint,
                      const struct pel_spans *spans)
{
    const struct pel_gouraud *g = (const struct pel_gouraud *)paint;
    const int bytes = pel_gouraud_bytes(g, spans->surface->format);
    if (bytes == 2)
        fill_rgb565(g, spans);
    else if (PEL_KNOW_SIDES && bytes == 4)
        fill_xrgb(g, spans);
    else
        fill_any(g, spans);
}
