/* One picture in every pixel format. */
#include <stdio.h>
#include <string.h>

#include "core/pel.h"
#include "sim/demo/demo.h"
#include "sim/image/format_names.h"

enum { TILE_WIDTH = 176, TILE_HEIGHT = 120, GAP = 8, COLUMNS = 5, ROWS = 3 };

static void draw_ramp(const struct pel_surface *s)
{
    static const struct pel_point v[4] = {PEL_AT(0, 0), PEL_AT(176, 0),
                                          PEL_AT(176, 120), PEL_AT(0, 120)};
    static const pel_color c[4] = {PEL_RGB(0, 0, 64), PEL_RGB(255, 96, 0),
                                   PEL_RGB(255, 255, 224),
                                   PEL_RGB(0, 160, 192)};
    const struct pel_point second[3] = {v[0], v[2], v[3]};
    const pel_color second_color[3] = {c[0], c[2], c[3]};
    pel_triangle_gouraud(s, v, c);
    pel_triangle_gouraud(s, second, second_color);
}

static void draw_discs(const struct pel_surface *s)
{
    static const pel_color colors[3] = {PEL_RGBA(255, 0, 0, 160),
                                        PEL_RGBA(0, 255, 0, 160),
                                        PEL_RGBA(0, 0, 255, 160)};
    static const struct pel_point centers[3] = {PEL_AT(66, 72), PEL_AT(110, 72),
                                                PEL_AT(88, 40)};
    for (int i = 0; i < 3; i++) {
        const struct pel_flat paint = PEL_FLAT(colors[i]);
        pel_circle(s, centers[i], PEL_PX(32), &paint.paint);
    }
}

static void draw_greys(const struct pel_surface *s)
{
    static const struct pel_point v[3] = {PEL_AT(0, 120), PEL_AT(176, 120),
                                          PEL_AT(176, 104)};
    static const struct pel_point w[3] = {PEL_AT(0, 120), PEL_AT(176, 104),
                                          PEL_AT(0, 104)};
    static const pel_color c[3] = {0xFF000000u, 0xFFFFFFFFu, 0xFFFFFFFFu};
    static const pel_color d[3] = {0xFF000000u, 0xFFFFFFFFu, 0xFF000000u};
    pel_triangle_gouraud(s, v, c);
    pel_triangle_gouraud(s, w, d);
}

static bool draw_tile(struct canvas *canvas, const void *context)
{
    (void)context;
    draw_ramp(&canvas->surface);
    draw_discs(&canvas->surface);
    draw_greys(&canvas->surface);
    return true;
}

static void put_tile(const struct picture *sheet, const struct picture *tile,
                     int i)
{
    const int left = GAP + i % COLUMNS * (TILE_WIDTH + GAP);
    const int top = GAP + i / COLUMNS * (TILE_HEIGHT + GAP);
    for (int y = 0; y < TILE_HEIGHT; y++)
        memcpy(picture_row(sheet, top + y) + left, picture_row(tile, y),
               TILE_WIDTH * sizeof(pel_color));
}

static bool draw_formats(struct demo_result *result, int which)
{
    (void)which;
    snprintf(result->note, sizeof result->note, "In reading order: %s.",
             format_list());
    if (!picture_init(&result->picture, COLUMNS * (TILE_WIDTH + GAP) + GAP,
                      ROWS * (TILE_HEIGHT + GAP) + GAP,
                      PEL_RGB(0x20, 0x20, 0x20)))
        return false;
    for (int i = 0; format_names[i].name; i++) {
        const struct demo_size size = {format_names[i].format, TILE_WIDTH,
                                       TILE_HEIGHT};
        struct demo_result tile = {.milliseconds = 0};
        if (!demo_draw(&tile, &size, draw_tile, NULL))
            return false;
        put_tile(&result->picture, &tile.picture, i);
        result->milliseconds += tile.milliseconds;
        picture_free(&tile.picture);
    }
    return true;
}

const struct demo demo_formats[] = {
    {"formats",
     "Gouraud triangles and translucent discs, drawn in every pixel format.",
     draw_formats, 0},
    {NULL, NULL, NULL, 0},
};
