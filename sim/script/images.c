#include "core/image/copy.h"
#include "core/image/glyph_text.h"
#include "core/image/scroll.h"
#include "core/image/smooth_outline_text.h"
#include "sim/icon/icon.h"
#include "sim/script/parser.h"

static void set_font(struct script_pen *pen, const int32_t *v)
{
    pen->font = &pen->script->assets[v[0]].font;
}

/* There is a font: reading the script made sure. */
static void draw_text(struct script_pen *pen, const int32_t *v)
{
    const struct pel_text_block text = {
        pen->font, pen->script->assets[v[2]].text, v[0], v[1]};
    pel_text(pen->surface, &text, script_paint(pen));
}

static void set_outlines(struct script_pen *pen, const int32_t *v)
{
    pen->outlines = &pen->script->assets[v[0]].outlines;
}

/* There is a font of outlines. */
static void draw_outline_text(struct script_pen *pen, const int32_t *v)
{
    const struct pel_point at = {v[0], v[1]};
    const struct pel_outline_text_block text = {
        .font = pen->outlines,
        .string = pen->script->assets[v[4]].text,
        .transform = pel_outline_transform(pen->outlines, v[2], v[3], at),
        .align = (enum pel_text_align)pen->align};
    script_finish(pen,
                  (pen->smooth ? pel_smooth_outline_text : pel_outline_text)(
                      pen->surface, &text, script_paint(pen), pen->scratch,
                      pen->scratch_size));
}

static struct pel_copy_part copy_of(const struct script_pen *pen,
                                    const int32_t *v, int32_t picture)
{
    const struct pel_surface *source = &pen->script->assets[picture].picture;
    return (struct pel_copy_part){source, source->bounds, v[0], v[1]};
}

static void draw_image(struct script_pen *pen, const int32_t *v)
{
    const struct pel_copy_part copy = copy_of(pen, v, v[2]);
    pel_copy(pen->surface, &copy);
}

static void draw_image_alpha(struct script_pen *pen, const int32_t *v)
{
    const struct pel_copy_part copy = copy_of(pen, v, v[3]);
    pel_copy_alpha(pen->surface, &copy, (uint8_t)v[2]);
}

static void draw_image_key(struct script_pen *pen, const int32_t *v)
{
    const struct pel_copy_part copy = copy_of(pen, v, v[3]);
    pel_copy_keyed(pen->surface, &copy, (pel_color)v[2]);
}

/* Its middle, longer side, turn, and the colour of what takes one. */
static void draw_icon(struct script_pen *pen, const int32_t *v)
{
    const struct pel_icon_asset *icon = &pen->script->assets[v[5]].icon;
    struct pel_icon_shape shape = {.icon = icon,
                                   .kind = icon_kind(icon, pen->smooth),
                                   .color = (pel_color)v[4]};
    enum pel_status status =
        pel_icon_place(&shape, v[2], v[3], (struct pel_point){v[0], v[1]});
    if (status == PEL_OK)
        status =
            pel_icon(pen->surface, &shape, pen->scratch, pen->scratch_size);
    script_finish(pen, status);
}

static void draw_scroll(struct script_pen *pen, const int32_t *v)
{
    const struct pel_rect area = {v[0], v[1], v[0] + v[2], v[1] + v[3]};
    pel_scroll(pen->surface, &area, v[4], v[5]);
}

static void set_smooth_font(struct script_pen *pen, const int32_t *v)
{
    set_font(pen, v + 1);
}

static const char *check_smooth_font(const int32_t *v, size_t n)
{
    (void)n;
    return v[0] < 1 || v[0] > 255 ? "expected 1 to 255 px from line to line"
                                  : NULL;
}

const struct script_command script_images[] = {
    {"font smooth", "nF", "PX FILE", SCRIPT_FONT, .draw = set_smooth_font,
     .check = check_smooth_font},
    {"font outline", "F", "FILE", SCRIPT_FONT, .draw = set_outlines},
    {"font", "F", "FILE", SCRIPT_FONT, .draw = set_font},
    {"option align", "o", "left|center|right", SCRIPT_STATE,
     SCRIPT_SETTING(struct script_pen, align, 1)},
    {"text outline", "ppltT", "X Y SIZE TURN \"TEXT\"", SCRIPT_TEXT,
     .draw = draw_outline_text},
    {"text", "iiT", "X Y \"TEXT\"", SCRIPT_TEXT, .draw = draw_text},
    {"image key", "iicP", "X Y COLOUR FILE", SCRIPT_PICTURE,
     .draw = draw_image_key},
    {"image alpha", "iibP", "X Y ALPHA FILE", SCRIPT_PICTURE,
     .draw = draw_image_alpha},
    {"image", "iiP", "X Y FILE", SCRIPT_PICTURE, .draw = draw_image},
    {"icon", "ppltcI", "X Y SIZE TURN COLOUR FILE", SCRIPT_PICTURE,
     .draw = draw_icon},
    {"scroll", "iinnii", "X Y WIDTH HEIGHT DX DY", SCRIPT_WHOLE,
     .draw = draw_scroll},
    {.next = script_paint_commands},
};
