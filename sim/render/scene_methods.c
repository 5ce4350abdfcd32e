#include "core/scene/select_light.h"
#include "sim/render/scene.h"

struct method_paint {
    struct pel_color_paint base;
    pel_color color;
};

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    (void)x;
    (void)y;
    for (int32_t i = 0; i < n; i++)
        out[i] = ((const struct method_paint *)paint)->color;
}

#define IN(r, g, b)                                     \
    {                                                   \
        PEL_COLOR_PAINT(colors, true), PEL_RGB(r, g, b) \
    }

static const struct pel_paint *paint(struct pel_frame *frame,
                                     const struct pel_color_paint *surface)
{
    static const struct method_paint paints[PEL_METHODS] = {
        IN(96, 96, 96), IN(64, 128, 255), IN(64, 192, 64), IN(255, 192, 0),
        IN(224, 32, 32)};
    pel_shade_chosen.paint(frame, surface);
    return &paints[frame->work->method].base.paint;
}

const struct pel_shading scene_shade_methods = {pel_frame_start_chosen,
                                                pel_light_note, paint};
