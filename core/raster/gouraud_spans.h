/* Opaque Gouraud spans of xrgb8888 and rgb565_le by vectors: the same bytes as
 * the formats' own pack makes. Channels are 8.24, and stay in registers. */
#ifndef PEL_RASTER_GOURAUD_SPANS_H
#define PEL_RASTER_GOURAUD_SPANS_H

#include "../format/span16.h"
#include "gouraud.h"

/* Bytes of a pixel where a writer can paint it; 0 elsewhere. */
static inline int pel_gouraud_bytes(const struct pel_gouraud *g,
                                    const struct pel_format *format)
{
    if (!pel_gouraud_opaque(g) || !format->put)
        return 0;
    if (format->id == PEL_FORMAT_RGB565_LE)
        return 2;
    return PEL_VECTORS && format->id == PEL_FORMAT_XRGB8888 ? 4 : 0;
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

#if PEL_VECTORS

/* Blue, green and red of four pixels. */
struct pel_gouraud_four {
    pel_u32x4 v[3];
};

/* Of the channels, the same in all spans of a triangle. */
struct pel_gouraud_steps {
    uint32_t dx[3];
    struct pel_gouraud_four lanes; /* from the first lane's pixel to each */
    struct pel_gouraud_four four;  /* lanes on */
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

/* For pixels of 4 or 2 bytes; of 2 there are two to a lane. */
static inline struct pel_gouraud_steps pel_gouraud_steps_make(
    const struct pel_gouraud *g, int bytes)
{
    const pel_u32x4 odd = {0, ~0u, 0, ~0u};
    const pel_u32x4 upper = {0, 0, ~0u, ~0u};
    struct pel_gouraud_steps s;
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        const pel_u32x4 zero = {0, 0, 0, 0};
        const pel_u32x4 d = zero + (bytes == 2 ? 2 : 1) * g->dx[k];
        s.dx[k] = g->dx[k];
        s.lanes.v[k] = (d & odd) + ((d << 1) & upper);
        s.four.v[k] = d << 2;
    }
    return s;
}

static PEL_ALWAYS_INLINE pel_u32x4 pel_gouraud_xrgb4(struct pel_gouraud_four c)
{
    return (c.v[2] >> 8 & 0xFF0000u) | (c.v[1] >> 16 & 0xFF00u) | c.v[0] >> 24 |
           UINT32_C(0xFF000000);
}

/* Eight pixels: the lanes hold pixels 0, 2, 4, 6; one step on 1, 3, 5, 7. */
static PEL_ALWAYS_INLINE pel_u32x4
pel_gouraud_rgb565x8(struct pel_gouraud_four c, const uint32_t dx[3])
{
    const pel_u32x4 low =
        (c.v[2] >> 16 & 0xF800u) | (c.v[1] >> 21 & 0x07E0u) | c.v[0] >> 27;
    c = pel_gouraud_add(c, pel_gouraud_times(dx, 1));
    return low | (c.v[2] & 0xF8000000u) | (c.v[1] >> 5 & 0x07E00000u) |
           (c.v[0] >> 11 & 0x001F0000u);
}

/* Stores eight pixels and moves on to the next eight; with constant `bytes`. */
static PEL_ALWAYS_INLINE void pel_gouraud_put8(
    uintptr_t p, struct pel_gouraud_four *c, const struct pel_gouraud_steps *s,
    int bytes)
{
    if (bytes == 4) {
        pel_put_u32x4((void *)p, pel_gouraud_xrgb4(*c));
        *c = pel_gouraud_add(*c, s->four);
        pel_put_u32x4((void *)(p + 16), pel_gouraud_xrgb4(*c));
    } else {
        pel_put_u32x4((void *)p, pel_gouraud_rgb565x8(*c, s->dx));
    }
    *c = pel_gouraud_add(*c, s->four);
}

/* Stores n < 8. */
static PEL_ALWAYS_INLINE void pel_gouraud_few(uintptr_t p, int32_t n,
                                              struct pel_gouraud_four c,
                                              const struct pel_gouraud_steps *s,
                                              int bytes)
{
    const uint32_t last = (uint32_t)n - 4;
    if (bytes == 2) {
        const pel_u32x4 eight = pel_gouraud_rgb565x8(c, s->dx);
        pel_put_part16((pel_word16 *)p, n, (pel_u16x8)eight);
    } else if (n < 4) {
        pel_put_part32((pel_word32 *)p, n, pel_gouraud_xrgb4(c));
    } else {
        pel_put_u32x4((void *)p, pel_gouraud_xrgb4(c));
        c = pel_gouraud_add(c, pel_gouraud_times(s->dx, last));
        pel_put_u32x4((void *)(p + 4 * last), pel_gouraud_xrgb4(c));
    }
}

/* n pixels, of which the first has the channels v; the last eight overlap those
 * before them. */
static PEL_ALWAYS_INLINE void pel_gouraud_span(
    uintptr_t p, int32_t n, const uint32_t v[3],
    const struct pel_gouraud_steps *s, int bytes)
{
    struct pel_gouraud_four c =
        pel_gouraud_add(s->lanes, pel_gouraud_times(v, 1));
    if (n < 8) {
        pel_gouraud_few(p, n, c, s, bytes);
        return;
    }
    const uint32_t last = (uint32_t)n - 8;
    const uintptr_t end = p + (uintptr_t)bytes * last;
    struct pel_gouraud_four tail =
        pel_gouraud_add(c, pel_gouraud_times(s->dx, last));
    pel_gouraud_put8(p, &c, s, bytes);
    pel_gouraud_put8(end, &tail, s, bytes);
    while ((p += 8u * (unsigned)bytes) < end)
        pel_gouraud_put8(p, &c, s, bytes);
}

#endif
#endif
