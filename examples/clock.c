/* A clock face for a panel of 240 x 240 pixels behind SPI (ST7789, GC9A01): ten
 * lines at a time, in 4,800 bytes. Here the panel is a PPM file. */
#include <stdio.h>

#include <pel/pel.h>

enum { SIDE = 240, LINES = 10 };

static uint16_t band[SIDE * LINES];

/* On a board: send 2 * count bytes, which lie in the order of the panel. */
static void panel_write(const uint16_t *pixels, int count)
{
    const uint8_t *byte = (const uint8_t *)pixels;
    for (int i = 0; i < count; i++, byte += 2) {
        putchar(byte[0] & 0xF8);
        putchar((byte[0] << 5 & 0xE0) | (byte[1] >> 3 & 0x1C));
        putchar(byte[1] << 3 & 0xF8);
    }
}

static const struct pel_point center = PEL_AT(SIDE / 2, SIDE / 2);

/* From the middle to `length` pixels away. */
static void draw_hand(const struct pel_surface *screen, uint16_t turn,
                      int length, int32_t width)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct pel_point way = pel_direction(turn);
    const struct pel_thick_line_shape hand = {
        center,
        {center.x + way.x * length / 128, center.y + way.y * length / 128},
        width};
    pel_thick_line(screen, &hand, &white.paint);
}

static void draw(const struct pel_surface *screen, const struct pel_paint *sky)
{
    static const struct pel_flat frame = PEL_FLAT(PEL_RGB(255, 170, 40));
    static const struct pel_ring_shape ring = {PEL_AT(SIDE / 2, SIDE / 2),
                                               PEL_PX(104), PEL_PX(112)};
    const struct pel_point top = PEL_AT(0, 0), bottom = PEL_AT(SIDE, SIDE);

    pel_rectangle(screen, top, bottom, sky);
    pel_ring(screen, &ring, &frame.paint);
    draw_hand(screen, 39140, 60, PEL_PX(9)); /* ten past ten: turns begin at */
    draw_hand(screen, 60075, 90, PEL_PX(5)); /* three o'clock, 65,536 a round */
    pel_circle(screen, center, PEL_PX(7), &frame.paint);
}

int main(void)
{
    static const pel_color blues[2] = {PEL_RGB(10, 20, 60),
                                       PEL_RGB(40, 120, 190)};
    static const struct pel_ramp ramp = {blues, 2, PEL_PAD};
    const struct pel_point top = PEL_AT(0, 0), bottom = PEL_AT(0, SIDE);
    struct pel_linear sky;
    struct pel_dither soft; /* no steps between the panel's 32 blues */
    if (pel_linear_init(&sky, top, bottom, &ramp) != PEL_OK ||
        pel_dither_init(&soft, &sky.base.paint) != PEL_OK)
        return 1;
    printf("P6 %d %d 255\n", SIDE, SIDE);
    for (int y = 0; y < SIDE; y += LINES) {
        const struct pel_rect lines = {0, y, SIDE, y + LINES};
        struct pel_surface screen;
        if (pel_surface_init(&screen, &pel_rgb565_be, band, sizeof band,
                             &lines) != PEL_OK)
            return 1;
        draw(&screen, &soft.paint);
        panel_write(band, SIDE * LINES);
    }
    return 0;
}
