/* Fonts of outlines in flash, as `pel import --outline` writes them: one table
 * for text of any size at any angle (image/outline_text.h).
 *
 * A glyph is a row of points, whose first byte says in bits 0 and 1 what it is
 * (enum pel_outline_point), and in bits 2 and 3, 4 and 5, how far x and y move
 * from the point before it, from (0, 0) at first: 0, not at all; 1, by the next
 * byte; 2, back by it; 3, by the next two bytes, a signed number, low byte
 * first. y grows upwards, from the baseline; all coordinates are from -32,768
 * to 32,767. Parts close by themselves; between two control points of quadratic
 * curves next to each other a curve ends in the middle. */
#ifndef PEL_ASSET_OUTLINE_FONT_ASSET_H
#define PEL_ASSET_OUTLINE_FONT_ASSET_H

#include "font_asset.h"

/* "PELO", and the version of the struct. */
#define PEL_OUTLINE_FONT_MAGIC UINT32_C(0x4F4C4550)
enum { PEL_OUTLINE_FONT_VERSION = 1 };

enum pel_outline_point {
    PEL_OUTLINE_BEGIN, /* of a part */
    PEL_OUTLINE_ON,    /* where a line or a curve ends */
    PEL_OUTLINE_QUAD,  /* a control point of a quadratic curve */
    PEL_OUTLINE_CUBIC  /* one of two of a cubic one */
};

/* Lengths are in units of the font. */
struct pel_outline_glyph {
    uint32_t offset;  /* bytes from pel_outline_font_asset.points */
    uint16_t size;    /* bytes of points; 0: a space */
    uint16_t advance; /* from this pen to the next */
};

/* Between two of the first 256 glyphs the pen moves by x more. */
struct pel_outline_pair {
    uint8_t left, right; /* indices of glyphs */
    int16_t x;
};

struct pel_outline_font_asset {
    uint32_t magic;           /* PEL_OUTLINE_FONT_MAGIC */
    uint8_t version;          /* PEL_OUTLINE_FONT_VERSION */
    uint16_t em;              /* units of its size, 256..16,384 */
    uint16_t ascent, descent; /* of a line above and below its baseline */
    int16_t left, bottom, right, top; /* a box around each glyph, from its pen;
                                         what is beyond it may be left out */
    uint16_t ranges, glyphs, pairs;   /* counts */
    uint16_t missing; /* glyph of other characters, or PEL_FONT_NONE */
    uint32_t size;    /* bytes of points */
    const struct pel_font_range *range; /* by code point, no overlap */
    const struct pel_outline_glyph *glyph;
    const uint8_t *points;
    const struct pel_outline_pair *pair; /* by left, then right */
};

/* Checks that the program can read this asset, as pel_font_asset_check does.
 * The points themselves are not checked: wrong ones show other outlines, and
 * nothing outside of their glyph is read. */
static inline enum pel_status pel_outline_font_asset_check(
    const struct pel_outline_font_asset *font)
{
    if (!font || !font->range || !font->glyph || !font->points ||
        (font->pairs > 0 && !font->pair))
        return PEL_ERROR_NULL;
    if (font->magic != PEL_OUTLINE_FONT_MAGIC ||
        font->version != PEL_OUTLINE_FONT_VERSION)
        return PEL_ERROR_RANGE;
    if (font->em < 256 || font->em > 16384 ||
        (font->missing != PEL_FONT_NONE && font->missing >= font->glyphs) ||
        !pel_font_ranges_legal(font->range, font->ranges, font->glyphs))
        return PEL_ERROR_SIZE;
    for (uint32_t i = 0; i < font->glyphs; i++)
        if (font->glyph[i].offset > font->size ||
            font->glyph[i].size > font->size - font->glyph[i].offset)
            return PEL_ERROR_SIZE;
    return PEL_OK;
}

#endif
