/* Gradients, dithered, a texture and text; the picture goes to standard output
 * as PPM.
 *
 *     build/pel import sim/scenes/fixed_6x13.bdf -o fixed_6x13.c
 *     cc -Iinclude -I. examples/paints.c fixed_6x13.c build/libpel.a
 */
#include "fixed_6x13.h"
#include "ppm.h"

enum { WIDTH = 300, HEIGHT = 120, COLORS = 256 };

/* White over orange to blue. A paint keeps the ramp's array, not a copy. */
static pel_color sunset[COLORS];

static enum pel_status set_sunset(void)
{
    static const struct pel_stop stops[3] = {
        {0, PEL_RGB(255, 255, 230)},
        {26000, PEL_RGB(255, 140, 40)},
        {65536, PEL_RGB(30, 20, 90)}}; /* 65,536 is the end of the way */
    return pel_ramp_fill(sunset, COLORS, stops, 3);
}

/* From left to right. Two colors are mixed on the way, without a ramp; the
 * dither hides the steps of RGB565. */
static enum pel_status draw_strip(const struct pel_surface *screen)
{
    static const pel_color ends[2] = {PEL_RGB(255, 225, 200),
                                      PEL_RGB(200, 215, 255)};
    static const struct pel_point from = PEL_AT(0, 0), to = PEL_AT(WIDTH, 0);
    static const struct pel_rect strip = {0, 98, WIDTH, HEIGHT};
    const struct pel_ramp ramp = {ends, 2, PEL_PAD};
    struct pel_linear linear;
    struct pel_dither paint;
    enum pel_status status = pel_linear_init(&linear, from, to, &ramp);
    if (status == PEL_OK)
        status = pel_dither_init(&paint, &linear.base.paint);
    if (status == PEL_OK)
        pel_box(screen, &strip, &paint.paint);
    return status;
}

static enum pel_status draw_star(const struct pel_surface *screen)
{
    static const struct pel_point corners[5] = {PEL_AT(50, 5), PEL_AT(76, 86),
                                                PEL_AT(7, 36), PEL_AT(93, 36),
                                                PEL_AT(24, 86)};
    static const struct pel_polygon_shape star = {corners, 5, PEL_NON_ZERO};
    static const struct pel_rings rings = {PEL_AT(50, 50), PEL_PX(45), 0};
    static uint32_t scratch[PEL_POLYGON_SCRATCH_SIZE(5) / 4];
    const struct pel_ramp ramp = {sunset, COLORS, PEL_PAD};
    struct pel_radial paint;
    const enum pel_status status = pel_radial_init(&paint, &rings, &ramp);
    if (status != PEL_OK)
        return status;
    return pel_polygon(screen, &star, &paint.base.paint, scratch,
                       sizeof scratch);
}

static enum pel_status draw_dial(const struct pel_surface *screen)
{
    static const struct pel_ring_shape ring = {PEL_AT(150, 50), PEL_PX(24),
                                               PEL_PX(45)};
    const struct pel_ramp ramp = {sunset, COLORS, PEL_REFLECT};
    struct pel_conic paint;
    const enum pel_status status =
        pel_conic_init(&paint, ring.center, 49152, &ramp); /* from the top */
    if (status == PEL_OK)
        pel_ring(screen, &ring, &paint.base.paint);
    return status;
}

/* A picture of 2 x 2 pixels, ten times as large and turned a little: where on
 * the screen three of its points are to be. */
static enum pel_status draw_ball(const struct pel_surface *screen)
{
    static const pel_color colors[4] = {
        PEL_RGB(200, 40, 40), PEL_RGB(250, 240, 220), PEL_RGB(250, 240, 220),
        PEL_RGB(40, 60, 160)};
    static const struct pel_texels picture = {NULL, colors, 2, 2, true};
    static const struct pel_point at[3] = {PEL_AT(240, 10), PEL_AT(259, 14),
                                           PEL_AT(236, 29)};
    static const struct pel_texel_point shown[3] = {
        {0, 0}, {2 * 256, 0}, {0, 2 * 256}};
    const struct pel_point center = PEL_AT(250, 50);
    struct pel_texture_map map;
    struct pel_texture paint;
    enum pel_status status = pel_texture_map_triangle(&map, at, shown);
    if (status == PEL_OK)
        status = pel_texture_init_nearest(&paint, &picture, &map);
    if (status != PEL_OK)
        return status;
    paint.wrap_u = paint.wrap_v = PEL_WRAP_REPEAT;
    pel_circle(screen, center, PEL_PX(45), &paint.base.paint);
    return PEL_OK;
}

/* Around x, 100 pixels down. */
static void write_name(const struct pel_surface *screen, int32_t x,
                       const char *name)
{
    static const struct pel_flat ink = PEL_FLAT(PEL_RGB(40, 40, 40));
    const struct pel_text_size size = pel_text_measure(&fixed_6x13, name);
    const struct pel_text_block text = {&fixed_6x13, name, x - size.width / 2,
                                        100};
    pel_text(screen, &text, &ink.paint);
}

int main(void)
{
    static uint16_t pixels[WIDTH * HEIGHT];
    static const struct pel_rect all = {0, 0, WIDTH, HEIGHT};
    struct pel_surface screen;
    if (pel_surface_init(&screen, &pel_rgb565_le, pixels, sizeof pixels,
                         &all) != PEL_OK)
        return 1;
    pel_clear(&screen, PEL_RGB(255, 255, 255));
    if (set_sunset() != PEL_OK || draw_strip(&screen) != PEL_OK ||
        draw_star(&screen) != PEL_OK || draw_dial(&screen) != PEL_OK ||
        draw_ball(&screen) != PEL_OK)
        return 1;
    write_name(&screen, 50, "radial");
    write_name(&screen, 150, "conic");
    write_name(&screen, 250, "texture");
    printf("P6 %d %d 255\n", WIDTH, HEIGHT);
    ppm_write(&screen);
    return 0;
}
