#include "guest.h"

static volatile uint32_t *const uart = (volatile uint32_t *)UART;

static void write(const char *text)
{
    for (; *text; text++) {
        while (uart[6] & 1 << 5) /* its queue is full */
            ;
        uart[0] = (uint32_t)*text;
    }
}

void guest_ask(const char *line)
{
    write(line);
    while (uart[6] & 1 << 4) /* nothing has come */
        ;
    (void)uart[0];
}

void guest_done(bool good)
{
    write(good ? "@done 0\n" : "@done 1\n");
    for (;;)
        ;
}

void guest_draw(const struct pel_surface *s)
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
