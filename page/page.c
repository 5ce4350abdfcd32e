/* What the page calls: a script is read from a file in memory, drawn, shown and
 * explained; what others make of a triangle; examples that run. What a call
 * prints is its text: messages on standard error, the rest on standard output.
 */
#include <stdlib.h>
#include <string.h>

#include "bench/methods/fill.h"
#include "page/page.h"
#include "port/sdl/inspect.h"
#include "sim/cli/message.h"
#include "sim/image/format_names.h"
#include "sim/script/script.h"
#include "sim/view/inspect.h"

#define EXPORT(name) __attribute__((export_name(#name)))

static struct script script;
static struct canvas canvas;
static uint8_t *shown; /* R, G, B, A */

/* The colors of a surface as the page's canvas takes them. */
static uint8_t *bytes_of(const struct pel_surface *s)
{
    const struct pel_rect *b = &s->bounds;
    const int32_t width = b->x1 - b->x0, n = width * (b->y1 - b->y0);
    uint8_t *to = realloc(shown, (size_t)n * 4);
    if (!to) {
        message_error("no memory for %d pixels", (int)n);
        return NULL;
    }
    shown = to;
    for (int32_t i = 0; i < n; i++) {
        pel_color c;
        s->format->load(s, b->x0 + i % width, b->y0 + i / width, 1, &c);
        *to++ = (uint8_t)pel_red(c);
        *to++ = (uint8_t)pel_green(c);
        *to++ = (uint8_t)pel_blue(c);
        *to++ = 255;
    }
    return shown;
}

/* Reads script.pel for a format, a row of format_names; -1: its own. */
EXPORT(page_read) bool page_read(int format)
{
    return script_load(&script, "/script.pel",
                       format < 0 ? NULL : format_names[format].format);
}

EXPORT(page_width) int page_width(void)
{
    return script.width;
}

EXPORT(page_height) int page_height(void)
{
    return script.height;
}

/* Rows of a band, 0: none. */
EXPORT(page_bands) int page_bands(void)
{
    return script.bands;
}

/* Draws it; heat: how often each pixel is painted. Its bytes, R, G, B, A, or
 * NULL. */
EXPORT(page_draw) uint8_t *page_draw(bool heat)
{
    const struct pel_format *const own = script.format;
    canvas_free(&canvas);
    script.format = heat ? &pel_heat : own;
    bool done =
        canvas_init(&canvas, script.format, script.width, script.height);
    if (done && heat)
        memset(canvas.memory, 0,
               (size_t)canvas.surface.stride * (size_t)script.height);
    done = done && script_draw(&script, &canvas, -1);
    script.format = own;
    return done ? bytes_of(&canvas.surface) : NULL;
}

EXPORT(page_explain) void page_explain(int x, int y)
{
    script_explain(&script, x, y, false);
    fflush(stdout);
}

/* The pixels around (x, y), magnified, with the corners of shapes: side x side
 * px. */
EXPORT(page_lens_side) int page_lens_side(void)
{
    return PEL_LENS_PIXELS * PEL_LENS_ZOOM;
}

EXPORT(page_lens) uint8_t *page_lens(int x, int y)
{
    enum { SIDE = PEL_LENS_PIXELS * PEL_LENS_ZOOM };
    static uint32_t memory[SIDE * SIDE];
    static const struct pel_rect all = {0, 0, SIDE, SIDE};
    struct pel_surface s;
    pel_surface_init(&s, &pel_xrgb8888, memory, sizeof memory, &all);
    inspect_magnifier(&s, &canvas.surface, &script, x, y);
    return bytes_of(&s);
}

/* Row i of the formats; NULL: no more. */
EXPORT(page_format) const char *page_format(int i)
{
    return format_names[i].name;
}

/* A triangle of three points in sub-pixels, by method i of the atlas, in white
 * on a transparent field of size x size px, at most 64. NULL: no more. */
EXPORT(page_method) const char *page_method(int i)
{
    return fill_methods[i] ? fill_methods[i]->name : NULL;
}

EXPORT(page_points) struct pel_point *page_points(void)
{
    static struct pel_point points[3];
    return points;
}

EXPORT(page_fill) uint32_t *page_fill(int i, int size)
{
    static uint32_t memory[64 * 64];
    const struct pel_rect all = {0, 0, size, size};
    struct pel_point v[3];
    struct pel_surface s;
    memset(memory, 0, sizeof memory);
    pel_surface_init(&s, &pel_xrgb8888, memory, sizeof memory, &all);
    for (int k = 0; k < 3; k++) { /* to the sub-pixels of the method */
        const int32_t unit = 1 << (8 - fill_methods[i]->bits);
        v[k].x = (page_points()[k].x + unit / 2) & -unit;
        v[k].y = (page_points()[k].y + unit / 2) & -unit;
    }
    fill_methods[i]->draw(&s, v, 0xFFFFFFFF);
    return memory;
}

/* The examples' mains, each with a name of its own: MAIN(watch_main)... */
#define MAIN(name) int name(void);
PAGE_MAINS
#undef MAIN

/* Runs an example from its begin to its end; each frame is told by page_frame.
 */
EXPORT(page_play) int page_play(int i)
{
#define MAIN(name) name,
    static int (*const mains[])(void) = {PAGE_MAINS};
    return mains[i]();
}

const uint8_t *page_bytes(const struct pel_surface *surface)
{
    return bytes_of(surface);
}
