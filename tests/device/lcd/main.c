/* On a board with a PL11x: shows the picture of device/linux/reference.pel in
 * every format of the controller, and has it dumped. What it writes to its
 * serial line, UART, is what device/linux/vm.c serves. */
#include "drivers/display_pl11x.h"

#include <pel/pel.h>

enum { WIDTH = 640, HEIGHT = 480 };

static uint64_t frame[WIDTH * HEIGHT / 2];

static volatile uint32_t *const uart = (volatile uint32_t *)UART;

static void write(const char *text)
{
    for (; *text; text++) {
        while (uart[6] & 1 << 5) /* its queue is full */
            ;
        uart[0] = (uint32_t)*text;
    }
}

static void wait_for_answer(void)
{
    while (uart[6] & 1 << 4) /* nothing has come */
        ;
    (void)uart[0];
}

static void draw(const struct pel_surface *s)
{
    static const struct {
        struct pel_point v[3];
        pel_color color;
    } triangles[] = {{{PEL_AT(20, 20), PEL_AT(300, 60), PEL_AT(120, 400)},
                      PEL_RGB(0xff, 0x80, 0x40)},
                     {{PEL_AT(300, 60), PEL_AT(120, 400), PEL_AT(500, 460)},
                      PEL_RGB(0x20, 0x40, 0xc0)},
                     {{PEL_AT(300, 60), PEL_AT(500, 460), PEL_AT(630, 10)},
                      PEL_RGB(0x10, 0xa0, 0x60)},
                     {{PEL_AT(-200, 300), PEL_AT(90, 250), PEL_AT(40, 700)},
                      PEL_RGB(0xe0, 0xe0, 0x20)},
                     {{PEL_AT(600, 470), PEL_AT(639, 470), PEL_AT(639, 200)},
                      PEL_RGB(0xff, 0x00, 0xff)},
                     {{PEL_AT(400, 5), PEL_AT(401, 470), PEL_AT(402, 5)},
                      PEL_RGB(0xff, 0xff, 0xff)}};
    const struct pel_flat disc = PEL_FLAT(PEL_RGB(0xc8, 0x1e, 0x3c));
    const struct pel_flat corner = PEL_FLAT(PEL_RGB(0x00, 0xff, 0xff));
    const struct pel_flat bar = PEL_FLAT(PEL_RGB(0x7f, 0x7f, 0x80));
    pel_clear(s, PEL_RGB(0x20, 0x30, 0x40));
    for (unsigned i = 0; i < sizeof triangles / sizeof *triangles; i++) {
        const struct pel_flat flat = PEL_FLAT(triangles[i].color);
        pel_triangle(s, triangles[i].v, &flat.paint);
    }
    pel_circle(s, (struct pel_point)PEL_AT(320, 240), PEL_PX(77), &disc.paint);
    pel_circle(s, (struct pel_point)PEL_AT(0, 0), PEL_PX(40), &corner.paint);
    pel_rectangle(s, (struct pel_point)PEL_AT(200, 330),
                  (struct pel_point)PEL_AT(260, 1000), &bar.paint);
}

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
    draw(&s);
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
    struct pel_display_pl11x lcd;
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
        write(formats[i].name);
        wait_for_answer();
    }
    write(done ? "@done 0\n" : "@done 1\n");
    for (;;)
        ;
}
