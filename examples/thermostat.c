/* A thermostat on a panel of 320 x 240 pixels (ILI9341, ST7789), in two bands
 * of 16 lines; a turn of the knob draws and sends what it changes. */
#include "drivers/dirty.h"
#include "digits_76.h"
#include "drop.h"
#include "flame.h"
#include "panel.h"
#include "sans_17.h"
#include "sun.h"

enum { WIDTH = 320, HEIGHT = 240 };
/* The dial: 10 to 30 degrees are three quarters of a turn. */
enum { FIRST = 24576, ROUND = 49152, LOWEST = 100, HIGHEST = 300 };

static uint16_t band[2][WIDTH * 16];
static int target = 175; /* tenths of a degree */
static char degrees[] = "17.5";
static struct pel_linear dusk;
static struct pel_dither back;
static struct pel_linear heat;
static const struct pel_point center = PEL_AT(112, 120);
static const struct pel_flat water = PEL_FLAT(PEL_RGB(110, 190, 255));
static const struct pel_flat amber = PEL_FLAT(PEL_RGB(255, 180, 80));
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
static const struct pel_flat soft = PEL_FLAT(PEL_RGBA(255, 255, 255, 150));
static const struct pel_flat faint = PEL_FLAT(PEL_RGBA(255, 255, 255, 36));

/* The paints keep the address of their ramp, whose colors are static. */
static bool make_paints(void)
{
    static pel_color colors[64];
    static const pel_color ends[2] = {PEL_RGB(22, 28, 58), PEL_RGB(92, 44, 62)};
    static const struct pel_ramp night = {ends, 2, PEL_PAD};
    static const struct pel_ramp warm = {colors, 64, PEL_PAD};
    static const struct pel_stop stops[3] = {{0, PEL_RGB(80, 140, 255)},
                                             {32768, PEL_RGB(232, 120, 200)},
                                             {65536, PEL_RGB(255, 120, 40)}};
    return pel_ramp_fill(colors, 64, stops, 3) == PEL_OK &&
           pel_linear_init(&heat, pel_at(16, 0), pel_at(208, 0), &warm) ==
               PEL_OK &&
           pel_linear_init(&dusk, pel_at(0, 0), pel_at(0, 240), &night) ==
               PEL_OK &&
           pel_dither_init(&back, &dusk.base.paint) == PEL_OK;
}

static int32_t turn_of(int tenths)
{
    return FIRST + (tenths - LOWEST) * ROUND / (HIGHEST - LOWEST);
}

static void draw_knob(const struct pel_surface *screen,
                      const struct pel_paint *paint)
{
    pel_smooth_circle(screen, pel_polar(center, PEL_PX(93), turn_of(target)),
                      PEL_PX(10), paint);
}

/* The icon is a picture of coverage, through which the paint is seen. */
static void draw_icon(const struct pel_surface *screen,
                      const struct pel_image_asset *icon, int32_t x, int32_t y,
                      const struct pel_flat *color)
{
    struct pel_surface picture;
    struct pel_masked masked;
    if (pel_image_asset_surface(&picture, icon, &pel_gray4) == PEL_OK &&
        pel_masked_init(&masked, &picture, x, y, &color->paint) == PEL_OK)
        pel_box(screen, &masked.box, &masked.base.paint);
}

/* The air in and outside, and the fan's slider. */
static void draw_card(const struct pel_surface *screen)
{
    static const struct pel_rounded_shape card = {PEL_AT(222, 22),
                                                  PEL_AT(308, 218), PEL_PX(12)};
    static const struct pel_rounded_shape track = {PEL_AT(234, 185),
                                                   PEL_AT(296, 191), PEL_PX(3)};
    static const struct pel_text_block humidity = {&sans_17, "45 %", 264, 45};
    static const struct pel_text_block out = {&sans_17, "8.3\xC2\xB0", 264, 97};
    static const struct pel_text_block name = {&sans_17, "Fan", 234, 152};
    struct pel_rounded_shape part = track;
    part.to.x = PEL_PX(234 + (target - LOWEST) * 62 / (HIGHEST - LOWEST));
    pel_smooth_rounded_rectangle(screen, &card, &faint.paint);
    draw_icon(screen, &drop, 233, 42, &water);
    pel_text(screen, &humidity, &white.paint);
    draw_icon(screen, &sun, 233, 94, &amber);
    pel_text(screen, &out, &white.paint);
    pel_text(screen, &name, &soft.paint);
    pel_smooth_rounded_rectangle(screen, &track, &faint.paint);
    pel_smooth_rounded_rectangle(screen, &part, &water.paint);
    pel_smooth_circle(screen, pel_point_of(part.to.x, PEL_PX(188)), PEL_PX(8),
                      &white.paint);
}

static void draw(void *context, const struct pel_surface *screen)
{
    static const struct pel_text_column value = {
        {&digits_76, degrees, 112, 82}, 0, 0, PEL_TEXT_CENTER};
    static const struct pel_text_column room = {
        {&sans_17, "Living room", 112, 158}, 0, 0, PEL_TEXT_CENTER};
    struct pel_arc_shape arc = {center, PEL_PX(88), PEL_PX(98), FIRST,
                                FIRST + ROUND};
    (void)context;
    pel_box(screen, &screen->bounds, &back.paint);
    pel_smooth_arc_round(screen, &arc, &faint.paint);
    arc.to = turn_of(target);
    pel_smooth_arc_round(screen, &arc, &heat.base.paint);
    draw_knob(screen, &white.paint);
    draw_icon(screen, &flame, 100, 54, &amber);
    pel_text_column_draw(screen, &value, &white.paint);
    pel_text_column_draw(screen, &room, &soft.paint);
    draw_card(screen);
}

/* The knob, before and after a turn, the digits and the slider change. */
static void turn_up(struct pel_dirty_areas *dirty)
{
    static const struct pel_surface no_pixels = PEL_NO_PIXELS(WIDTH, HEIGHT);
    static const struct pel_rect digits = {36, 82, 188, 150};
    static const struct pel_rect slider = {226, 180, 304, 196};
    struct pel_dirty knob;
    pel_dirty_begin(&knob, NULL);
    draw_knob(&no_pixels, &knob.paint);
    target += 5;
    draw_knob(&no_pixels, &knob.paint);
    pel_dirty_areas_add(dirty, &knob.box);
    pel_dirty_areas_add(dirty, &digits);
    pel_dirty_areas_add(dirty, &slider);
    degrees[0] = (char)('0' + target / 100);
    degrees[1] = (char)('0' + target / 10 % 10);
    degrees[3] = (char)('0' + target % 10);
}

int main(void)
{
    static const struct pel_dirty_work work = {
        {band[0], band[1]}, sizeof band[0], draw, NULL};
    struct pel_dirty_areas dirty = {200, 1, {{0, 0, WIDTH, HEIGHT}}};
    struct pel_display panel;
    if (!make_paints() ||
        panel_open(&panel, WIDTH, HEIGHT, &pel_rgb565_be) != PEL_OK)
        return 1;
    for (int i = 0; i < 10; i++) {
        turn_up(&dirty);
        if (pel_dirty_areas_show(&dirty, &panel, &work) != PEL_OK)
            return 1;
    }
    panel_close();
    return 0;
}
