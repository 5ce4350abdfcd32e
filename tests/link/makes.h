/* Every paint, for the little screen: programs take one, or all of them. */
#ifndef TESTS_LINK_MAKES_H
#define TESTS_LINK_MAKES_H

#include "screen.h"

typedef const struct pel_paint *make_function(void);

static const struct pel_point hub = PEL_AT(20, 40),
                              perimeter[3] = {PEL_AT(32, -5), PEL_AT(51, 60),
                                              PEL_AT(2, 50)};
static const pel_color hues[4] = {0xFFFF8040, 0x80304050, 0x00123456,
                                  0xC0FFFFFF};
static const struct pel_ramp ramp = {hues, 4, PEL_REFLECT};

static inline const struct pel_paint *make_flat(void)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
    return &flat.paint;
}

static inline const struct pel_paint *make_flat_alpha(void)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGBA(255, 128, 0, 99));
    return &flat.paint;
}

static inline const struct pel_paint *make_gouraud(void)
{
    static struct pel_gouraud paint;
    pel_gouraud_init(&paint, perimeter, hues);
    return &paint.paint;
}

static inline const struct pel_paint *make_linear(void)
{
    static struct pel_linear paint;
    pel_linear_init(&paint, hub, perimeter[0], &ramp);
    return &paint.base.paint;
}

static const pel_color warm[2] = {0xFFFF8040, 0xFF304050};

/* Ways of their own through a linear gradient: rows of one color, rows that are
 * alike and copied, and cells that are narrower than pixels. */
static inline const struct pel_paint *make_vertical(void)
{
    static struct pel_linear paint;
    pel_linear_init(&paint, hub, pel_at(20, 70), &ramp);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_horizontal(void)
{
    static const struct pel_ramp opaque = {warm, 2, PEL_PAD};
    static struct pel_linear paint;
    pel_linear_init(&paint, hub, pel_at(60, 40), &opaque);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_narrow(void)
{
    static const struct pel_ramp mixed = {hues, 2, PEL_REPEAT};
    static struct pel_linear paint;
    pel_linear_init(&paint, hub, pel_at(22, 41), &mixed);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_radial(void)
{
    static const struct pel_rings rings = {PEL_AT(20, 40), PEL_PX(9), 12345};
    static struct pel_radial paint;
    pel_radial_init(&paint, &rings, &ramp);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_narrow_rings(void)
{
    static const struct pel_ramp mixed = {hues, 2, PEL_REPEAT};
    static const struct pel_rings rings = {PEL_AT(20, 40), PEL_PX(1), 12345};
    static struct pel_radial paint;
    pel_radial_init(&paint, &rings, &mixed);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_conic(void)
{
    static struct pel_conic paint;
    pel_conic_init(&paint, hub, 12345, &ramp);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_hue(void)
{
    static struct pel_hue_wheel paint;
    pel_hue_wheel_init(&paint, hub, 12345, 255, 200);
    return &paint.conic.base.paint;
}

static inline const struct pel_paint *make_fan(void)
{
    static const struct pel_fan_points points = {PEL_AT(30, 40), 0xFF00FF00,
                                                 perimeter, hues, 3};
    static struct pel_fan_triangle triangles[3];
    static struct pel_fan paint;
    pel_fan_init(&paint, &points, triangles);
    return &paint.base.paint;
}

static uint16_t texels[16];
static const struct pel_surface picture = {
    texels, 8, {0, 0, 4, 4}, {0, 0, 4, 4}, &pel_rgb565_le};
static const struct pel_texels of_picture = {.surface = &picture};
static const struct pel_texture_map turned = {{12345, 987654321, 1000000},
                                              {0, 3456789, 1987654321}};

static inline const struct pel_paint *make_nearest(void)
{
    static struct pel_texture paint;
    pel_texture_init_nearest(&paint, &of_picture, &turned);
    paint.wrap_u = PEL_WRAP_MIRROR;
    return &paint.base.paint;
}

/* Texels of another format than the screen's go by way of colors. */
static inline const struct pel_paint *make_nearest_colors(void)
{
    static const struct pel_texels of_colors = {
        .colors = hues, .width = 2, .height = 2};
    static struct pel_texture paint;
    pel_texture_init_nearest(&paint, &of_colors, &turned);
    paint.wrap_v = PEL_WRAP_REPEAT;
    return &paint.base.paint;
}

/* And those of another surface. */
static inline const struct pel_paint *make_nearest_converted(void)
{
    static uint32_t words[4];
    static const struct pel_surface surface = {
        words, 8, {0, 0, 2, 2}, {0, 0, 2, 2}, &pel_xrgb8888};
    static const struct pel_texels of_words = {.surface = &surface};
    static struct pel_texture paint;
    pel_texture_init_nearest(&paint, &of_words, &turned);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_bilinear(void)
{
    static struct pel_texture paint;
    pel_texture_init_bilinear(&paint, &of_picture, &turned);
    paint.wrap_u = PEL_WRAP_REPEAT;
    return &paint.base.paint;
}

static inline const struct pel_paint *make_dither(void)
{
    static struct pel_dither paint;
    pel_dither_init(&paint, make_flat_alpha());
    return &paint.paint;
}

static inline const struct pel_paint *make_blend(void)
{
    static struct pel_blend paint;
    pel_blend_init(&paint, make_flat_alpha(), PEL_BLEND_XOR);
    return &paint.paint;
}

static inline const struct pel_paint *make_checker(void)
{
    static const struct pel_checker_fields fields = {3, 5, 1, 2};
    static struct pel_checker paint;
    pel_checker_init(&paint, &fields, hues[0], hues[1]);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_hatch(void)
{
    static const struct pel_hatch_lines lines = {1, -1, 5, 7, 2};
    static struct pel_hatch paint;
    pel_hatch_init(&paint, &lines, hues[0], hues[1]);
    return &paint.base.paint;
}

static inline const struct pel_paint *make_nine_slice(void)
{
    static const struct pel_rect middle = {1, 1, 3, 3}, box = {2, 3, 40, 50};
    static struct pel_nine_slice paint;
    pel_nine_slice_init(&paint, &picture, &middle, &box);
    return &paint.base.paint;
}

static void stripes(const struct pel_color_paint *paint, int32_t x, int32_t y,
                    int32_t n, pel_color *colors)
{
    (void)paint;
    for (; n > 0; n--, x++)
        *colors++ = hues[(x + y) & 3];
}

static inline const struct pel_paint *make_user(void)
{
    static const struct pel_color_paint striped =
        PEL_COLOR_PAINT(stripes, false);
    return &striped.paint;
}

/* All of them, each as EACH(name). */
#define EVERY_MAKE(EACH)                                                     \
    EACH(flat), EACH(flat_alpha), EACH(gouraud), EACH(linear), EACH(radial), \
        EACH(conic), EACH(hue), EACH(fan), EACH(nearest),                    \
        EACH(nearest_colors), EACH(bilinear), EACH(dither), EACH(blend),     \
        EACH(checker), EACH(hatch), EACH(nine_slice), EACH(user)

/* Other ways through some of them. */
#define EVERY_WAY(EACH)                                                 \
    EACH(vertical), EACH(horizontal), EACH(narrow), EACH(narrow_rings), \
        EACH(nearest_converted)

#endif
