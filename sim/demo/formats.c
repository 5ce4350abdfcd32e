/* One picture in every pixel format. */
#include <stdio.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/demo/demo.h"
#include "sim/image/format_names.h"

enum { TILE_WIDTH = 176, TILE_HEIGHT = 120, GAP = 8, COLUMNS = 4, ROWS = 4 };

/* A ramp, three discs, and a ramp of greys. */
static const char tile_script[] =
    "canvas 176 120 xrgb8888\n"
    "paint vertex #000040 #ff6000 #ffffe0\ntriangle 0 0 176 0 176 120\n"
    "paint vertex #000040 #ffffe0 #00a0c0\ntriangle 0 0 176 120 0 120\n"
    "paint flat #ff0000a0\ncircle 66 72 32\n"
    "paint flat #00ff00a0\ncircle 110 72 32\n"
    "paint flat #0000ffa0\ncircle 88 40 32\n"
    "paint vertex #000000 #ffffff #ffffff\ntriangle 0 120 176 120 176 104\n"
    "paint vertex #000000 #ffffff #000000\ntriangle 0 120 176 104 0 104\n";

static void put_tile(const struct picture *sheet, const struct picture *tile,
                     int i)
{
    const int left = GAP + i % COLUMNS * (TILE_WIDTH + GAP);
    const int top = GAP + i / COLUMNS * (TILE_HEIGHT + GAP);
    for (int y = 0; y < TILE_HEIGHT; y++)
        memcpy(picture_row(sheet, top + y) + left, picture_row(tile, y),
               TILE_WIDTH * sizeof(pel_color));
}

static bool draw_tile(struct demo_result *tile, const struct pel_format *format)
{
    struct script script;
    FILE *text =
        fmemopen((void *)(uintptr_t)tile_script, sizeof tile_script - 1, "r");
    if (!text)
        return message_error("out of memory");
    const bool done = script_read(&script, text, "formats", format) &&
                      demo_draw_script(tile, &script);
    script_free(&script);
    fclose(text);
    return done;
}

static bool draw_formats(struct demo_result *result, const void *what)
{
    (void)what;
    snprintf(result->note, sizeof result->note, "In reading order: %s.",
             format_list());
    bool done = picture_init(
        &result->picture, COLUMNS * (TILE_WIDTH + GAP) + GAP,
        ROWS * (TILE_HEIGHT + GAP) + GAP, PEL_RGB(0x20, 0x20, 0x20));
    for (int i = 0; done && format_names[i].name; i++) {
        struct demo_result tile = {.milliseconds = 0};
        done = draw_tile(&tile, format_names[i].format);
        if (done)
            put_tile(&result->picture, &tile.picture, i);
        result->milliseconds += tile.milliseconds;
        picture_free(&tile.picture);
    }
    return done;
}

const struct demo demo_formats[] = {
    {"formats",
     "Gouraud triangles and translucent discs, drawn in every pixel format.",
     NULL, draw_formats, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
