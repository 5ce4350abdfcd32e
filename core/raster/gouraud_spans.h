/* Writers of opaque Gouraud spans in xrgb8888 and rgb565_le, the same bytes as
 * the formats' own pack makes. Channels are 8.24, and stay in registers. */
#ifndef PEL_RASTER_GOURAUD_SPANS_H
#define PEL_RASTER_GOURAUD_SPANS_H

#include "../format/vector.h"
#include "gouraud.h"

/* Bytes of a pixel where a writer can paint it; 0 elsewhere. */
static inline int pel_gouraud_bytes(const struct pel_gouraud *g,
                                    const struct pel_format *format)
{
    if (!pel_gouraud_opaque(g) || !format->put)
        return 0;
    if (format->id == PEL_FORMAT_RGB565_LE)
        return 2;
    return PEL_KNOW_SIDES && format->id == PEL_FORMAT_XRGB8888 ? 4 : 0;
}

/* Blue, green and red at pixel (x, y). */
static PEL_ALWAYS_INLINE void pel_gouraud_at(const struct pel_gouraud *g,
                                             int32_t x, int32_t y,
                                             uint32_t v[3])
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        v[k] = g->at[k] + (uint32_t)x * g->dx[k] + (uint32_t)y * g->dy[k];
}

static PEL_ALWAYS_INLINE void pel_gouraud_step(uint32_t v[3],
                                               const uint32_t dx[3])
{
    v[0] += dx[0];
    v[1] += dx[1];
    v[2] += dx[2];
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

/* pel_gouraud_steps: steps of the channels, the same in all spans of a
 * triangle. `apart`: pixels from lane to lane; a store is 4 * apart pixels. */
#if PEL_VECTORS

/* Blue, green and red of four pixels. */
struct pel_gouraud_four {
    pel_u32x4 v[3];
};

struct pel_gouraud_steps {
    uint32_t dx[3];
    struct pel_gouraud_four lanes; /* from the first lane's pixel to each */
    struct pel_gouraud_four few;   /* the same of pixels side by side */
    struct pel_gouraud_four next;  /* from a vector of pixels to the next */
};

static PEL_ALWAYS_INLINE struct pel_gouraud_four pel_gouraud_add(
    struct pel_gouraud_four a, struct pel_gouraud_four b)
{
    return (struct pel_gouraud_four){
        {a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2]}};
}

/* n v in every lane. */
static PEL_ALWAYS_INLINE struct pel_gouraud_four pel_gouraud_times(
    const uint32_t v[3], uint32_t n)
{
    const pel_u32x4 zero = {0, 0, 0, 0};
    return (struct pel_gouraud_four){
        {zero + n * v[0], zero + n * v[1], zero + n * v[2]}};
}

static inline struct pel_gouraud_steps pel_gouraud_steps_make(
    const struct pel_gouraud *g, uint32_t apart)
{
    const pel_u32x4 odd = {0, ~0u, 0, ~0u};
    const pel_u32x4 upper = {0, 0, ~0u, ~0u};
    struct pel_gouraud_steps s;
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        const pel_u32x4 zero = {0, 0, 0, 0}, d = zero + apart * g->dx[k];
        const pel_u32x4 one = zero + g->dx[k];
        s.dx[k] = g->dx[k];
        s.few.v[k] = (one & odd) + ((one << 1) & upper);
        s.lanes.v[k] = (d & odd) + ((d << 1) & upper);
        s.next.v[k] = d << 2;
    }
    return s;
}

static PEL_ALWAYS_INLINE pel_u32x4 pel_gouraud_xrgb4(struct pel_gouraud_four c)
{
    return (c.v[2] >> 8 & 0xFF0000u) | (c.v[1] >> 16 & 0xFF00u) | c.v[0] >> 24 |
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
    pel_word32 *p, int32_t n, struct pel_gouraud_four v,
    const struct pel_gouraud_steps *s)
{
    pel_word32 *const end = p + n - 8;
    const struct pel_gouraud_four tail =
        pel_gouraud_add(v, pel_gouraud_times(s->dx, (uint32_t)n - 8));
    do {
        pel_put_u32x4(p, pel_gouraud_xrgb4(v));
        v = pel_gouraud_add(v, s->next);
        pel_put_u32x4(p + 4, pel_gouraud_xrgb4(v));
        v = pel_gouraud_add(v, s->next);
        p += 8;
    } while (p < end);
    pel_put_u32x4(end, pel_gouraud_xrgb4(tail));
    pel_put_u32x4(end + 4, pel_gouraud_xrgb4(pel_gouraud_add(tail, s->next)));
}

static PEL_ALWAYS_INLINE void pel_gouraud_span_xrgb(
    pel_word32 *p, int32_t n, uint32_t v[3], const struct pel_gouraud_steps *s)
{
    const struct pel_gouraud_four four =
        pel_gouraud_add(s->lanes, pel_gouraud_times(v, 1));
    if (n > 8) {
        pel_gouraud_long_xrgb(p, n, four, s);
        return;
    }
    const pel_u32x4 first = pel_gouraud_xrgb4(four);
    if (n < 4) {
        pel_gouraud_short_xrgb(p, n, first);
        return;
    }
    const uint32_t last = (uint32_t)n - 4;
    pel_put_u32x4(p, first);
    pel_put_u32x4(p + last, pel_gouraud_xrgb4(pel_gouraud_add(
                                four, pel_gouraud_times(s->dx, last))));
}

static PEL_ALWAYS_INLINE pel_u32x4
pel_gouraud_rgb565x4(struct pel_gouraud_four c)
{
    return (c.v[2] >> 16 & 0xF800u) | (c.v[1] >> 21 & 0x07E0u) | c.v[0] >> 27;
}

/* Eight pixels: the lanes hold pixels 0, 2, 4, 6; one step on 1, 3, 5, 7. */
static PEL_ALWAYS_INLINE pel_u32x4
pel_gouraud_rgb565x8(struct pel_gouraud_four c, const uint32_t dx[3])
{
    const pel_u32x4 low = pel_gouraud_rgb565x4(c);
    c = pel_gouraud_add(c, pel_gouraud_times(dx, 1));
    return low | (c.v[2] & 0xF8000000u) | (c.v[1] >> 5 & 0x07E00000u) |
           (c.v[0] >> 11 & 0x001F0000u);
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
    struct pel_gouraud_four four = pel_gouraud_times(v, 1);
    if (n < 4) {
        const pel_u32x4 few =
            pel_gouraud_rgb565x4(pel_gouraud_add(s->few, four));
        pel_gouraud_short_rgb565(p, n, (pel_u32x4)pel_narrow_u16x8(few, few));
        return;
    }
    four = pel_gouraud_add(s->lanes, four);
    const pel_u32x4 first = pel_gouraud_rgb565x8(four, s->dx);
    if (n < 8) {
        pel_gouraud_short_rgb565(p, n, first);
        return;
    }
    const uint32_t last = (uint32_t)n - 8;
    pel_word16 *end = p + last;
    pel_put_u32x4(p, first);
    pel_put_u32x4(
        end, pel_gouraud_rgb565x8(
                 pel_gouraud_add(four, pel_gouraud_times(s->dx, last)), s->dx));
    while ((p += 8) < end) {
        four = pel_gouraud_add(four, s->next);
        pel_put_u32x4(p, pel_gouraud_rgb565x8(four, s->dx));
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
