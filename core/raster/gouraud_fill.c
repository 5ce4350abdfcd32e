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
        *colors++ = PEL_RGBA(v[2] >> 24, v[1] >> 24, v[0] >> 24, alpha >> 24);
        v[0] += g->dx[0];
        v[1] += g->dx[1];
        v[2] += g->dx[2];
        alpha += g->dx[3];
    }
}

#if PEL_VECTORS

/* With constant `bytes` of a pixel. */
static PEL_ALWAYS_INLINE void fill_words(const struct pel_gouraud *g,
                                         const struct pel_spans *spans,
                                         int bytes)
{
    const struct pel_gouraud_steps s = pel_gouraud_steps_make(g, bytes);
    const struct pel_span *span = spans->span, *const end = span + spans->n;
    const uintptr_t pitch = (uintptr_t)pel_spans_pitch(spans);
    const pel_u32x4 down = (uint32_t)spans->step * s.dy;
    uintptr_t row = pel_column_zero(spans->surface, spans->y, bytes);
    pel_u32x4 c = pel_gouraud_row(g, spans->y);
    for (; span < end; span++, row += pitch, c += down) {
        const int32_t x = span->x0;
        pel_gouraud_span(row + (unsigned)bytes * (uintptr_t)x, span->x1 - x,
                         c + (uint32_t)x * s.dx, &s, bytes);
    }
}

#else

/* n >= 1 pixels of rgb565_le. Channels and steps have variables of their own,
 * which stay in registers, as this is a function of its own. */
static PEL_NOINLINE void fill_row(const struct pel_gouraud *gouraud,
                                  pel_word16 *p, int32_t n, const uint32_t v[3])
{
    const uint32_t db = gouraud->dx[0], dg = gouraud->dx[1],
                   dr = gouraud->dx[2];
    uint32_t b = v[0], g = v[1], r = v[2];
#pragma GCC unroll 8
    do {
        const uint32_t pixel = (r >> 27) << 11 | (g >> 26) << 5 | b >> 27;
        *p++ = (pel_word16)PEL_LE16(pixel);
        b += db;
        g += dg;
        r += dr;
    } while (--n);
}

static PEL_NOINLINE void fill_words(const struct pel_gouraud *g,
                                    const struct pel_spans *spans, int bytes)
{
    const struct pel_span *span = spans->span, *const end = span + spans->n;
    int32_t y = spans->y;
    (void)bytes;
    for (; span < end; span++, y += spans->step) {
        uint32_t v[3];
        pel_gouraud_at(g, span->x0, y, v);
        if (span->x0 < span->x1)
            fill_row(g, pel_address16(spans->surface, span->x0, y),
                     span->x1 - span->x0, v);
    }
}

#endif

/* False: the format has no writer of planes. */
static PEL_NOINLINE bool fill_planes(const struct pel_gouraud *g,
                                     const struct pel_surface *s, int32_t y,
                                     const struct pel_span *span)
{
    const struct pel_channels *const c = s->format->channels;
    struct pel_planes planes;
    if (!c || !c->planes || !pel_gouraud_opaque(g) || span->x0 >= span->x1)
        return false;
    pel_gouraud_at(g, span->x0, y, planes.at);
    for (int k = 0; k < 3; k++)
        planes.dx[k] = g->dx[k];
    return c->planes(s, span->x0, y, span->x1 - span->x0, &planes);
}

/* Through the format's writer of planes, or a short buffer. */
static PEL_NOINLINE void fill_any(const struct pel_gouraud *g,
                                  const struct pel_spans *spans)
{
    pel_color colors[PEL_COLORS];
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        struct pel_span part = spans->span[i];
        if (!PEL_SMALL_CODE && fill_planes(g, spans->surface, y, &part))
            continue;
        for (int32_t n; part.x0 < part.x1; part.x0 += n) {
            n = pel_min(part.x1 - part.x0, PEL_COLORS);
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
        fill_words(g, spans, 2);
    else if (PEL_VECTORS && bytes == 4)
        fill_words(g, spans, 4);
    else
        fill_any(g, spans);
}
