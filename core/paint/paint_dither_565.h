/* Dithered rows of pixels of 5-6-5 bits, R 15..11, whose two bytes may be
 * swapped. */
#ifndef PEL_PAINT_PAINT_DITHER_565_H
#define PEL_PAINT_PAINT_DITHER_565_H

#include "../raster/gouraud_spans.h"

/* A row of the matrix has eight thresholds of 5 bits, and of 6 bits right
 * behind them. */
enum { PEL_PLACES = 8 };

/* A row of pixels, and where the threshold of its first one is; after that of
 * the eighth place follows that of the first. */
struct pel_row565 {
    pel_word16 *p, *end;
    const uint8_t *place, *wrap;
};

/* Channels times 2^n - 1, red and blue in the halves of a word. */
struct pel_steps565 {
    uint32_t red_blue, green;
};

static PEL_ALWAYS_INLINE struct pel_steps565 pel_steps565(uint32_t red_blue,
                                                          uint32_t green)
{
    const struct pel_steps565 s = {(red_blue << 5) - red_blue,
                                   (green << 6) - green};
    return s;
}

static PEL_ALWAYS_INLINE struct pel_steps565 pel_steps565_of(pel_color c)
{
    return pel_steps565(c & 0xFF00FFu, c >> 8 & 0xFFu);
}

static PEL_ALWAYS_INLINE void pel_row565_store(struct pel_row565 *r,
                                               struct pel_steps565 s,
                                               bool swapped)
{
    const uint32_t five = r->place[0], six = r->place[PEL_PLACES];
    const uint32_t rb = s.red_blue + (five | five << 16), g = s.green + six;
    const uint32_t levels = rb & UINT32_C(0x1F001F00);
    const uint32_t pixel = levels >> 13 | g >> 8 << 5 | levels >> 8;
    *r->p++ = (pel_word16)(swapped ? pel_swap16(pixel) : pixel);
    if (++r->place == r->wrap)
        r->place -= PEL_PLACES;
}

/* One colour. */
#if PEL_VECTORS

static inline pel_u16x8 pel_row565_places(const struct pel_row565 *r,
                                          const uint8_t *places)
{
    const int turn = 8 * (int)(r->place - (r->wrap - PEL_PLACES));
    uint64_t t;
    memcpy(&t, places, PEL_PLACES);
    const pel_u64x2 turned = {t >> turn | t << (-turn & 63), 0};
    const pel_u8x16 zero = {0};
    return (pel_u16x8)pel_zip_low_u8x16((pel_u8x16)turned, zero);
}

static PEL_ALWAYS_INLINE void pel_row565_fill(struct pel_row565 r,
                                              struct pel_steps565 s,
                                              bool swapped)
{
    const pel_u16x8 five = pel_row565_places(&r, r.wrap - PEL_PLACES);
    const pel_u16x8 six = pel_row565_places(&r, r.wrap);
    pel_u16x8 v = ((five + (uint16_t)(s.red_blue >> 16)) << 3 & 0xF800) |
                  ((six + (uint16_t)s.green) >> 3 & 0x07E0) |
                  (five + (uint16_t)s.red_blue) >> 8;
    if (swapped)
        v = v << 8 | v >> 8;
    for (; r.end - r.p >= 8; r.p += 8)
        pel_put_u16x8(r.p, v);
    pel_gouraud_short_rgb565(r.p, (int32_t)(r.end - r.p), (pel_u32x4)v);
}

#else

static PEL_ALWAYS_INLINE void pel_row565_fill(struct pel_row565 r,
                                              struct pel_steps565 s,
                                              bool swapped)
{
    const bool repeats = r.end - r.p >= 2 * PEL_PLACES;
    pel_word16 *const stop = repeats ? r.p + PEL_PLACES : r.end;
    while (r.p < stop)
        pel_row565_store(&r, s, swapped);
    if (repeats)
        pel_pattern16(r.p, (int32_t)(r.end - r.p));
}

#endif

/* How many colours before the first that is not opaque. */
static PEL_ALWAYS_INLINE int32_t pel_row565_put(struct pel_row565 r,
                                                const pel_color *colors,
                                                bool swapped)
{
    const pel_color *c = colors;
    for (; r.p < r.end && pel_alpha(*c) == 255; c++)
        pel_row565_store(&r, pel_steps565_of(*c), swapped);
    return (int32_t)(c - colors);
}

static PEL_ALWAYS_INLINE void pel_row565_planes(struct pel_row565 r,
                                                const struct pel_planes *planes,
                                                bool swapped)
{
    uint32_t blue = planes->at[0], green = planes->at[1], red = planes->at[2];
    const uint32_t db = planes->dx[0], dg = planes->dx[1], dr = planes->dx[2];
    for (; r.p < r.end; blue += db, green += dg, red += dr)
        pel_row565_store(
            &r, pel_steps565(red >> 24 << 16 | blue >> 24, green >> 24),
            swapped);
}

#endif
