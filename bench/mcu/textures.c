/* What a pixel of a texture costs: lines 224 px long less lines of 96, both
 * inside the picture, or past its edge again and again where it repeats. */
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

static void texture_report(const char *name, const struct pel_texture *texture)
{
    const struct pel_paint *paint = &texture->base.paint;
    int32_t time = time_of(LONG, paint) - time_of(SHORT, paint);
    report(name, LONG - SHORT, time, (LONG - SHORT) * LINES);
}

/* A step of 0.95 texels to the right and 0.24 down for a pixel to the right. */
void textures_report(void)
{
    const uint64_t one = (uint64_t)1 << 32;
    const struct pel_texture_map map = {
        {20 * one, one / 100 * 95, 0 - one / 100 * 24},
        {20 * one, one / 100 * 24, one / 100 * 95}};
    const struct pel_texels of_picture = {.surface = &picture};
    struct pel_texture texture;
    pel_texture_init_nearest(&texture, &of_picture, &map);
    texture_report("texture-pixel", &texture);
    texture.map.u.dx = 5 * one + one / 2;
    texture.wrap_u = texture.wrap_v = PEL_WRAP_REPEAT;
    texture_report("repeat-pixel", &texture);
}
