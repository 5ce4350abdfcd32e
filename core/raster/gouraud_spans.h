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

#if PEL_VECTORS

/* A pixel's channels are the lanes of a vector: blue, green, red and an alpha
 * of 255, which is the X of xrgb8888. Of rgb565 each channel has a vector,
 * whose lanes are pixels 0, 2, 4, 6 of eight; one step on they are 1, 3, 5, 7.
 */
struct pel_gouraud_steps {
    pel_u32x4 dx, dy;
    pel_u32x4 on[3];            /* from a vector of pixels to the next */
    pel_u32x4 even[3], next[3]; /* to pixels 0, 2, 4, 6; one step on */
};

/* For pixels of 4 bytes, where only dx, dy and on[0] count, or 2. */
static PEL_ALWAYS_INLINE struct pel_gouraud_steps pel_gouraud_steps_make(
    const struct pel_gouraud *g, int bytes)
{
    const pel_u32x4 zero = {0, 0, 0, 0}, evens = {0, 2, 4, 6};
    struct pel_gouraud_steps s;
    s.dx = pel_get_u32x4(g->dx);
    s.dy = pel_get_u32x4(g->dy);
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        s.next[k] = zero + g->dx[k];
        s.even[k] = evens * g->dx[k];
        s.on[k] = s.next[k] << 3;
    }
    if (bytes == 4)
        s.on[0] = 4 * s.dx;
    return s;
}

/* Channels at column 0 of row y. */
static inline pel_u32x4 pel_gouraud_row(const struct pel_gouraud *g, int32_t y)
{
    return pel_get_u32x4(g->at) + (uint32_t)y * pel_get_u32x4(g->dy);
}

/* Four pixels of xrgb8888 from the one with the channels c on, whose alpha is
 * 255 and stays so: it becomes the X byte. */
static PEL_ALWAYS_INLINE pel_u32x4 pel_gouraud_xrgb4(pel_u32x4 c, pel_u32x4 dx)
{
    const pel_u32x4 next = c + dx, third = next + dx, last = third + dx;
    const pel_u8x16 low =
        pel_join_u8x16((pel_u16x8)(c >> 24), (pel_u16x8)(next >> 24));
    const pel_u8x16 high =
        pel_join_u8x16((pel_u16x8)(third >> 24), (pel_u16x8)(last >> 24));
    return (pel_u32x4)pel_join_u8x16((pel_u16x8)low, (pel_u16x8)high);
}

/* What a vector of pixels is made from; of xrgb8888 v[0] is the first one. */
struct pel_gouraud_pixels {
    pel_u32x4 v[3];
};

/* From the pixel with the channels c on. */
static PEL_ALWAYS_INLINE struct pel_gouraud_pixels pel_gouraud_start(
    pel_u32x4 c, const struct pel_gouraud_steps *s, int bytes)
{
    struct pel_gouraud_pixels p = {{c, c, c}};
    if (bytes == 2) {
        p.v[0] = PEL_LANES(c, c, 0, 0, 0, 0) + s->even[0];
        p.v[1] = PEL_LANES(c, c, 1, 1, 1, 1) + s->even[1];
        p.v[2] = PEL_LANES(c, c, 2, 2, 2, 2) + s->even[2];
    }
    return p;
}

static PEL_ALWAYS_INLINE pel_u32x4
pel_gouraud_pack(const struct pel_gouraud_pixels *p,
                 const struct pel_gouraud_steps *s, int bytes)
{
    const pel_u32x4 b = p->v[0], g = p->v[1], r = p->v[2];
    if (bytes == 4)
        return pel_gouraud_xrgb4(b, s->dx);
    return (r >> 16 & 0xF800u) | (g >> 21 & 0x07E0u) | b >> 27 |
           ((r + s->next[2]) & 0xF8000000u) |
           ((g + s->next[1]) >> 5 & 0x07E00000u) |
           ((b + s->next[0]) >> 11 & 0x001F0000u);
}

/* n pixels, of which the first has the channels c; with constant `bytes`. The
 * last vector overlaps those before it. */
static PEL_ALWAYS_INLINE void pel_gouraud_span(
    uintptr_t p, int32_t n, pel_u32x4 c, const struct pel_gouraud_steps *s,
    int bytes)
{
    const uint32_t last = (uint32_t)(n - 16 / bytes);
    const uintptr_t end = p + (unsigned)bytes * (uintptr_t)last;
    struct pel_gouraud_pixels a = pel_gouraud_start(c, s, bytes);
    const pel_u32x4 first = pel_gouraud_pack(&a, s, bytes);
    if (n < 16 / bytes) {
        if (bytes == 4)
            pel_put_part32((pel_word32 *)p, n, first);
        else
            pel_put_part16((pel_word16 *)p, n, (pel_u16x8)first);
        return;
    }
    const struct pel_gouraud_pixels tail =
        pel_gouraud_start(c + last * s->dx, s, bytes);
    pel_put_u32x4((void *)p, first);
    pel_put_u32x4((void *)end, pel_gouraud_pack(&tail, s, bytes));
    while ((p += 16) < end) {
        PEL_UNROLL
        for (int k = 0; k < 3; k++)
            a.v[k] += s->on[k];
        pel_put_u32x4((void *)p, pel_gouraud_pack(&a, s, bytes));
    }
}

#endif
#endif
