/* glass FOLDER : what the panels of the Pico show after each frame, by the
 * bytes of their buses (lcd.log, oled.log: 16 bits each, as in a bus_log, and
 * FRAME between two frames), is what the host draws of the scene (frames.txt).
 */
#include "tests/support/check.h"
#include "tests/support/panel_glass.h"
#include "scene.h"

#include <inttypes.h>
#include <stdio.h>

enum { FRAME = 0x400, MOST = 1000 };

static struct bus_log bus;

struct side {
    const char *name;
    FILE *log;
    struct panel_glass glass;
    bool inverted; /* as the usual module wants it */
    const struct pel_format *format;
    int width, height;
    void (*draw)(void *context, const struct pel_surface *screen);
};

static struct side lcd = {
    .name = "lcd.log",
    .glass = {.family = PANEL_DCS, .columns = 240, .rows = 320},
    .inverted = true,
    .format = &pel_rgb565_be,
    .width = LCD_SIDE,
    .height = LCD_SIDE,
    .draw = scene_draw_lcd};
static struct side oled = {.name = "oled.log",
                           .glass = {.family = PANEL_PAGES,
                                     .columns = 128,
                                     .rows = 64,
                                     .columns_backward = true,
                                     .rows_backward = true},
                           .format = &pel_mono1_pages,
                           .width = OLED_WIDTH,
                           .height = OLED_HEIGHT,
                           .draw = scene_draw_oled};

/* Bytes up to the end of the frame, or -1 where the log has ended before. */
static int take_frame(struct side *side)
{
    unsigned char two[2];
    bus.count = 0;
    while (fread(two, 2, 1, side->log) == 1 && bus.count < BUS_LOG_SIZE) {
        const uint16_t entry = (uint16_t)(two[0] | two[1] << 8);
        if (entry == FRAME) {
            panel_glass_take(&side->glass, &bus, 0);
            return bus.count;
        }
        bus.log[bus.count++] = entry;
    }
    return -1;
}

static bool shows(struct side *side, struct scene *scene, int frame, int bytes)
{
    static uint16_t pixels[LCD_SIDE * LCD_SIDE];
    const struct pel_rect all = {0, 0, side->width, side->height};
    struct pel_surface screen;
    int at[2];
    if (bytes < 0 || !side->glass.on || !side->glass.awake ||
        side->glass.inverted != side->inverted ||
        pel_surface_init(&screen, side->format, pixels, sizeof pixels, &all)) {
        printf("%s: frame %d is not there\n", side->name, frame);
        return false;
    }
    side->draw(scene, &screen);
    if (panel_glass_shows(&side->glass, &screen, 0, at))
        return true;
    printf("%s: frame %d differs at %d %d\n", side->name, frame, at[0], at[1]);
    return false;
}

struct frame {
    struct scene scene;
    int32_t status, us[2];
    int bytes[2];
};

/* The frames of the list. */
static int read_frames(const char *folder, struct frame *frames)
{
    char name[4096];
    int n = 0;
    snprintf(name, sizeof name, "%s/frames.txt", folder);
    FILE *list = fopen(name, "r");
    for (struct frame *f = frames; list && n < MOST; n++, f++)
        if (fscanf(list,
                   "%" SCNd32 "%" SCNd32 "%" SCNd32 "%" SCNd32 "%" SCNd32
                   "%" SCNd32 "%" SCNd32 "%" SCNd32,
                   &f->scene.degrees, &f->scene.presses, &f->scene.held,
                   &f->scene.x, &f->scene.y, &f->status, &f->us[0],
                   &f->us[1]) != 8)
            break;
    return n;
}

/* How many glasses are other than the host's. */
static int check_side(struct side *side, const char *folder,
                      struct frame *frames, int n)
{
    char name[4096];
    int bad = 0;
    snprintf(name, sizeof name, "%s/%s", folder, side->name);
    side->log = fopen(name, "rb");
    panel_glass_reset(&side->glass);
    for (int i = 0; i < n; i++) {
        const int bytes = side->log ? take_frame(side) : -1;
        frames[i].bytes[side == &oled] = bytes;
        bad += !shows(side, &frames[i].scene, i, bytes);
    }
    return bad;
}

int main(int argc, char **argv)
{
    static struct frame frames[MOST];
    if (argc != 2)
        return 2;
    const int n = read_frames(argv[1], frames);
    const int bad = check_side(&lcd, argv[1], frames, n) +
                    check_side(&oled, argv[1], frames, n);
    printf(
        "frame  st7789: bytes  on the wire      us  ssd1306: bytes      us\n");
    for (int i = 0; i < n; i++) {
        const struct frame *f = &frames[i];
        printf("%5d %14d %12d %7" PRId32 " %15d %7" PRId32 "\n", i, f->bytes[0],
               f->bytes[0] * 16 / 125, f->us[0], f->bytes[1], f->us[1]);
    }
    printf("%d frames, %d glasses other than the host's\n", n, bad);
    return n == 0 || bad != 0;
}
