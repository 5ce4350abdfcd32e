/* On a Pico: two panels, a touch controller, a button, an encoder. What it does
 * it tells to run.mjs, which is the user and the chips beside the processor:
 *
 *     panel STATUS, oled STATUS      as they are set up, the oled until it is 0
 *     cross X Y                      press there
 *     map STATUS
 *     frame DEGREES PRESSES HELD X Y STATUS US US
 *                                    shown on both; time for either panel
 */
#include "port/rp2040/board.h"
#include "drivers/input_button.h"
#include "drivers/input_encoder.h"
#include "drivers/panel.h"
#include "drivers/touch.h"
#include "scene.h"

enum { BAND = LCD_SIDE * 10 * 2, HOLD = 5, STEP = 10, LAST = 270 };

static struct pel_input events[16], touches[8];
static struct pel_input_queue queue = PEL_INPUT_QUEUE(events);
static struct pel_input_queue touch_queue = PEL_INPUT_QUEUE(touches);
static struct pel_touch touch = {.bus = &board_touch,
                                 .read = pel_touch_xpt2046_read};
static struct pel_display lcd, oled;
static struct pel_dirty_areas lcd_dirty = {.window = 200}, oled_dirty;

static void write_line(const char *word, const int32_t *numbers, int n)
{
    board_write(word);
    for (int i = 0; i < n; i++) {
        board_write(" ");
        board_write_number(numbers[i]);
    }
    board_write("\n");
}

void board_millisecond(void)
{
    static struct pel_button enter = {.code = PEL_KEY_ENTER, .hold = HOLD};
    static uint32_t time;
    struct pel_input event;
    if (pel_button_update(&enter, board_closed(BOARD_BUTTON), ++time, &event))
        pel_input_push(&queue, &event);
}

void board_edge(void)
{
    static struct pel_encoder knob = {.states = 4};
    const struct pel_input event = {
        .kind = PEL_INPUT_WHEEL,
        .y = (int16_t)pel_encoder_update(&knob, board_closed(BOARD_A),
                                         board_closed(BOARD_B))};
    if (event.y)
        pel_input_push(&queue, &event);
}

static void start_panels(void)
{
    static struct pel_panel colors = {.chip = &pel_panel_st7789,
                                      .bus = &board_bus,
                                      .format = &pel_rgb565_be,
                                      PEL_PANEL_240X240};
    static struct pel_panel dots = {.chip = &pel_panel_ssd1306,
                                    .bus = &board_i2c,
                                    .format = &pel_mono1_pages};
    int32_t status = pel_panel_init(&lcd, &colors);
    write_line("panel", &status, 1);
    do {
        status = pel_panel_init(&oled, &dots);
        write_line("oled", &status, 1);
        board_sleep(5000);
    } while (status);
}

/* A finger's first place is where it has settled, 30 ms after it came. */
static void read_finger(struct pel_touch_point *read)
{
    struct pel_touch_point points[PEL_TOUCH_FINGERS];
    unsigned down = 0;
    for (int held = 0; held < 3; held = down ? held + 1 : 0) {
        board_sleep(10000);
        pel_touch_xpt2046_read(&board_touch, points, &down);
    }
    *read = points[0];
    while (down) {
        board_sleep(10000);
        pel_touch_xpt2046_read(&board_touch, points, &down);
    }
}

static void calibrate(void)
{
    struct pel_touch_pair pairs[3] = {
        {.shown = {24, 24}}, {.shown = {215, 120}}, {.shown = {120, 215}}};
    for (int i = 0; i < 3; i++) {
        const int32_t at[2] = {pairs[i].shown.x, pairs[i].shown.y};
        write_line("cross", at, 2);
        read_finger(&pairs[i].read);
    }
    const int32_t status =
        pel_touch_calibrate(&touch.map, pairs, LCD_SIDE, LCD_SIDE);
    write_line("map", &status, 1);
}

static void take(struct scene *scene, const struct pel_input *e)
{
    const int32_t turned = scene->degrees + STEP * e->y;
    switch (e->kind) {
    case PEL_INPUT_KEY:
        scene->held = e->state == PEL_INPUT_DOWN;
        scene->presses += scene->held;
        break;
    case PEL_INPUT_WHEEL:
        scene->degrees = turned < 0 ? 0 : turned > LAST ? LAST : turned;
        break;
    case PEL_INPUT_TOUCH:
        scene->x = e->state == PEL_INPUT_UP ? -1 : e->x;
        scene->y = e->state == PEL_INPUT_UP ? -1 : e->y;
        break;
    default:
        board_write("an event was lost\n");
    }
}

static void take_all(struct scene *scene)
{
    static uint32_t polled;
    struct pel_input event;
    if (board_time() - polled > 10000) {
        polled = board_time();
        pel_touch_poll(&touch, polled / 1000, &touch_queue);
    }
    while (pel_input_pop(&queue, &event) || pel_input_pop(&touch_queue, &event))
        take(scene, &event);
}

static uint16_t bands[2][BAND / 2];

/* A frame in halves, whose rows do not follow each other in memory. */
static enum pel_status show_halves(struct scene *scene)
{
    enum pel_status status = PEL_OK;
    for (int32_t y = 0; y < LCD_SIDE && status == PEL_OK; y += 10) {
        const struct pel_rect rows = {0, y, LCD_SIDE, y + 10};
        struct pel_surface s;
        pel_surface_init(&s, lcd.format, bands[y / 10 % 2], BAND, &rows);
        scene_draw_lcd(scene, &s);
        s.clip.x1 = LCD_SIDE / 2;
        status = pel_display_flush(&lcd, &s);
        s.clip = (struct pel_rect){LCD_SIDE / 2, y, LCD_SIDE, y + 10};
        if (status == PEL_OK)
            status = pel_display_flush(&lcd, &s);
    }
    return status == PEL_OK ? pel_display_wait(&lcd) : status;
}

static void show(struct scene *scene)
{
    static int frame;
    static uint8_t pages[OLED_WIDTH * OLED_HEIGHT / 8];
    const struct pel_dirty_work lcd_work = {
        {bands[0], bands[1]}, BAND, scene_draw_lcd, scene};
    const struct pel_dirty_work oled_work = {
        {pages, NULL}, sizeof pages, scene_draw_oled, scene};
    const uint32_t begun = board_time();
    int32_t status = frame++ == 1
                         ? show_halves(scene)
                         : pel_dirty_areas_show(&lcd_dirty, &lcd, &lcd_work);
    const uint32_t between = board_time();
    if (!status)
        status = pel_dirty_areas_show(&oled_dirty, &oled, &oled_work);
    const int32_t told[] = {scene->degrees,
                            scene->presses,
                            scene->held,
                            scene->x,
                            scene->y,
                            status,
                            (int32_t)(between - begun),
                            (int32_t)(board_time() - between)};
    write_line("frame", told, 8);
}

static bool same(const struct scene *a, const struct scene *b)
{
    return a->degrees == b->degrees && a->presses == b->presses &&
           a->held == b->held && a->x == b->x && a->y == b->y;
}

int main(void)
{
    static const struct pel_rect all = {0, 0, LCD_SIDE, LCD_SIDE};
    struct scene now = {.x = -1, .y = -1}, shown;
    board_start();
    board_i2c_start();
    board_touch_start();
    start_panels();
    calibrate();
    board_inputs_start();
    pel_dirty_areas_add(&lcd_dirty, &all);
    pel_dirty_areas_add(&oled_dirty,
                        &(struct pel_rect){0, 0, OLED_WIDTH, OLED_HEIGHT});
    show(&now);
    for (;;) {
        shown = now;
        show(&now);
        while (same(&now, &shown))
            take_all(&now);
        scene_changes(&shown, &now, &lcd_dirty, &oled_dirty);
    }
}
