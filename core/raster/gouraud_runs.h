/* Runs of opaque Gouraud colours straight into the formats that matter: the
 * channels stay in 8.24 registers and meet in the pixel. Same bytes as colours
 * that go through a format's pack. */
#ifndef PEL_RASTER_GOURAUD_RUNS_H
#define PEL_RASTER_GOURAUD_RUNS_H

#include "../format/vector.h"
#include "../format/word16.h"
#include "../format/word32.h"
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

static inline uint32_t pel_gouraud_rgb565(const uint32_t v[3])
{
    return (v[2] >> 27) << 11 | (v[1] >> 26) << 5 | v[0] >> 27;
}

static inline void pel_gouraud_step(uint32_t v[3], const uint32_t dx[3])
{
    v[0] += dx[0];
    v[1] += dx[1];
    v[2] += dx[2];
}

#if PEL_VECTORS

/* Lanes of one channel: pixels 0, 1, 2, 3 or 0, 2, 4, 6 from v on. */
static inline pel_u32x4 pel_gouraud_lanes(uint32_t v, uint32_t dx)
{
    return (pel_u32x4){v, v + dx, v + 2 * dx, v + 3 * dx};
}

/* Four pixels from the lanes of blue, green, red. */
static inline pel_u32x4 pel_gouraud_xrgb4(pel_u32x4 b, pel_u32x4 g, pel_u32x4 r)
{
    return (r >> 8 & 0xFF0000u) | (g >> 16 & 0xFF00u) | b >> 24 |
           UINT32_C(0xFF000000);
}

/* The last four pixels overlap those before them. */
static PEL_ALWAYS_INLINE void pel_gouraud_run_xrgb(pel_word32 *p, int32_t n,
                                                   uint32_t v[3],
                                                   const uint32_t dx[3])
{
    if (n < 4) {
        for (; n > 0; n--, pel_gouraud_step(v, dx))
            *p++ = pel_gouraud_xrgb(v);
        return;
    }
    const uint32_t last = (uint32_t)n - 4;
    pel_word32 *end = p + last;
    const pel_u32x4 zero = {0, 0, 0, 0};
    pel_u32x4 b = pel_gouraud_lanes(v[0], dx[0]);
    pel_u32x4 g = pel_gouraud_lanes(v[1], dx[1]);
    pel_u32x4 r = pel_gouraud_lanes(v[2], dx[2]);
    const pel_u32x4 db = zero + 4 * dx[0], dg = zero + 4 * dx[1],
                    dr = zero + 4 * dx[2];
    const pel_u32x4 tail =
        pel_gouraud_xrgb4(b + last * dx[0], g + last * dx[1], r + last * dx[2]);
    for (; p < end; p += 4) {
        pel_put_u32x4(p, pel_gouraud_xrgb4(b, g, r));
        b += db;
        g += dg;
        r += dr;
    }
    pel_put_u32x4(end, tail);
}

/* Eight pixels from the lanes of pixels 0, 2, 4, 6, half a step before those of
 * 1, 3, 5, 7. */
static inline pel_u32x4 pel_gouraud_rgb565x8(const pel_u32x4 even[3],
                                             const uint32_t dx[3])
{
    pel_u32x4 b = even[0] + dx[0], g = even[1] + dx[1], r = even[2] + dx[2];
    pel_u32x4 low =
        (even[2] >> 27) << 11 | (even[1] >> 26) << 5 | even[0] >> 27;
    pel_u32x4 high = (r >> 27) << 11 | (g >> 26) << 5 | b >> 27;
    return low | high << 16;
}

static PEL_ALWAYS_INLINE void pel_gouraud_run_rgb565(pel_word16 *p, int32_t n,
                                                     uint32_t v[3],
                                                     const uint32_t dx[3])
{
    if (n < 8) {
        for (; n > 0; n--, pel_gouraud_step(v, dx))
            *p++ = (pel_word16)pel_gouraud_rgb565(v);
        return;
    }
    const uint32_t last = (uint32_t)n - 8;
    pel_word16 *end = p + last;
    pel_u32x4 lanes[3], tail[3];
    for (int k = 0; k < 3; k++) {
        lanes[k] = pel_gouraud_lanes(v[k], 2 * dx[k]);
        tail[k] = lanes[k] + last * dx[k];
    }
    for (; p < end; p += 8) {
        pel_put_u32x4(p, pel_gouraud_rgb565x8(lanes, dx));
        for (int k = 0; k < 3; k++)
            lanes[k] += 8 * dx[k];
    }
    pel_put_u32x4(end, pel_gouraud_rgb565x8(tail, dx));
}

#else

static inline void pel_gouraud_run_xrgb(pel_word32 *p, int32_t n, uint32_t v[3],
                                        const uint32_t dx[3])
{
    for (; n > 0; n--, pel_gouraud_step(v, dx))
        *p++ = PEL_LE32(pel_gouraud_xrgb(v));
}

/* Two pixels a turn, for the sake of the loop's own cost. */
static inline void pel_gouraud_run_rgb565(pel_word16 *p, int32_t n,
                                          uint32_t v[3], const uint32_t dx[3])
{
    for (; n >= 2; n -= 2, p += 2) {
        p[0] = (pel_word16)PEL_LE16(pel_gouraud_rgb565(v));
        pel_gouraud_step(v, dx);
        p[1] = (pel_word16)PEL_LE16(pel_gouraud_rgb565(v));
        pel_gouraud_step(v, dx);
    }
    if (n > 0)
        *p = (pel_word16)PEL_LE16(pel_gouraud_rgb565(v));
}

#endif
#endif
