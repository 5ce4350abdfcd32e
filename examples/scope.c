/* A scope in roll mode on 320 x 240 pixels: what is there moves to the left,
 * and only the new columns of grid and traces are drawn. It needs the frame in
 * RAM: 150 KB. */
#include "drivers/display.h"
#include "panel.h"
#include "sans_15.h"

enum { WIDTH = 320, HEIGHT = 240, DIVISION = 30, DOT = 5, STEP = 4 };

static uint16_t frame[WIDTH * HEIGHT];
static struct pel_surface screen;
static int32_t now; /* px that have been rolled */

static const struct pel_rect plot = {10, 30, 311, 211}; /* 10 x 6 divisions */
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
    return pel_direction((uint16_t)(t * 728)).y * 34 / 128 +
           pel_direction((uint16_t)(t * 2184)).y * 9 / 128 + noise;
}

static int32_t square_at(int32_t t)
{
    const int32_t age = t % 60, side = t / 60 % 2 ? 1 : -1;
    const int32_t ring = pel_direction((uint16_t)(age * 7000)).x >> age / 5;
    return side * (PEL_PX(24) + ring * 8 / 128);
}

/* A column of the grid: a line of dots at every division, or one dot of each of
 * the lines across. */
static void draw_grid(int32_t x)
{
    const int32_t at = x + now;
    const int32_t step = at % DIVISION == 0 ? DOT : DIVISION;
    for (int32_t y = plot.y0; y < plot.y1 && at % DOT == 0; y += step) {
        const struct pel_rect dot = {x, y, x + 1, y + 1};
        pel_box(&screen, &dot, &line.paint);
    }
}

/* The newest columns of a trace, each joined to the one before by round ends.
 */
static void draw_trace(int32_t (*signal)(int32_t), int32_t middle,
                       int32_t columns, const struct pel_flat *color)
{
    const int32_t end = plot.x1 - 3; /* where the end of the line is seen */
    for (int32_t x = end - columns; x < end; x++) {
        const struct pel_thick_line_shape part = {
            {PEL_PX(x), PEL_PX(middle) + signal(x + now)},
            {PEL_PX(x + 1), PEL_PX(middle) + signal(x + now + 1)},
            PEL_PX(2)};
        pel_smooth_thick_line_round(&screen, &part, &color->paint);
    }
}

static void roll(int32_t columns)
{
    pel_surface_clip(&screen, &plot);
    const struct pel_exposed fresh = pel_scroll(&screen, &plot, -columns, 0);
    now += columns;
    for (int32_t i = 0; i < fresh.n; i++) {
        pel_box(&screen, &fresh.rect[i], &glass.paint);
        for (int32_t x = fresh.rect[i].x0; x < fresh.rect[i].x1; x++)
            draw_grid(x);
    }
    draw_trace(square_at, 160, columns, &cyan);
    draw_trace(tone_at, 86, columns, &yellow);
}

static void label(int32_t x, int32_t y, const char *string,
                  const struct pel_flat *color)
{
    const struct pel_text_block text = {&sans_15, string, x, y};
    pel_text(&screen, &text, &color->paint);
}

/* What stays: the frame around the plot, and what is set; the first grid. */
static void draw_frame(void)
{
    static const struct pel_rounded_shape rim = {PEL_AT(8, 28),
                                                 PEL_AT(313, 213), PEL_PX(4)};
    pel_clear(&screen, PEL_RGB(24, 30, 38));
    pel_smooth_rounded_rectangle(&screen, &rim, &glass.paint);
    label(10, 7, "CH1  500 mV", &yellow);
    label(110, 7, "CH2  2 V", &cyan);
    pel_smooth_circle(&screen, pel_at(262, 15), PEL_PX(5), &green.paint);
    label(274, 7, "Roll", &green);
    label(10, 218, "1.00 ms / div", &grey);
    label(130, 218, "Vpp  2.14 V", &grey);
    label(242, 218, "333 Hz", &grey);
    for (int32_t x = plot.x0; x < plot.x1; x++)
        draw_grid(x);
}

static enum pel_status send(const struct pel_display *panel,
                            const struct pel_rect *area)
{
    enum pel_status status = pel_display_begin(panel, area, &screen);
    if (status == PEL_OK)
        status = pel_display_flush(panel, &screen);
    return status == PEL_OK ? pel_display_flip(panel) : status;
}

int main(void)
{
    static const struct pel_rect all = {0, 0, WIDTH, HEIGHT};
    struct pel_display panel;
    if (panel_open(&panel, WIDTH, HEIGHT, &pel_rgb565_be) != PEL_OK ||
        pel_surface_init(&screen, panel.format, frame, sizeof frame, &all) !=
            PEL_OK)
        return 1;
    draw_frame();
    enum pel_status status = send(&panel, &all);
    for (int i = 0; i < 80 && status == PEL_OK; i++) {
        roll(STEP);
        status = send(&panel, &plot);
    }
    panel_close();
    return status != PEL_OK;
}
