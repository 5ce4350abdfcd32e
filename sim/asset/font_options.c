#include "sim/asset/import.h"

static bool parse_bits(const char *option, const char *text, void *input)
{
    struct import_options *o = input;
    const int i = choice_find("1|2|4|8", text);
    o->font.bits = 1 << i;
    return i >= 0 || option_refuse(option, text, "1, 2, 4 or 8");
}

const struct option_row import_font_options[] = {
    {.help = "Fonts:", .kind = OPTION_HEADING},
    {"codes", "RANGES",
     "these alone, numbers or characters: 32-126,0x20AC,\xC3\xA4; what the "
     "font lacks of them is named, and an error outside of ranges",
     OPTION_TEXT, .offset = offsetof(struct import_options, codes)},
    {"chars", "TEXT",
     "the characters of a text alone: \"\xC3\xA4 \xC3\xA9 "
     "\xE2\x82\xAC\"; those that it lacks are an error. With --codes, both",
     OPTION_TEXT, .offset = offsetof(struct import_options, chars)},
    {"encoding", "NAME",
     "of the font's codes: koi8-r, jisx0208.1983-0, CP437 and whatever iconv "
     "knows; unicode: as they are (default: as the font says, CP437 of a .psf "
     "without a table)",
     OPTION_TEXT, .offset = offsetof(struct import_options, font.encoding)},
    {"bits", "N",
     "of a glyph's pixel: 1; 2, 4 or 8 of coverage, smooth, of a font of "
     "outlines (4; 1 of a font of pictures)",
     OPTION_CALL, .parse = parse_bits},
    {"next", "NAME",
     "of the C object of another font, which is asked for the characters that "
     "this one lacks",
     OPTION_TEXT, .offset = offsetof(struct import_options, next)},
    {"outline", NULL,
     "the outlines themselves, for text of any size at any angle "
     "(pel/image/outline_text.h)",
     OPTION_FLAG, .offset = offsetof(struct import_options, font.outline)},
    {"hinting", "KIND",
     "of outlines: none; light, which moves what is level to whole pixels; "
     "full, stems too (auto: light, or full of 1 bit)",
     OPTION_CHOICE, .offset = offsetof(struct import_options, font.hinting),
     .expected = "auto|none|light|full", .n = sizeof(enum font_hinting)},
    {"font-size", "PX", "from line to line, of a font of outlines (16)",
     OPTION_INTEGER, .offset = offsetof(struct import_options, font.size),
     .low = 1, .high = FONT_SIZE_MAX},
    {.help = NULL},
};
