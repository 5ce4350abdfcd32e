/* A scene script that is looked at and changed: the figures, or a file. No
 * window and no clock: calls say what the user does and that time passes. */
#ifndef SIM_VIEW_SHEET_H
#define SIM_VIEW_SHEET_H

#include "drivers/input.h"
#include "sim/script/script.h"
#include "sim/view/figures.h"
#include "sim/view/inspect.h"
#include "sim/view/keys.h"

struct sheet {
    const char *path; /* NULL: the figures */
    char **line;      /* of the file */
    size_t lines;
    struct style *style; /* of each shape, in the script's order */
    int shapes;
    int picked;             /* a shape, or -1 */
    int width, height;      /* px of the window */
    int zoom;               /* of them that a pixel of the picture has */
    int pointer[2];         /* px of the window */
    bool moving;            /* figures turn, phases grow */
    struct figures figures; /* where they are */
    struct script base;     /* the file's, unchanged */
    struct script script;   /* as it is shown */
    struct canvas canvas;   /* the picture */
    struct inspect inspect;
    bool stale;          /* the script is not as it should be */
    double milliseconds; /* of the last drawing */
};

/* Reads a file, or takes the figures for NULL. False, with a message. */
bool sheet_init(struct sheet *sheet, const char *path);
void sheet_free(struct sheet *sheet);

/* The size of the window, before the first picture and whenever it changes. */
void sheet_resize(struct sheet *sheet, int width, int height);

/* What the user does. */
enum view_action sheet_input(struct sheet *sheet,
                             const struct pel_input *input);

/* A thirtieth of a second passes. True when the picture changes. */
bool sheet_advance(struct sheet *sheet);

/* Draws the window's pixels, from (0, 0) of the surface's bounds on. False,
 * with a message. */
bool sheet_draw(struct sheet *sheet, const struct pel_surface *surface);

#define SHEET_KEYS_HELP                                                  \
    "  click, Tab          pick a shape; Enter: none\n"                  \
    "  1 2 3 4 0           fill: flat, corners, rings, sectors, own\n"   \
    "  + -, wheel          more or less opaque\n"                        \
    "  space               stop or start the movement\n"                 \
    "  F2 F3               smaller, larger pixels\n"                     \
    "  o b d               overdraw, bands, changed areas\n"             \
    "  x                   the next format: 565, dithered, grey, mono\n" \
    "  m                   magnifier at the pointer\n"                   \
    "  i h                 figures of the last frame; this help\n"       \
    "  w                   write the picture to a file\n"                \
    "  q, Escape           end\n"

#endif
