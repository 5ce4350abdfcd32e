/* A thermometer on an OLED of 128 x 64 pixels (SSD1306, SH1106), all in the 1
 * KB that the display itself takes: eight pages of 128 columns. */
#include "fixed_6x13.h"
#include "ppm.h"

enum { WIDTH = 128, HEIGHT = 64 };

static uint8_t pages[WIDTH * HEIGHT / 8];

static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
static const struct pel_flat black = PEL_FLAT(PEL_RGB(0, 0, 0));

/* The last 24 hours, tenths of a degree. */
static void draw_chart(const struct pel_surface *screen)
{
    static const int16_t tenths[24] = {142, 138, 133, 129, 126, 125, 131, 142,
                                       156, 171, 186, 199, 209, 216, 221, 223,
                                       220, 213, 204, 195, 187, 179, 170, 161};
    for (int32_t i = 0; i < 24; i++) {
        const struct pel_rect bar = {4 + 5 * i, 62 - (tenths[i] - 100) / 4,
                                     8 + 5 * i, 62};
        pel_box(screen, &bar, &white.paint);
    }
}

/* White to black, of dots. */
static enum pel_status draw_title(const struct pel_surface *screen)
{
    static const pel_color ends[2] = {PEL_RGB(255, 255, 255), PEL_RGB(0, 0, 0)};
    static const struct pel_ramp ramp = {ends, 2, PEL_PAD};
    static const struct pel_rect bar = {0, 0, WIDTH, 15};
    static const struct pel_text_block text = {&fixed_6x13,
                                               "Gew\xC3\xA4"
                                               "chshaus",
                                               3, 1};
    const struct pel_point left = PEL_AT(76, 0), right = PEL_AT(WIDTH, 0);
    struct pel_linear linear;
    struct pel_dither dots;
    enum pel_status status = pel_linear_init(&linear, left, right, &ramp);
    if (status == PEL_OK)
        status = pel_dither_init(&dots, &linear.base.paint);
    if (status == PEL_OK)
        pel_box(screen, &bar, &dots.paint);
    pel_text(screen, &text, &black.paint);
    return status;
}

int main(void)
{
    static const struct pel_text_block degrees = {&fixed_6x13,
                                                  "16.1 \xC2\xB0"
                                                  "C",
                                                  4, 18};
    static const struct pel_rect all = {0, 0, WIDTH, HEIGHT};
    struct pel_surface screen;
    if (pel_surface_init(&screen, &pel_mono1_pages, pages, sizeof pages,
                         &all) != PEL_OK ||
        draw_title(&screen) != PEL_OK)
        return 1;
    pel_text(&screen, &degrees, &white.paint);
    draw_chart(&screen);
    printf("P6 %d %d 255\n", WIDTH, HEIGHT);
    ppm_write(&screen);
    return 0;
}
