/* A scope in roll mode on 480 x 320 pixels (ST7796): the panel moves
 * what it shows, and only the new columns of grid and traces are drawn and
 * sent. No frame is kept; a trace has 320 points, each joined to the next. */
#include "drivers/display.h"
#include "panel.h"
#include "sans_15.h"

enum { WIDTH = 480, HEIGHT = 320, DIVISION = 32, DOT = 4, STEP = 4 };
enum { COLUMNS = 16 }; /* of the first frame at a time */

static uint16_t memory[COLUMNS * HEIGHT];
static int32_t now; /* px that have been rolled */

static const struct pel_rect plot = {0, 0, 320, HEIGHT}; /* 10 x 10 divisions */
static const struct pel_flat glass = PEL_FLAT(PEL_RGB(10, 18, 24));
static const struct pel_flat line = PEL_FLAT(PEL_RGB(70, 96, 104));
static const struct pel_flat yellow = PEL_FLAT(PEL_RGB(255, 214, 64));
static const struct pel_flat cyan = PEL_FLAT(PEL_RGB(72, 210, 240));
static const struct pel_flat green = PEL_FLAT(PEL_RGB(110, 230, 120));
static const struct pel_flat grey = PEL_FLAT(PEL_RGB(150, 164, 172));

/* The signals, in 1/256 px from their middle: a tone with a third harmonic and
 * some noise, and a square that rings. */
static int32_t tone_at(int32_t t)
{
    const int32_t noise = (int32_t)((uint32_t)t * 2654435761u >> 24) - 128;
    return pel_direction((uint16_t)(t * 728)).y * 46 / 128 +
           pel_direction((uint16_t)(t * 2184)).y * 12 / 128 + noise;
}

static int32_t square_at(int32_t t)
{
    const int32_t age = t % 60, side = t / 60 % 2 ? 1 : -1;
    const int32_t ring = pel_direction((uint16_t)(age * 7000)).x >> age / 5;
    return side * (PEL_PX(34) + ring * 11 / 128);
}

/* A column of the grid: a line of dots at every division, or one dot of each of
 * the lines across. */
static void draw_grid(const struct pel_surface *screen, int32_t x)
{
    const int32_t at = x + now;
    const int32_t step = at % DIVISION == 0 ? DOT : DIVISION;
    for (int32_t y = plot.y0; y < plot.y1 && at % DOT == 0; y += step) {
        const struct pel_rect dot = {x, y, x + 1, y + 1};
        pel_box(screen, &dot, &line.paint);
    }
}

/* What is seen of a trace: the lines that end in these columns, or, as ends are
 * round, 1 px beside them. */
static void draw_trace(const struct pel_surface *screen,
                       int32_t (*signal)(int32_t), int32_t middle,
                       const struct pel_flat *color)
{
    for (int32_t x = screen->clip.x0 - 1; x <= screen->clip.x1; x++) {
        const struct pel_thick_line_shape part = {
            {PEL_PX(x), PEL_PX(middle) + signal(x + now)},
            {PEL_PX(x + 1), PEL_PX(middle) + signal(x + now + 1)},
            PEL_PX(2)};
        pel_smooth_thick_line_round(screen, &part, &color->paint);
    }
}

static void draw_plot(struct pel_surface *screen)
{
    pel_surface_clip(screen, &plot);
    if (pel_rect_empty(&screen->clip))
        return;
    pel_box(screen, &plot, &glass.paint);
    for (int32_t x = screen->clip.x0; x < screen->clip.x1; x++)
        draw_grid(screen, x);
    if (now == 0)
        return; /* nothing has been measured */
    draw_trace(screen, square_at, 222, &cyan);
    draw_trace(screen, tone_at, 104, &yellow);
}

static void label(const struct pel_surface *screen, int32_t x, int32_t y,
                  const char *string, const struct pel_flat *color)
{
    const struct pel_text_block text = {&sans_15, string, x, y};
    pel_text(screen, &text, &color->paint);
}

static void draw_channel(const struct pel_surface *screen, int32_t y,
                         const char *name, const char *values,
                         const struct pel_flat *color)
{
    const struct pel_rounded_shape card = {PEL_AT(332, y), PEL_AT(470, y + 74),
                                           PEL_PX(6)};
    const struct pel_rect mark = {332, y + 12, 336, y + 62};
    pel_smooth_rounded_rectangle(screen, &card, &glass.paint);
    pel_box(screen, &mark, &color->paint);
    label(screen, 346, y + 10, name, color);
    label(screen, 346, y + 34, values, &grey);
}

/* What stands still. */
static void draw_side(const struct pel_surface *screen)
{
    pel_smooth_circle(screen, pel_at(342, 24), PEL_PX(5), &green.paint);
    label(screen, 354, 16, "Roll", &green);
    draw_channel(screen, 50, "CH1", "500 mV / div\nVpp  2.14 V", &yellow);
    draw_channel(screen, 136, "CH2", "2 V / div\n333 Hz", &cyan);
    label(screen, 336, 226, "1.00 ms / div", &grey);
}

/* Some columns of the screen, in the memory that there is, once it is sent. */
static enum pel_status show(const struct pel_display *panel, int32_t x0,
                            int32_t x1)
{
    const struct pel_rect columns = {x0, 0, x1, HEIGHT};
    struct pel_surface screen;
    enum pel_status status = pel_display_wait(panel);
    if (status == PEL_OK)
        status = pel_surface_init(&screen, panel->format, memory, sizeof memory,
                                  &columns);
    if (status != PEL_OK)
        return status;
    pel_clear(&screen, PEL_RGB(24, 30, 38));
    if (x1 > plot.x1)
        draw_side(&screen);
    draw_plot(&screen);
    pel_surface_clip(&screen, &columns);
    return pel_display_flush(panel, &screen);
}

int main(void)
{
    struct pel_display panel;
    enum pel_status status = panel_open(&panel, WIDTH, HEIGHT, &pel_rgb565_be);
    for (int32_t x = 0; x < WIDTH && status == PEL_OK; x += COLUMNS)
        status = show(&panel, x, x + COLUMNS);
    for (int i = 0; i < 80 && status == PEL_OK; i++) {
        status = pel_display_flip(&panel);
        if (status == PEL_OK)
            status = panel_scroll(&panel, &plot, STEP);
        now += STEP;
        if (status == PEL_OK)
            status = show(&panel, plot.x1 - STEP, plot.x1);
    }
    if (status == PEL_OK)
        status = pel_display_flip(&panel);
    panel_close();
    return status != PEL_OK;
}
