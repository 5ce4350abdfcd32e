/* A scene script that is looked at and changed: the figures, or a file. No
 * window and no clock: calls say what the user does and that time passes. */
#ifndef SIM_VIEW_SHEET_H
#define SIM_VIEW_SHEET_H

#include "drivers/dirty.h"
#include "sim/script/script.h"
#include "sim/view/figures.h"
#include "sim/view/inspect.h"
#include "sim/view/show.h"

struct sheet {
    struct show show;    /* first */
    const char *path;    /* NULL: the figures */
    struct style *style; /* of each shape, in the script's order */
    int shapes;
    int picked;             /* a shape, or -1 */
    int width, height;      /* px of the window */
    int zoom;               /* of them that a pixel of the picture has */
    int pointer[2];         /* px of the window */
    bool moving;            /* figures turn, phases grow */
    struct figures figures; /* where they are */
    struct script script;   /* as it is shown; its first values are those of */
    struct script_item *items; /* the file, as they were read */
    size_t item_count, value_count;
    const struct pel_format *format; /* the file's */
    struct canvas canvas;            /* the picture */
    struct inspect inspect;
    struct pel_font_asset font; /* of help and numbers */
    bool stale;                 /* the script is to be made anew */
    struct style *drawn_style;  /* style and figures of the last picture */
    struct figures drawn;
    bool whole;   /* the next picture is drawn whole: not areas alone */
    bool covered; /* something was drawn over the last one */
    struct pel_dirty_areas
        areas;           /* px of it that changed with the last frame */
    double milliseconds; /* of the last drawing */
};

/* Reads a file, or takes the figures for NULL. False, with a message. */
bool sheet_init(struct sheet *sheet, const char *path);
void sheet_free(struct sheet *sheet);

/* For sim/view/sheet*.c alone. */

bool sheet_draw(struct show *show, const struct pel_surface *surface);
enum view_action sheet_take(struct sheet *sheet, const struct pel_input *input);
/* The script as it is to be shown, made anew where it is stale. False, with a
 * message. */
bool sheet_compose(struct sheet *sheet);

/* How many of the first items are shapes, which a style may paint. */
int sheet_count_shapes(const struct script *script, size_t items);

/* The picture's pixel under the pointer; false: none is. */
bool sheet_pixel(const struct sheet *sheet, int *x, int *y);

#define SHEET_KEYS_HELP                                                  \
    "  click, Tab          pick a shape; Enter: none\n"                  \
    "  1 2 3 4 0           fill: flat, corners, rings, sectors, own\n"   \
    "  + -, wheel          more or less opaque\n"                        \
    "  space               stop or start the movement\n"                 \
    "  F2 F3               smaller, larger pixels\n"                     \
    "  o b d               overdraw, bands, changed areas\n"             \
    "  s                   smooth edges\n"                               \
    "  x                   the next format: 565, dithered, grey, mono\n" \
    "  m                   magnifier at the pointer\n"                   \
    "  i h                 numbers of the last frame; this help\n"       \
    "  w                   write the picture to a file\n"                \
    "  q, Escape           end\n"

#endif
