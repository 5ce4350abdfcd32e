/* Writers of opaque Gouraud spans in xrgb8888 and rgb565_le, with the channels
 * in registers, as 8.24. The bytes are those of the formats' own pack. */
#ifndef PEL_RASTER_GOURAUD_SPANS_H
#define PEL_RASTER_GOURAUD_SPANS_H

#include "../format/vector.h"
#include "../format/word.h"
#include "gouraud.h"

/* Blue, green and red at pixel (x, y). */
static PEL_ALWAYS_INLINE void pel_gouraud_at(const struct pel_gouraud *g,
                                             int32_t x, int32_t y,
                                             uint32_t v[3])
{
    for (int k = 0; k < 3; k++)
        v[k] = g->at[k] + (uint32_t)x * g->dx[k] + (uint32_t)y * g->dy[k];
}

static inline uint32_t pel_gouraud_xrgb(const uint32_t v[3])
{
    return UINT32_C(0xFF000000) | (v[2] >> 24) << 16 | (v[1] >> 24) << 8 |
           v[0] >> 24;
}

static inline pel_word16 pel_gouraud_word565(uint32_t b, uint32_t g, uint32_t r)
{
    return (pel_word16)PEL_LE16((r >> 27) << 11 | (g >> 26) << 5 | b >> 27);
}

static inline void pel_gouraud_step(uint32_t v[3], const uint32_t dx[3])
{
    v[0] += dx[0];
    v[1] += dx[1];
    v[2] += dx[2];
}

/* pel_gouraud_steps: steps of the channels, the same in all spans of a
 * triangle. `apart`: pixels from lane to lane; a store is 4 * apart pixels. */
#if PEL_VECTORS

struct pel_gouraud_steps {
    uint32_t dx[3];
    pel_u32x4 lanes[3]; /* from the first lane's pixel to each lane's */
    pel_u32x4 steps[3]; /* from a vector of pixels to the next */
};

static inline struct pel_gouraud_steps pel_gouraud_steps_make(
    const struct pel_gouraud *g, uint32_t apart)
{
    struct pel_gouraud_steps s;
    for (int k = 0; k < 3; k++) {
        const pel_u32x4 zero = {0, 0, 0, 0}, odd = {0, ~0u, 0, ~0u},
                        upper = {0, 0, ~0u, ~0u};
        const pel_u32x4 d = zero + apart * g->dx[k];
        s.dx[k] = g->dx[k];
        s.lanes[k] = (d & odd) + ((d << 1) & upper);
        s.steps[k] = d << 2;
    }
    return s;
}

static inline pel_u32x4 pel_gouraud_xrgb4(pel_u32x4 b, pel_u32x4 g, pel_u32x4 r)
{
    return (r >> 8 & 0xFF0000u) | (g >> 16 & 0xFF00u) | b >> 24 |
           UINT32_C(0xFF000000);
}

/* Stores the first n < 4 of four pixels, as pel_span32_short. */
static inline void pel_gouraud_short_xrgb(pel_word32 *p, int32_t n,
                                          pel_u32x4 pixels)
{
    uint32_t four[4];
    pel_word32 elsewhere;
    pel_word32 *q = n > 0 ? p : &elsewhere;
    int32_t last = n > 0 ? n - 1 : 0, half = (last + 1) >> 1;
    pel_put_u32x4(four, pixels);
    q[0] = four[0];
    q[half] = four[half];
    q[last] = four[last];
}

/* Stores n > 8 pixels; the last eight overlap those before them. */
static PEL_ALWAYS_INLINE void pel_gouraud_long_xrgb(
    pel_word32 *p, int32_t n, pel_u32x4 v[3], const struct pel_gouraud_steps *s)
{
    const uint32_t last = (uint32_t)n - 8;
    pel_word32 *const end = p + last;
    pel_u32x4 b = v[0], g = v[1], r = v[2];
    pel_u32x4 tail_b = b + last * s->dx[0], tail_g = g + last * s->dx[1],
              tail_r = r + last * s->dx[2];
    do {
        pel_put_u32x4(p, pel_gouraud_xrgb4(b, g, r));
        b += s->steps[0];
        g += s->steps[1];
        r += s->steps[2];
        pel_put_u32x4(p + 4, pel_gouraud_xrgb4(b, g, r));
        b += s->steps[0];
        g += s->steps[1];
        r += s->steps[2];
        p += 8;
    } while (p < end);
    pel_put_u32x4(end, pel_gouraud_xrgb4(tail_b, tail_g, tail_r));
    pel_put_u32x4(end + 4,
                  pel_gouraud_xrgb4(tail_b + s->steps[0], tail_g + s->steps[1],
                                    tail_r + s->steps[2]));
}

static PEL_ALWAYS_INLINE void pel_gouraud_span_xrgb(
    pel_word32 *p, int32_t n, uint32_t v[3], const struct pel_gouraud_steps *s)
{
    pel_u32x4 lane[3] = {s->lanes[0] + v[0], s->lanes[1] + v[1],
                         s->lanes[2] + v[2]};
    if (n > 8) {
        pel_gouraud_long_xrgb(p, n, lane, s);
        return;
    }
    const pel_u32x4 first = pel_gouraud_xrgb4(lane[0], lane[1], lane[2]);
    if (n < 4) {
        pel_gouraud_short_xrgb(p, n, first);
        return;
    }
    const uint32_t last = (uint32_t)n - 4;
    pel_put_u32x4(p, first);
    pel_put_u32x4(p + last, pel_gouraud_xrgb4(lane[0] + last * s->dx[0],
                                              lane[1] + last * s->dx[1],
                                              lane[2] + last * s->dx[2]));
}

/* Eight pixels: the lanes hold pixels 0, 2, 4, 6; one step on 1, 3, 5, 7. */
static PEL_ALWAYS_INLINE pel_u32x4 pel_gouraud_rgb565x8(pel_u32x4 b,
                                                        pel_u32x4 g,
                                                        pel_u32x4 r,
                                                        const uint32_t dx[3])
{
    pel_u32x4 low = (r >> 16 & 0xF800u) | (g >> 21 & 0x07E0u) | b >> 27;
    b += dx[0];
    g += dx[1];
    r += dx[2];
    pel_u32x4 high =
        (r & 0xF8000000u) | (g >> 5 & 0x07E00000u) | (b >> 11 & 0x001F0000u);
    return low | high;
}

/* Stores the first n < 8 of eight pixels, by two stores that may overlap. */
static inline void pel_gouraud_short_rgb565(pel_word16 *p, int32_t n,
                                            pel_u32x4 pixels)
{
    uint16_t eight[8];
    pel_put_u32x4(eight, pixels);
    if (n >= 4) {
        memcpy(p, eight, 8);
        memcpy(p + n - 4, eight + n - 4, 8);
        return;
    }
    pel_word16 elsewhere;
    pel_word16 *q = n > 0 ? p : &elsewhere;
    int32_t last = n > 0 ? n - 1 : 0, half = (last + 1) >> 1;
    q[0] = eight[0];
    q[half] = eight[half];
    q[last] = eight[last];
}

static PEL_ALWAYS_INLINE void pel_gouraud_span_rgb565(
    pel_word16 *p, int32_t n, uint32_t v[3], const struct pel_gouraud_steps *s)
{
    pel_u32x4 b = s->lanes[0] + v[0], g = s->lanes[1] + v[1],
              r = s->lanes[2] + v[2];
    const pel_u32x4 first = pel_gouraud_rgb565x8(b, g, r, s->dx);
    if (n < 8) {
        pel_gouraud_short_rgb565(p, n, first);
        return;
    }
    const uint32_t last = (uint32_t)n - 8;
    pel_word16 *end = p + last;
    pel_put_u32x4(p, first);
    pel_put_u32x4(end,
                  pel_gouraud_rgb565x8(b + last * s->dx[0], g + last * s->dx[1],
                                       r + last * s->dx[2], s->dx));
    while ((p += 8) < end) {
        b += s->steps[0];
        g += s->steps[1];
        r += s->steps[2];
        pel_put_u32x4(p, pel_gouraud_rgb565x8(b, g, r, s->dx));
    }
}

#else

struct pel_gouraud_steps {
    uint32_t dx[3];
};

static inline struct pel_gouraud_steps pel_gouraud_steps_make(
    const struct pel_gouraud *g, uint32_t apart)
{
    (void)apart;
    return (struct pel_gouraud_steps){{g->dx[0], g->dx[1], g->dx[2]}};
}

static inline void pel_gouraud_span_xrgb(pel_word32 *p, int32_t n,
                                         uint32_t v[3],
                                         const struct pel_gouraud_steps *s)
{
    for (; n > 0; n--, pel_gouraud_step(v, s->dx))
        *p++ = PEL_LE32(pel_gouraud_xrgb(v));
}

/* Channels and steps have variables of their own, which stay in registers; four
 * pixels a turn share the cost of the loop. */
static inline void pel_gouraud_span_rgb565(pel_word16 *p, int32_t n,
                                           uint32_t v[3],
                                           const struct pel_gouraud_steps *s)
{
    uint32_t b = v[0], g = v[1], r = v[2];
    const uint32_t db = s->dx[0], dg = s->dx[1], dr = s->dx[2];
    for (; n >= 4; n -= 4, p += 4) {
        p[0] = pel_gouraud_word565(b, g, r);
        b += db;
        g += dg;
        r += dr;
        p[1] = pel_gouraud_word565(b, g, r);
        b += db;
        g += dg;
        r += dr;
        p[2] = pel_gouraud_word565(b, g, r);
        b += db;
        g += dg;
        r += dr;
        p[3] = pel_gouraud_word565(b, g, r);
        b += db;
        g += dg;
        r += dr;
    }
    for (; n > 0; n--) {
        *p++ = pel_gouraud_word565(b, g, r);
        b += db;
        g += dg;
        r += dr;
    }
}

#endif
#endif
