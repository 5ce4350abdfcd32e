/* A gauge on a panel of 240 x 240 pixels behind SPI (ST7789, GC9A01): two bands
 * of eight lines in turn, and after the first frame only what has changed. */
#include "drivers/dirty.h"
#include "digits_36.h"
#include "panel.h"

enum { FIRST = 24576, ROUND = 49152 }; /* of the scale: turns / 65,536 */

static uint16_t band[2][240 * 8];
static struct pel_linear sky;
static struct pel_dither back;
static struct pel_point way; /* of the needle */
static char value[] = "  0\xC2\xB0";

static void draw_needle(const struct pel_surface *screen,
                        const struct pel_paint *paint)
{
    const int32_t center = PEL_PX(120);
    const struct pel_point v[3] = {
        {center + way.x * 5 / 8, center + way.y * 5 / 8}, /* 80 px */
        {center - way.y / 24, center + way.x / 24},       /* 5 px */
        {center + way.y / 24, center - way.x / 24}};
    pel_smooth_triangle(screen, v, paint);
}

static void draw(void *context, const struct pel_surface *screen)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_flat amber = PEL_FLAT(PEL_RGB(255, 170, 40));
    static const struct pel_arc_shape scale = {
        PEL_AT(120, 120), PEL_PX(92), PEL_PX(108), FIRST, FIRST + ROUND};
    static const struct pel_text_column text = {
        {&digits_36, value, 120, 172}, 0, 0, PEL_TEXT_CENTER};
    (void)context;
    pel_box(screen, &screen->bounds, &back.paint);
    pel_smooth_arc_round(screen, &scale, &amber.paint);
    pel_text_column_draw(screen, &text, &white.paint);
    draw_needle(screen, &white.paint);
    pel_smooth_circle(screen, scale.center, PEL_PX(9), &amber.paint);
}

/* Where needle and text were is dirty, and where they are. */
static void set_value(struct pel_dirty_areas *dirty, int degrees)
{
    static const struct pel_surface no_pixels = PEL_NO_PIXELS(240, 240);
    static const struct pel_rect text = {78, 172, 162, 208};
    struct pel_dirty needle;
    pel_dirty_areas_add(dirty, &text);
    for (int i = 0; i < 2; i++) {
        pel_dirty_begin(&needle, NULL);
        draw_needle(&no_pixels, &needle.paint);
        pel_dirty_areas_add(dirty, &needle.box);
        way = pel_direction((uint16_t)(FIRST + degrees * ROUND / 270));
    }
    value[0] = (char)(degrees < 100 ? ' ' : '0' + degrees / 100);
    value[1] = (char)(degrees < 10 ? ' ' : '0' + degrees / 10 % 10);
    value[2] = (char)('0' + degrees % 10);
}

int main(void)
{
    static const pel_color blues[2] = {PEL_RGB(10, 20, 60),
                                       PEL_RGB(40, 120, 190)};
    static const struct pel_ramp ramp = {blues, 2, PEL_PAD};
    static const struct pel_dirty_work work = {
        {band[0], band[1]}, sizeof band[0], draw, NULL};
    static const struct pel_rect all = {0, 0, 240, 240};
    const struct pel_point top = PEL_AT(0, 0), bottom = PEL_AT(0, 240);
    struct pel_dirty_areas dirty = {.window = 200};
    struct pel_display panel;
    enum pel_status status = panel_open(&panel, 240, 240, &pel_rgb565_be);
    if (status == PEL_OK)
        status = pel_linear_init(&sky, top, bottom, &ramp);
    if (status == PEL_OK)
        status = pel_dither_init(&back, &sky.base.paint);
    pel_dirty_areas_add(&dirty, &all);
    for (int degrees = 0; degrees <= 270 && status == PEL_OK; degrees++) {
        set_value(&dirty, degrees);
        status = pel_dirty_areas_show(&dirty, &panel, &work);
    }
    panel_close();
    return status != PEL_OK;
}
