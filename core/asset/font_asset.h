/* Fonts in flash, as `pel import` writes them: glyphs of one bit, or smooth
 * ones (image/smooth_glyph.h). */
#ifndef PEL_ASSET_FONT_ASSET_H
#define PEL_ASSET_FONT_ASSET_H

#include <stddef.h>
#include <stdint.h>

#include "../base/point.h"
#include "../base/status.h"

/* "PELF", and the version of the struct. */
#define PEL_FONT_MAGIC UINT32_C(0x464C4550)
enum { PEL_FONT_VERSION = 3 };

/* No glyph has this index. */
enum { PEL_FONT_NONE = 0xFFFF };

/* In an offset of a kind of more than one bit: no runs (image/smooth_glyph.h).
 */
#define PEL_FONT_RAW UINT32_C(0x80000000)

/* One glyph: rows from the top, each begins at a byte, the left pixel in the
 * high bit. An empty one (a space) has width 0 and height 0. */
struct pel_font_glyph {
    uint32_t offset;       /* bytes from pel_font_asset.bits */
    uint8_t width, height; /* px */
    int16_t left;          /* px from the pen to the leftmost column */
    int16_t top;           /* px from the baseline up to above the top row */
    uint8_t advance;       /* px from this pen to the next */
};

/* Code points first, first + 1 ... have the glyphs glyph, glyph + 1 ... */
struct pel_font_range {
    uint32_t first;
    uint16_t count, glyph;
};

/* Are n ranges in order, of so many glyphs? */
static inline bool pel_font_ranges_legal(const struct pel_font_range *range,
                                         uint32_t n, uint32_t glyphs)
{
    uint32_t next = 0;
    for (; n > 0; n--, range++) {
        if (range->first < next || range->first > UINT32_C(0x10FFFF) ||
            range->glyph + UINT32_C(0) + range->count > glyphs)
            return false;
        next = range->first + range->count;
    }
    return true;
}

/* The glyph of a code point by n such ranges, or PEL_FONT_NONE. */
static inline uint32_t pel_font_ranges_find(const struct pel_font_range *range,
                                            int32_t n, uint32_t code)
{
    int32_t low = 0;
    while (low < n) {
        const int32_t middle = (low + n) / 2;
        const struct pel_font_range *const r = &range[middle];
        if (code < r->first)
            n = middle;
        else if (code - r->first >= r->count)
            low = middle + 1;
        else
            return r->glyph + (code - r->first);
    }
    return PEL_FONT_NONE;
}

/* Between two of the first 256 glyphs the pen moves by x px more. */
struct pel_font_pair {
    uint8_t left, right; /* indices of glyphs */
    int8_t x;
};

/* Of n pairs of `size` bytes, which begin with both indices and are in order:
 * that of two glyphs, or NULL. */
static inline const void *pel_font_pair_find(const void *pairs, int32_t n,
                                             uint32_t size, uint32_t left,
                                             uint32_t right)
{
    const uint32_t wanted = left << 8 | right;
    int32_t low = 0, high = left < 256 && right < 256 ? n : 0;
    while (low < high) {
        const int32_t middle = (low + high) / 2;
        const uint8_t *const pair = PEL_CAST(const uint8_t *, pairs) +
                                    PEL_CAST(uint32_t, middle) * size;
        const uint32_t at = pair[0] * UINT32_C(256) + pair[1];
        if (at == wanted)
            return pair;
        if (at < wanted)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}

struct pel_font_asset;
struct pel_surface;
struct pel_paint;

/* How the glyphs of a font are stored that has more than one bit. */
struct pel_font_kind {
    /* Does the glyph lie inside the font's `bits`? */
    bool (*fits)(const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph);

    /* Paints it with its top left pixel at a place in px. */
    void (*draw)(const struct pel_surface *surface,
                 const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph, struct pel_point at,
                 const struct pel_paint *paint);

    /* What the pen moves between two glyphs beside the advance, px. */
    int32_t (*kerning)(const struct pel_font_asset *font,
                       const struct pel_font_glyph *left,
                       const struct pel_font_glyph *right);

    uint8_t bits;  /* of a step of coverage */
    uint8_t scale; /* of a step, so that the largest becomes 255 */
};

struct pel_font_asset {
    uint32_t magic;          /* PEL_FONT_MAGIC */
    uint8_t version;         /* PEL_FONT_VERSION */
    uint8_t ascent, descent; /* px of a line above and below its baseline */
    uint16_t ranges, glyphs; /* counts */
    uint16_t missing;        /* glyph of other characters, or PEL_FONT_NONE */
    uint32_t size;           /* bytes of bits */
    const struct pel_font_range *range; /* by code point, no overlap */
    const struct pel_font_glyph *glyph;
    const uint8_t *bits;
    const struct pel_font_kind *kind; /* NULL: one bit, no pairs */
    const struct pel_font_pair *pair; /* by left, then right */
    uint16_t pairs;
    const struct pel_font_asset *next; /* asked for what this one lacks, checked
                                          by itself; NULL at the end */
};

/* Bytes of a 1-bit glyph's rows, for constant expressions and as a function. */
#define PEL_FONT_GLYPH_SIZE(width, height) (((width) + 7u) / 8 * (height))

static inline uint32_t pel_font_glyph_size(const struct pel_font_glyph *glyph)
{
    return PEL_FONT_GLYPH_SIZE(glyph->width, glyph->height);
}

static inline bool pel_font_glyph_fits(const struct pel_font_asset *font,
                                       const struct pel_font_glyph *glyph)
{
    const uint32_t size = pel_font_glyph_size(glyph);
    return font->kind
               ? font->kind->fits(font, glyph)
               : size <= font->size && glyph->offset <= font->size - size;
}

/* Checks that the program can read this asset. PEL_ERROR_NULL; PEL_ERROR_RANGE:
 * no font asset, or one of another version; PEL_ERROR_SIZE: glyphs outside of
 * `bits`, ranges outside of the glyphs or not in order. */
static inline enum pel_status pel_font_asset_check(
    const struct pel_font_asset *font)
{
    if (!font || !font->range || !font->glyph || !font->bits ||
        (font->pairs > 0 && !font->pair))
        return PEL_ERROR_NULL;
    if (font->magic != PEL_FONT_MAGIC || font->version != PEL_FONT_VERSION)
        return PEL_ERROR_RANGE;
    if ((font->missing != PEL_FONT_NONE && font->missing >= font->glyphs) ||
        !pel_font_ranges_legal(font->range, font->ranges, font->glyphs))
        return PEL_ERROR_SIZE;
    for (uint32_t i = 0; i < font->glyphs; i++)
        if (!pel_font_glyph_fits(font, &font->glyph[i]))
            return PEL_ERROR_SIZE;
    return PEL_OK;
}

#endif
