/* A gauge on a panel of 240 x 240 pixels behind SPI (ST7789, GC9A01): two bands
 * of eight lines in turn, and after the first frame only what has changed.
 * Prints bytes and, in QEMU, instructions of frames, then the last frame. */
#include "../bench/mcu/stopwatch.h"
#include "../drivers/dirty.h"
#include "fixed_10x20.h"
#include "ppm.h"

enum { SIDE = 240, FIRST = 24576, ROUND = 49152 }; /* turns of the scale */

static uint16_t band[2][SIDE * 8], memory[SIDE * SIDE];
static const struct pel_surface glass = {
    memory, SIDE * 2, {0, 0, SIDE, SIDE}, {0, 0, SIDE, SIDE}, &pel_rgb565_be};
static struct pel_dirty_areas dirty = {.window = 200};
static struct pel_linear sky;
static struct pel_dither back;
static struct pel_point way; /* the needle's */
static char value[8];
static uint32_t idle; /* of the stopwatch */

/* The panel's driver. On a board it begins a transfer that `wait` waits for;
 * here the DMA is the program's own, in time that does not count. */
static enum pel_status send(const struct pel_display *panel,
                            const struct pel_surface *s)
{
    const struct pel_copy_part part = {s, s->clip, s->clip.x0, s->clip.y0};
    const uint32_t from = stopwatch_read();
    (void)panel;
    pel_copy(&glass, &part);
    idle += stopwatch_read() - from;
    return PEL_OK;
}

static void draw_needle(const struct pel_surface *screen,
                        const struct pel_paint *paint)
{
    const int32_t center = PEL_PX(SIDE / 2);
    const struct pel_point v[3] = {
        {center + way.x * 5 / 8, center + way.y * 5 / 8}, /* 80 px */
        {center - way.y / 24, center + way.x / 24},       /* 5 px */
        {center + way.y / 24, center - way.x / 24}};
    pel_triangle(screen, v, paint);
}

static void draw(void *context, const struct pel_surface *screen)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_flat amber = PEL_FLAT(PEL_RGB(255, 170, 40));
    static const struct pel_arc_shape scale = {
        PEL_AT(120, 120), PEL_PX(92), PEL_PX(108), FIRST, FIRST + ROUND};
    static const struct pel_text_block text = {&fixed_10x20, value, 100, 180};
    (void)context;
    pel_box(screen, &screen->bounds, &back.paint);
    pel_arc(screen, &scale, &amber.paint);
    pel_text(screen, &text, &white.paint);
    draw_needle(screen, &white.paint);
    pel_circle(screen, scale.center, PEL_PX(9), &amber.paint);
}

/* Where needle and text were is dirty, and where they are. */
static void set_value(int degrees)
{
    static const struct pel_rect text = {100, 180, 140, 200};
    struct pel_dirty needle;
    pel_dirty_areas_add(&dirty, &text);
    for (int i = 0; i < 2; i++) {
        pel_dirty_begin(&needle, NULL);
        draw_needle(&glass, &needle.paint);
        pel_dirty_areas_add(&dirty, &needle.box);
        way = pel_direction((uint16_t)(FIRST + degrees * ROUND / 270));
    }
    snprintf(value, sizeof value, "%3d\xC2\xB0", degrees % 1000);
}

/* Instructions of a frame. */
static int show(void)
{
    static const struct pel_display panel = {
        .width = SIDE, .height = SIDE, .format = &pel_rgb565_be, .flush = send};
    static const struct pel_dirty_work work = {
        {band[0], band[1]}, sizeof band[0], draw, NULL};
    const uint32_t from = stopwatch_read();
    idle = 0;
    pel_dirty_areas_show(&dirty, &panel, &work);
    return (int)stopwatch_eighths(from + idle, stopwatch_read()) / 8;
}

int main(void)
{
    static const pel_color blues[2] = {PEL_RGB(10, 20, 60),
                                       PEL_RGB(40, 120, 190)};
    static const struct pel_ramp ramp = {blues, 2, PEL_PAD};
    const struct pel_point top = PEL_AT(0, 0), bottom = PEL_AT(0, SIDE);
    int bytes = 0, most = 0;
    if (pel_linear_init(&sky, top, bottom, &ramp) != PEL_OK ||
        pel_dither_init(&back, &sky.base.paint) != PEL_OK)
        return 1;
    stopwatch_start();
    set_value(0);
    pel_dirty_areas_add(&dirty, &glass.bounds);
    printf("P6\n# whole: %d bytes, %d instructions\n", SIDE * SIDE * 2, show());
    for (int degrees = 1; degrees <= 270; degrees++) {
        set_value(degrees);
        bytes += 2 * pel_dirty_areas_pixels(&dirty);
        most = pel_max(most, show());
    }
    printf("# step: %d bytes, at most %d instructions\n%d %d 255\n",
           bytes / 270, most, SIDE, SIDE);
    ppm_write(&glass);
    return 0;
}
