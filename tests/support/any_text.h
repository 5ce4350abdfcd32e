/* A random font of outlines, and a text of its letters. */
#ifndef TESTS_SUPPORT_ANY_TEXT_H
#define TESTS_SUPPORT_ANY_TEXT_H

#include "cases.h"
#include "core/image/outline_text.h"

enum { ANY_GLYPHS = 3, ANY_VERBS = 64, ANY_BYTES = 1024 };

/* A glyph as a path, whose points all stand in it, in units, and a middle as
 * that of the points on either side. */
struct any_outline {
    uint8_t verbs[ANY_VERBS];
    int16_t points[6 * ANY_VERBS];
    bool is_middle[3 * ANY_VERBS];
    struct pel_path path;
};

struct any_text {
    struct any_outline outline[ANY_GLYPHS];
    uint8_t bytes[ANY_BYTES];
    struct pel_outline_glyph glyph[ANY_GLYPHS];
    struct pel_outline_pair pair[1];
    struct pel_font_range range;
    struct pel_outline_font_asset font;
    int32_t x, y; /* of the last point */
    char string[8];
    struct pel_outline_text_block text;
};

extern struct any_text any_text;

/* Makes it anew, and keeps it for the case. */
void any_text_make(struct random *random);

#endif
