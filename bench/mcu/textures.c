/* What a pixel of a texture costs past the edge of its picture, again and again
 * where it repeats: lines 224 px long less lines of 96. */
#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { SIDE = 256, LINES = 64, LONG = 224, SHORT = 96 };

static uint16_t texels[SIDE * SIDE];
static uint16_t pixels[SIDE * LINES];

static const struct pel_surface picture = {
    .pixels = texels,
    .stride = SIDE * 2,
    .bounds = {0, 0, SIDE, SIDE},
    .clip = {0, 0, SIDE, SIDE},
    .format = &pel_rgb565_le,
};
static const struct pel_surface screen = {
    .pixels = pixels,
    .stride = SIDE * 2,
    .bounds = {0, 0, SIDE, LINES},
    .clip = {0, 0, SIDE, LINES},
    .format = &pel_rgb565_le,
};

static int32_t time_of(int32_t width, const struct pel_paint *paint)
{
    const struct pel_point from = {0, 0}, to = {PEL_PX(width), PEL_PX(LINES)};
    uint32_t start = stopwatch_read();
    pel_rectangle(&screen, from, to, paint);
    return stopwatch_eighths(start, stopwatch_read());
}

/* A step of 5.5 texels to the right and 0.24 down for a pixel to the right. */
void textures_report(void)
{
    const uint64_t one = (uint64_t)1 << 32;
    const struct pel_texture_map map = {
        {20 * one, 5 * one + one / 2, 0 - one / 100 * 24},
        {20 * one, one / 100 * 24, one / 100 * 95}};
    const struct pel_texels of_picture = {.surface = &picture};
    struct pel_texture texture;
    pel_texture_init_nearest(&texture, &of_picture, &map);
    texture.wrap_u = texture.wrap_v = PEL_WRAP_REPEAT;
    report("repeat-pixel", LONG - SHORT,
           time_of(LONG, &texture.base.paint) -
               time_of(SHORT, &texture.base.paint),
           (LONG - SHORT) * LINES);
}
