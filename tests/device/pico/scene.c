#include "scene.h"

#include "fixed_10x20.h"
#include "fixed_6x13.h"

enum { FIRST = 24576, ROUND = 49152 }; /* of the scale: turns / 65,536 */

static const struct pel_rect value_box = {100, 180, 140, 200};
static const struct pel_rect count_box = {0, 0, 128, 32};
static const struct pel_rect disc_box = {96, 33, 128, 64};

static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

static void draw_needle(const struct pel_surface *screen, int32_t degrees,
                        const struct pel_paint *paint)
{
    const struct pel_point way =
        pel_direction((uint16_t)(FIRST + degrees * ROUND / 270));
    const int32_t center = PEL_PX(120);
    const struct pel_point v[3] = {
        {center + way.x * 5 / 8, center + way.y * 5 / 8},
        {center - way.y / 24, center + way.x / 24},
        {center + way.y / 24, center - way.x / 24}};
    pel_triangle(screen, v, paint);
}

static void draw_spot(const struct pel_surface *screen, const struct scene *s,
                      const struct pel_paint *paint)
{
    const struct pel_point center = PEL_AT(s->x, s->y);
    if (s->x >= 0)
        pel_smooth_circle(screen, center, PEL_PX(14), paint);
}

/* A number of up to three digits, right-aligned. */
static void put_number(char text[3], int32_t n)
{
    for (int i = 2; i >= 0; i--, n /= 10)
        text[i] = n || i == 2 ? (char)('0' + n % 10) : ' ';
}

void scene_draw_lcd(void *context, const struct pel_surface *screen)
{
    static const pel_color blues[2] = {PEL_RGB(10, 20, 60),
                                       PEL_RGB(40, 120, 190)};
    static const struct pel_ramp ramp = {blues, 2, PEL_PAD};
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(255, 170, 40, 150));
    static const struct pel_arc_shape scale = {
        PEL_AT(120, 120), PEL_PX(92), PEL_PX(108), FIRST, FIRST + ROUND};
    const struct pel_point top = PEL_AT(0, 0), bottom = PEL_AT(0, LCD_SIDE);
    const struct scene *s = context;
    char value[] = "   \xC2\xB0";
    const struct pel_text_block text = {&fixed_10x20, value, value_box.x0,
                                        value_box.y0};
    struct pel_linear sky;
    struct pel_dither back;
    if (pel_linear_init(&sky, top, bottom, &ramp) ||
        pel_dither_init(&back, &sky.base.paint))
        return;
    put_number(value, s->degrees);
    pel_box(screen, &screen->bounds, &back.paint);
    pel_arc(screen, &scale, &glass.paint);
    pel_text(screen, &text, &white.paint);
    draw_needle(screen, s->degrees, &white.paint);
    pel_circle(screen, scale.center, PEL_PX(9), &glass.paint);
    draw_spot(screen, s, &glass.paint);
}

void scene_draw_oled(void *context, const struct pel_surface *screen)
{
    const struct scene *s = context;
    char turned[] = "turned      \xC2\xB0", pressed[] = "pressed     ";
    const struct pel_text_block lines[2] = {{&fixed_6x13, turned, 4, 2},
                                            {&fixed_6x13, pressed, 4, 17}};
    const struct pel_point center = PEL_AT(112, 49);
    put_number(turned + 9, s->degrees);
    put_number(pressed + 9, s->presses);
    pel_clear(screen, PEL_RGB(0, 0, 0));
    pel_text(screen, &lines[0], &white.paint);
    pel_text(screen, &lines[1], &white.paint);
    if (s->held)
        pel_circle(screen, center, PEL_PX(13), &white.paint);
}

void scene_changes(const struct scene *before, const struct scene *now,
                   struct pel_dirty_areas *lcd, struct pel_dirty_areas *oled)
{
    static const struct pel_surface no_pixels =
        PEL_NO_PIXELS(LCD_SIDE, LCD_SIDE);
    const struct scene *both[2] = {before, now};
    for (int i = 0; i < 2; i++) {
        struct pel_dirty needle, spot;
        pel_dirty_begin(&needle, NULL);
        draw_needle(&no_pixels, both[i]->degrees, &needle.paint);
        if (before->degrees != now->degrees)
            pel_dirty_areas_add(lcd, &needle.box);
        pel_dirty_begin(&spot, NULL);
        draw_spot(&no_pixels, both[i], &spot.paint);
        pel_dirty_areas_add(lcd, &spot.box);
    }
    if (before->degrees != now->degrees)
        pel_dirty_areas_add(lcd, &value_box);
    if (before->degrees != now->degrees || before->presses != now->presses)
        pel_dirty_areas_add(oled, &count_box);
    if (before->held != now->held)
        pel_dirty_areas_add(oled, &disc_box);
}
