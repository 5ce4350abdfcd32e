/* Fonts in flash, as `pel import` writes them: 1-bit glyphs. */
#ifndef PEL_ASSET_FONT_ASSET_H
#define PEL_ASSET_FONT_ASSET_H

#include <stddef.h>
#include <stdint.h>

#include "../base/status.h"

/* "PELF", and the version of the struct. */
#define PEL_FONT_MAGIC UINT32_C(0x464C4550)
enum { PEL_FONT_VERSION = 2 };

/* No glyph has this index. */
enum { PEL_FONT_NONE = 0xFFFF };

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
};

/* Bytes of a glyph's rows, for constant expressions and as a function. */
#define PEL_FONT_GLYPH_SIZE(width, height) (((width) + 7u) / 8 * (height))

static inline uint32_t pel_font_glyph_size(const struct pel_font_glyph *glyph)
{
    return PEL_FONT_GLYPH_SIZE(glyph->width, glyph->height);
}

/* Checks that the program can read this asset. PEL_ERROR_NULL; PEL_ERROR_RANGE:
 * no font asset, or one of another version; PEL_ERROR_SIZE: glyphs outside of
 * `bits`, ranges outside of the glyphs or not in order. */
static inline enum pel_status pel_font_asset_check(
    const struct pel_font_asset *font)
{
    uint32_t next = 0;
    if (!font || !font->range || !font->glyph || !font->bits)
        return PEL_ERROR_NULL;
    if (font->magic != PEL_FONT_MAGIC || font->version != PEL_FONT_VERSION)
        return PEL_ERROR_RANGE;
    if (font->missing != PEL_FONT_NONE && font->missing >= font->glyphs)
        return PEL_ERROR_SIZE;
    for (uint32_t i = 0; i < font->ranges; i++) {
        const struct pel_font_range *r = &font->range[i];
        if (r->first < next || r->first > UINT32_C(0x10FFFF) ||
            r->glyph + r->count > font->glyphs)
            return PEL_ERROR_SIZE;
        next = r->first + r->count;
    }
    for (uint32_t i = 0; i < font->glyphs; i++) {
        uint32_t size = pel_font_glyph_size(&font->glyph[i]);
        if (size > font->size || font->glyph[i].offset > font->size - size)
            return PEL_ERROR_SIZE;
    }
    return PEL_OK;
}

#endif
