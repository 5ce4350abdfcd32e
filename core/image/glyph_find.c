#include "glyph_find.h"

enum { REPLACEMENT = 0xFFFD };

/* How a first byte goes on: bytes that follow, and the range of the first of
 * them, which keeps out overlong forms, surrogates and more than U+10FFFF. */
struct lead {
    uint8_t count, low, high;
};

static struct lead lead_of(uint8_t byte)
{
    struct lead lead = {0, 0x80, 0xBF};
    if (byte >= 0xC2 && byte <= 0xF4)
        lead.count = byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
    if (byte == 0xE0)
        lead.low = 0xA0;
    else if (byte == 0xED)
        lead.high = 0x9F;
    else if (byte == 0xF0)
        lead.low = 0x90;
    else if (byte == 0xF4)
        lead.high = 0x8F;
    return lead;
}

uint32_t pel_utf8_next(const char **text)
{
    const uint8_t *p = (const uint8_t *)*text;
    uint32_t code = *p++;
    if (code >= 0x80) {
        struct lead lead = lead_of((uint8_t)code);
        code = lead.count ? code & 0x3Fu >> lead.count : REPLACEMENT;
        for (; lead.count; lead.count--) {
            if (*p < lead.low || *p > lead.high) {
                code = REPLACEMENT;
                break;
            }
            code = code << 6 | (*p++ & 0x3Fu);
            lead.low = 0x80;
            lead.high = 0xBF;
        }
    }
    *text = (const char *)p;
    return code;
}

const struct pel_font_glyph *pel_glyph_find(const struct pel_font_asset *font,
                                            uint32_t code)
{
    int32_t low = 0, high = font->ranges;
    while (low < high) {
        int32_t middle = (low + high) / 2;
        const struct pel_font_range *r = &font->range[middle];
        if (code < r->first)
            high = middle;
        else if (code - r->first >= r->count)
            low = middle + 1;
        else
            return &font->glyph[r->glyph + (code - r->first)];
    }
    return font->missing == PEL_FONT_NONE ? NULL : &font->glyph[font->missing];
}
