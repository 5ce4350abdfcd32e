/* On a board with a PL11x: shows the picture of device/linux/reference.pel in
 * every format of the controller, and has it dumped. What it writes to its
 * serial line, UART, is what device/linux/vm.c serves. */
#include "drivers/display_pl11x.h"

#include "guest.h"

enum { WIDTH = 640, HEIGHT = 480 };

static uint64_t frame[WIDTH * HEIGHT / 2];

static enum pel_status start(struct pel_display *display,
                             struct pel_display_pl11x *lcd,
                             const struct pel_format *format,
                             const struct pel_rect *bounds)
{
    lcd->kind = KIND;
    lcd->registers = (volatile uint32_t *)LCD;
    pel_surface_init(&lcd->screen, format, frame, sizeof frame, bounds);
    return pel_display_pl11x_init(display, lcd);
}

/* QEMU takes the right one of two pixels of 16 bits first where bytes are big-
 * endian, other than the manual says (the left one in the high half). */
static void exchange_pixels(void)
{
    uint32_t *word = (uint32_t *)frame;
    for (int i = 0; i < WIDTH * HEIGHT / 2; i++)
        word[i] = word[i] << 16 | word[i] >> 16;
}

static bool show(const struct pel_format *format)
{
    static struct pel_display_pl11x lcd;
    const struct pel_rect all = {0, 0, WIDTH, HEIGHT};
    struct pel_display display;
    struct pel_surface s;
    if (start(&display, &lcd, format, &all) ||
        pel_display_begin(&display, &all, &s))
        return false;
    guest_draw(&s);
    if (format == &pel_rgb565_be)
        exchange_pixels();
    return !pel_display_flush(&display, &s) && !pel_display_flip(&display);
}

static bool refuses(void)
{
    static const struct {
        const struct pel_format *format;
        struct pel_rect bounds;
        enum pel_status expected;
    } cases[] = {
        {&pel_rgb888, {0, 0, 320, 240}, PEL_ERROR_FORMAT},
        {&pel_xrgb8888, {0, 0, 328, 240}, PEL_ERROR_SIZE},
        {&pel_rgb565_le, {0, 0, 1040, 1}, PEL_ERROR_SIZE},
        {&pel_rgb565_le, {0, 0, 16, 1025}, PEL_ERROR_SIZE},
        {&pel_rgb565_le, {0, 8, 320, 240}, PEL_ERROR_SIZE},
        {&pel_xrgb8888, {0, 0, 1024, 1024}, PEL_ERROR_NULL}, /* no memory */
    };
    struct pel_display_pl11x lcd = {0};
    struct pel_display display;
    bool all = true;
    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++)
        all = start(&display, &lcd, cases[i].format, &cases[i].bounds) ==
                  cases[i].expected &&
              all;
    start(&display, &lcd, &pel_rgb565_le, &(struct pel_rect){0, 0, 64, 64});
    lcd.screen.stride += 2;
    all = pel_display_pl11x_init(&display, &lcd) == PEL_ERROR_STRIDE && all;
    lcd.screen.stride -= 2;
    lcd.screen.pixels = (uint8_t *)frame + 4;
    all = pel_display_pl11x_init(&display, &lcd) == PEL_ERROR_ALIGNMENT && all;
    return all && pel_display_pl11x_init(NULL, &lcd) == PEL_ERROR_NULL;
}

int main(void)
{
    static const struct {
        const char *name;
        const struct pel_format *format;
    } formats[] = {
#define FORMAT(name) {"@dump " #name "\n", &pel_##name}
        FORMAT(rgb565_le), FORMAT(rgb565_be), FORMAT(bgr565_le),
        FORMAT(xrgb8888),  FORMAT(xbgr8888),  FORMAT(rgbx8888),
        FORMAT(bgrx8888)};
    bool done = refuses();
    for (unsigned i = 0; i < sizeof formats / sizeof *formats; i++) {
        done = show(formats[i].format) && done;
        guest_ask(formats[i].name);
    }
    guest_done(done);
}
