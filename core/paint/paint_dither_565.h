/* Dithered rows of pixels of 5-6-5 bits, R 15..11, whose two bytes may be
 * swapped. */
#ifndef PEL_PAINT_PAINT_DITHER_565_H
#define PEL_PAINT_PAINT_DITHER_565_H

#include "../format/span16.h"

enum { PEL_PLACES = 8 }; /* of a row of the matrix */

/* Channels times 2^n - 1, or thresholds: red and blue in the halves of a word.
 */
struct pel_steps565 {
    uint32_t red_blue, green;
};

/* A row of pixels from column x on. */
struct pel_row565 {
    pel_word16 *p, *end;
    const struct pel_steps565 *thresholds; /* of 16 columns from 0 */
    const uint8_t *places; /* of 8 columns: thresholds of 5 bits, of 6 bits */
    uint32_t x;            /* 0..7 */
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

static PEL_ALWAYS_INLINE void pel_store565(pel_word16 *p,
                                           const struct pel_steps565 *threshold,
                                           struct pel_steps565 s, bool swapped)
{
    const uint32_t rb = s.red_blue + threshold->red_blue;
    const uint32_t levels = rb & UINT32_C(0x1F001F00);
    const uint32_t pixel =
        levels >> 13 | (s.green + threshold->green) >> 8 << 5 | levels >> 8;
    *p = (pel_word16)(swapped ? pel_swap16(pixel) : pixel);
}

/* n words, each like the one eight before; in pairs once the address allows it.
 */
static PEL_NOINLINE_32 PEL_UNUSED void pel_pattern16(pel_word16 *p, int32_t n)
{
    pel_word16 *const end = p + n;
    for (; p < end && (uintptr_t)p % 4; p++)
        *p = p[-8];
    if (end - p >= 8) {
        pel_word32 *q = (pel_word32 *)(void *)p;
        const uint32_t a = q[-4], b = q[-3], c = q[-2], d = q[-1];
        p += (end - p) & ~(ptrdiff_t)7;
        do {
            q[0] = a;
            q[1] = b;
            q[2] = c;
            q[3] = d;
            q += 4;
        } while (q != (void *)p);
    }
    for (; p < end; p++)
        *p = p[-8];
}

#if PEL_VECTORS

static PEL_HOT pel_u16x8 pel_row565_places(const uint8_t *places, uint32_t x)
{
    const uint32_t turn = 8 * x;
    uint64_t t;
    memcpy(&t, places, PEL_PLACES);
    const pel_u64x2 turned = {t >> turn | t << (-turn & 63), 0};
    const pel_u8x16 zero = {0};
    return (pel_u16x8)pel_zip_low_u8x16((pel_u8x16)turned, zero);
}

/* One color. */
static PEL_ALWAYS_INLINE void pel_row565_fill(struct pel_row565 r,
                                              struct pel_steps565 s,
                                              bool swapped)
{
    const pel_u16x8 five = pel_row565_places(r.places, r.x);
    const pel_u16x8 six = pel_row565_places(r.places + PEL_PLACES, r.x);
    pel_u16x8 v = ((five + (uint16_t)(s.red_blue >> 16)) << 3 & 0xF800) |
                  ((six + (uint16_t)s.green) >> 3 & 0x07E0) |
                  (five + (uint16_t)s.red_blue) >> 8;
    if (swapped)
        v = v << 8 | v >> 8;
    for (; r.end - r.p >= 8; r.p += 8)
        pel_put_u16x8(r.p, v);
    pel_put_part16(r.p, (int32_t)(r.end - r.p), v);
}

#else

static PEL_ALWAYS_INLINE void pel_row565_fill(struct pel_row565 r,
                                              struct pel_steps565 s,
                                              bool swapped)
{
    const struct pel_steps565 *threshold = r.thresholds + r.x;
    const bool repeats = r.end - r.p > PEL_PLACES;
    pel_word16 *const stop = repeats ? r.p + PEL_PLACES : r.end;
    do
        pel_store565(r.p, threshold++, s, swapped);
    while (++r.p < stop);
    if (repeats)
        pel_pattern16(r.p, (int32_t)(r.end - r.p));
}

#endif

/* How many colors before the first that is not opaque. */
static PEL_ALWAYS_INLINE int32_t pel_row565_put(struct pel_row565 r,
                                                const pel_color *colors,
                                                bool swapped)
{
    const pel_color *c = colors;
    for (; r.p < r.end && pel_alpha(*c) == 255; r.x = (r.x + 1) & 7)
        pel_store565(r.p++, &r.thresholds[r.x], pel_steps565_of(*c++), swapped);
    return (int32_t)(c - colors);
}

static PEL_ALWAYS_INLINE void pel_row565_planes(struct pel_row565 r,
                                                const struct pel_planes *planes,
                                                bool swapped)
{
    uint32_t blue = planes->at[0], green = planes->at[1], red = planes->at[2];
    const uint32_t db = planes->dx[0], dg = planes->dx[1], dr = planes->dx[2];
    for (; r.p < r.end; blue += db, green += dg, red += dr) {
        pel_store565(r.p++, &r.thresholds[r.x],
                     pel_steps565(red >> 24 << 16 | blue >> 24, green >> 24),
                     swapped);
        r.x = (r.x + 1) & 7;
    }
}

static PEL_ALWAYS_INLINE void pel_row565_walk(struct pel_row565 r,
                                              const struct pel_walk *walk,
                                              bool swapped)
{
    uint32_t high = walk->mix.high, low = walk->mix.low;
    int32_t error = walk->error, remainder = walk->remainder;
    const int32_t step = walk->step;
    const struct pel_steps565 *threshold = r.thresholds + r.x;
    do {
        const struct pel_steps565 s =
            pel_steps565(low >> 8 & 0xFF00FFu, high >> 8 & 0xFFu);
        for (; error < 0 && r.p < r.end; error += step)
            pel_store565(r.p++, threshold++, s, swapped);
        if (threshold >= r.thresholds + PEL_PLACES)
            threshold -= PEL_PLACES;
        error -= walk->cell;
        remainder -= walk->cell_remainder;
        if (remainder < 0) {
            remainder += walk->unit;
            error--;
        }
        high += walk->mix.high_change;
        low += walk->mix.low_change;
    } while (r.p < r.end);
}

#endif
