/* Copy me: the first picture on a new board, out of 1 KB, eight lines at a
 * time. The panel is a terminal; on yours, panel_write sends the band over SPI.
 */
#include <stdio.h>

#include <pel/pel.h>

static uint16_t band[64 * 8];

static void panel_write(int lines)
{
    for (int i = 0; i < 64 * lines; i++)
        printf("%c%s", " .:-=+*#%@"[(band[i] >> 5 & 63) * 10 / 64],
               i % 64 == 63 ? "\n" : "");
}

static void draw(const struct pel_surface *screen)
{
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(90, 200, 255, 160));
    static const struct pel_flat sun = PEL_FLAT(PEL_RGB(255, 255, 220));
    static const struct pel_point hill[3] = {PEL_AT(2, 32), PEL_AT(30, 5),
                                             PEL_AT(63, 32)};
    static const pel_color slope[3] = {
        PEL_RGB(20, 40, 20), PEL_RGB(80, 250, 80), PEL_RGB(20, 40, 20)};
    const struct pel_point center = PEL_AT(48, 9), drop = PEL_AT(14, 18);

    pel_clear(screen, PEL_RGB(0, 0, 0));
    pel_circle(screen, center, PEL_PX(7), &sun.paint);
    pel_triangle_gouraud(screen, hill, slope);
    pel_circle(screen, drop, PEL_PX(9), &glass.paint);
}

int main(void)
{
    for (int y = 0; y < 32; y += 8) {
        const struct pel_rect lines = {0, y, 64, y + 8};
        struct pel_surface screen;
        if (pel_surface_init(&screen, &pel_rgb565_le, band, sizeof band,
                             &lines) != PEL_OK)
            return 1;
        draw(&screen);
        panel_write(8);
    }
    return 0;
}
