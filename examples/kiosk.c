/* The screen of a coffee machine, by touch and keys: left, right, enter; escape
 * ends it. `make device EXAMPLE=kiosk` draws it in the middle of /dev/fb0 or of
 * a DRM device, without a desktop; `make window EXAMPLE=kiosk` on one. */
#include <stdio.h>

#include "kiosk_events.h"
#include "drivers/dirty.h"
#include "panel.h"
#include "sans_17.h"
#include "sans_24.h"
#include "sans_40.h"

enum { WIDTH = 480, HEIGHT = 320, CARD = 128, STEP = 148, DRINKS = 3 };

static const struct drink {
    const char *name, *price;
    int32_t width, height; /* px of the cup */
} drinks[DRINKS] = {{"Espresso", "1.60", 36, 28},
                    {"Cappuccino", "2.80", 58, 36},
                    {"Latte", "3.10", 38, 56}};

static uint32_t band[WIDTH * 40];
static int chosen, brewed = -1; /* percent; -1: nobody waits */
static int32_t left, top;       /* px: where our screen is on the device's */

static const struct pel_flat brown = PEL_FLAT(PEL_RGB(74, 48, 36));
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 253, 250));
static const struct pel_flat shadow = PEL_FLAT(PEL_RGBA(74, 48, 36, 34));
static const struct pel_flat orange = PEL_FLAT(PEL_RGB(222, 104, 44));

static void draw_round(const struct pel_surface *screen,
                       const struct pel_rect *box, int32_t radius,
                       const struct pel_flat *color)
{
    const struct pel_rounded_shape shape = {{PEL_PX(box->x0), PEL_PX(box->y0)},
                                            {PEL_PX(box->x1), PEL_PX(box->y1)},
                                            PEL_PX(radius)};
    pel_smooth_rounded_rectangle(screen, &shape, &color->paint);
}

static void draw_cup(const struct pel_surface *screen, const struct drink *d,
                     int32_t x, const struct pel_flat *color)
{
    const int32_t h = d->height, w = d->width / 2;
    const struct pel_rect cup = {x - w, 178 - h, x + w, 178};
    const struct pel_rect plate = {x - w - 10, 182, x + w + 10, 186};
    const struct pel_ring_shape handle = {
        {PEL_PX(x + w), PEL_PX(178 - h / 2)}, PEL_PX(6), PEL_PX(11)};
    draw_round(screen, &cup, 9, color);
    draw_round(screen, &plate, 2, color);
    pel_smooth_ring(screen, &handle, &color->paint);
}

static void draw_card(const struct pel_surface *screen, int i)
{
    const int32_t x = 28 + i * STEP, middle = x + CARD / 2;
    const struct pel_rect card = {x, 106, x + CARD, 250};
    const struct pel_rect below = {x, 110, x + CARD, 254};
    const struct pel_flat *ink = i == chosen ? &white : &brown;
    char text[32];
    const struct pel_text_column name = {
        {&sans_17, text, middle, 198}, 0, 0, PEL_TEXT_CENTER};
    snprintf(text, sizeof text, "%s\n%s", drinks[i].name, drinks[i].price);
    draw_round(screen, &below, 16, &shadow);
    draw_round(screen, &card, 16, i == chosen ? &orange : &white);
    draw_cup(screen, &drinks[i], middle, ink);
    pel_text_column_draw(screen, &name, &ink->paint);
}

/* Bounds that are moved make (0, 0) the corner of our screen. */
static void move(struct pel_rect *r)
{
    const struct pel_rect moved = {r->x0 - left, r->y0 - top, r->x1 - left,
                                   r->y1 - top};
    *r = moved;
}

static void draw(void *context, const struct pel_surface *device)
{
    const struct pel_rect track = {28, 292, 452, 298};
    const struct pel_rect done = {28, 292, 28 + 424 * brewed / 100, 298};
    const char *ask = brewed < 0 ? "What would you like?" : "Thank you!";
    char hint[64];
    const struct pel_text_column text[3] = {
        {{&sans_40, "Good morning", 240, 16}, 0, 0, PEL_TEXT_CENTER},
        {{&sans_24, ask, 240, 64}, 0, 0, PEL_TEXT_CENTER},
        {{&sans_17, hint, 240, 266}, 0, 0, PEL_TEXT_CENTER}};
    struct pel_surface screen = *device;
    (void)context;
    move(&screen.bounds);
    move(&screen.clip);
    snprintf(hint, sizeof hint,
             brewed < 0 ? "%s: tap once more, or press enter"
                        : "Your %s is brewing",
             drinks[chosen].name);
    pel_clear(&screen, PEL_RGB(242, 232, 220));
    for (int i = 0; i < DRINKS; i++) {
        pel_text_column_draw(&screen, &text[i], &brown.paint);
        draw_card(&screen, i);
    }
    draw_round(&screen, &track, 3, &shadow);
    draw_round(&screen, &done, 3, &orange);
}

/* Chooses a card, or brews what is chosen. False: the end. */
static bool react(const struct pel_input *event)
{
    const int32_t x = event->x - left - 28, y = event->y - top;
    int to = DRINKS; /* none */
    if (event->state != PEL_INPUT_DOWN)
        return true;
    if (event->kind == PEL_INPUT_TOUCH && x >= 0 && x % STEP < CARD &&
        y >= 106 && y < 250)
        to = x / STEP;
    if (event->kind == PEL_INPUT_KEY)
        to = event->code == PEL_KEY_ENTER   ? chosen
             : event->code == PEL_KEY_LEFT  ? (chosen + DRINKS - 1) % DRINKS
             : event->code == PEL_KEY_RIGHT ? (chosen + 1) % DRINKS
                                            : DRINKS;
    if (to < DRINKS && brewed < 0) {
        brewed = to == chosen ? 0 : -1;
        chosen = to;
    }
    return event->kind != PEL_INPUT_KEY || event->code != PEL_KEY_ESCAPE;
}

int main(void)
{
    static const struct pel_dirty_work work = {
        {band, NULL}, sizeof band, draw, NULL};
    struct pel_dirty_areas dirty = {.window = 200};
    struct pel_display panel = {.width = WIDTH, .height = HEIGHT};
    struct pel_input event;
    bool goes_on = true;
    enum pel_status status = panel_open(&panel, WIDTH, HEIGHT, &pel_xrgb8888);
    const struct pel_rect all = {0, 0, panel.width, panel.height};
    left = (panel.width - WIDTH) / 2;
    top = (panel.height - HEIGHT) / 2;
    while (goes_on && status == PEL_OK) {
        pel_dirty_areas_add(&dirty, &all);
        status = pel_dirty_areas_show(&dirty, &panel, &work);
        while (goes_on && panel_input(&event))
            goes_on = react(&event);
        if (brewed >= 0 && ++brewed > 100)
            brewed = -1;
    }
    panel_close();
    return status != PEL_OK;
}
