#include "glyph_text.h"

uint32_t pel_text_missing(const struct pel_font_asset *font, const char *string)
{
    struct pel_font_asset bare = *font;
    uint32_t n = 0;
    bare.missing = PEL_FONT_NONE;
    while (*string) {
        const uint32_t code = pel_utf8_next(&string);
        const struct pel_font_asset *at = &bare;
        n += code != '\n' && !pel_glyph_find(&at, code);
    }
    return n;
}
