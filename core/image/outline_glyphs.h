/* The seam between text of outlines and what fills the sides of a glyph. */
#ifndef PEL_IMAGE_OUTLINE_GLYPHS_H
#define PEL_IMAGE_OUTLINE_GLYPHS_H

#include "../path/pen.h"
#include "outline_text.h"

/* How glyphs are filled. */
struct pel_outline_fill {
    pel_sides_begin *begin;
    const struct pel_paint *paint;
    struct pel_scratch scratch;
};

/* Points of a glyph on their way to curves. */
struct pel_outline_points {
    const uint8_t *at, *end;
    uint32_t kind; /* enum pel_outline_point */
    int16_t x, y;
    int controls; /* that wait for the end of their curve */
    const struct pel_transform *transform;
    struct pel_curves curves;
    struct pel_fill_pen pen;
};

/* A glyph at its place: the shape of a walk. */
struct pel_outline_placed {
    const struct pel_outline_text_block *text;
    const struct pel_outline_glyph *glyph;
    struct pel_transform transform;
    struct pel_outline_points *points; /* memory for them */
};

/* The pen on a line of text, in units of the font. */
struct pel_outline_line {
    const struct pel_outline_font_asset *font;
    const char *next;
    int32_t x, y;
    uint32_t glyph; /* the last one, whose advance is still to come, or
                       PEL_FONT_NONE */
};

/* Text whose glyphs are taken one by one, as long as each is PEL_OK. */
struct pel_outline_visitor {
    enum pel_status (*take)(struct pel_outline_visitor *visitor);
    struct pel_outline_line line;
    struct pel_outline_placed placed;
};

/* Text that is drawn; where stacks are small it lies in the scratch memory. */
struct pel_outline_drawing {
    struct pel_outline_visitor visitor;
    struct pel_outline_fill fill;
    const struct pel_surface *target;
    struct pel_surface surface; /* whose clip is a glyph's box */
    struct pel_outline_points points;
};

/* Draws text by d->fill. */
enum pel_status pel_outline_text_draw(
    struct pel_outline_drawing *d, const struct pel_surface *surface,
    const struct pel_outline_text_block *text);

#endif
