/* panel_check CHIP ROTATION PICTURE LOG: is PICTURE (PPM) on the glass of a
 * panel, turned by ROTATION degrees, after what panel_mock has noted in LOG? 0:
 * yes. */
#include "tests/support/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/panel_glass.h"

static const struct {
    const char *name;
    int width, height; /* of the glass */
    struct panel_glass glass;
} chips[] = {
    {"st7789", 240, 240, {.family = PANEL_DCS, .columns = 240, .rows = 320}},
    {"st7789-135",
     135,
     240,
     {.family = PANEL_DCS, .columns = 240, .rows = 320, .left = 52, .top = 40}},
    {"ili9341",
     240,
     320,
     {.family = PANEL_DCS,
      .columns = 240,
      .rows = 320,
      .columns_backward = true}},
    {"ssd1306",
     128,
     64,
     {.family = PANEL_PAGES,
      .columns = 128,
      .rows = 64,
      .columns_backward = true,
      .rows_backward = true}},
};
enum { CHIPS = sizeof chips / sizeof *chips };

static struct bus_log wire;
static struct panel_glass glass;
static unsigned char picture[320 * 320 * 3];
static int width, height; /* of the picture */

/* What the picture's pixel is in the chip's memory. */
static int pixel(int x, int y)
{
    const unsigned char *p = picture + (y * width + x) * 3;
    return glass.family == PANEL_PAGES
               ? p[0] >> 7
               : (p[0] >> 3) << 11 | (p[1] >> 2) << 5 | p[2] >> 3;
}

static bool read_files(const char *ppm, const char *log)
{
    FILE *file = fopen(ppm, "rb");
    bool done = file && fscanf(file, "P6 %d %d 255", &width, &height) == 2 &&
                fgetc(file) == '\n' && width <= 320 && height <= 320 &&
                fread(picture, 3, (size_t)(width * height), file) ==
                    (size_t)(width * height);
    if (file)
        fclose(file);
    file = fopen(log, "rb");
    if (file) {
        wire.count = (int)fread(wire.log, 2, BUS_LOG_SIZE, file);
        fclose(file);
    }
    return done && wire.count > 0;
}

/* Pixels of the glass that are not the picture's. */
static int compare(int glass_width, int glass_height, int quarters)
{
    int wrong = 0;
    for (int y = 0; y < glass_height; y++)
        for (int x = 0; x < glass_width; x++) {
            int at[2] = {x, y};
            panel_glass_turn(quarters, glass_width, glass_height, at);
            const int expected = pixel(at[0], at[1]);
            wrong += panel_glass_pixel(&glass, x, y) != expected;
        }
    return wrong;
}

int main(int argc, char **argv)
{
    int i = 0;
    while (argc == 5 && i < CHIPS && strcmp(chips[i].name, argv[1]) != 0)
        i++;
    if (argc != 5 || i == CHIPS || !read_files(argv[3], argv[4])) {
        fprintf(stderr, "panel_check CHIP ROTATION PICTURE LOG\n");
        return 2;
    }
    const int quarters = atoi(argv[2]) / 90;
    glass = chips[i].glass;
    panel_glass_reset(&glass);
    panel_glass_take(&glass, &wire, 0);
    if (width != (quarters & 1 ? chips[i].height : chips[i].width)) {
        printf("the picture is %d wide\n", width);
        return 1;
    }
    const int wrong = compare(chips[i].width, chips[i].height, quarters);
    if (wrong || !glass.on || !glass.awake)
        printf("%d pixels differ, on %d, awake %d\n", wrong, glass.on,
               glass.awake);
    return wrong || !glass.on || !glass.awake;
}
