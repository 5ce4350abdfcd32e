/* Which format is a framebuffer's mode? A table of modes, those of real devices
 * that drivers got wrong among them. */
#include <stdio.h>
#include <string.h>

#include "core/format/formats.h"
#include "drivers/display_linux_fb.h"

#define TRUE_COLOR FB_VISUAL_TRUECOLOR
#define DIRECT_COLOR FB_VISUAL_DIRECTCOLOR
#define PALETTE FB_VISUAL_PSEUDOCOLOR
#define STATIC_PALETTE FB_VISUAL_STATIC_PSEUDOCOLOR
#define MONO FB_VISUAL_MONO10

/* Offset and length of red, green and blue. */
enum channels {
    RGB565,
    BGR565,
    RGB555,
    BGR555,
    RGB444,
    RGB888,
    BGR888,
    RGBX8888,
    BGRX8888,
    RGB101010,
    RGB332,
    INDEX8,
    INDEX4,
    INDEX2,
    INDEX1
};

static const unsigned channels[][6] = {
    [RGB565] = {11, 5, 5, 6, 0, 5},    [BGR565] = {0, 5, 5, 6, 11, 5},
    [RGB555] = {10, 5, 5, 5, 0, 5},    [BGR555] = {0, 5, 5, 5, 10, 5},
    [RGB444] = {8, 4, 4, 4, 0, 4},     [RGB888] = {16, 8, 8, 8, 0, 8},
    [BGR888] = {0, 8, 8, 8, 16, 8},    [RGBX8888] = {24, 8, 16, 8, 8, 8},
    [BGRX8888] = {8, 8, 16, 8, 24, 8}, [RGB101010] = {20, 10, 10, 10, 0, 10},
    [RGB332] = {5, 3, 2, 3, 0, 2},     [INDEX8] = {0, 8, 0, 8, 0, 8},
    [INDEX4] = {0, 4, 0, 4, 0, 4},     [INDEX2] = {0, 2, 0, 2, 0, 2},
    [INDEX1] = {0, 1, 0, 1, 0, 1},
};

struct row {
    const char *name;
    const struct pel_format *expected; /* NULL: refused */
    unsigned bits, line, width, virtual_width;
    enum channels channels;
    unsigned visual, gray;
};

static const struct row rows[] = {
    {"565", &pel_rgb565_le, 16, 1280, 640, 640, RGB565, TRUE_COLOR, 0},
    {"565 padded", &pel_rgb565_le, 16, 1600, 640, 640, RGB565, TRUE_COLOR, 0},
    {"565 in 32 bits", NULL, 32, 2560, 640, 640, RGB565, TRUE_COLOR, 0},
    {"565 said to be 32", &pel_rgb565_le, 32, 1280, 640, 640, RGB565,
     TRUE_COLOR, 0},
    {"bgr565", &pel_bgr565_le, 16, 1280, 640, 640, BGR565, TRUE_COLOR, 0},
    {"555", &pel_xrgb1555_le, 16, 1280, 640, 640, RGB555, TRUE_COLOR, 0},
    {"555, 15 bits", &pel_xrgb1555_le, 15, 1280, 640, 640, RGB555, TRUE_COLOR,
     0},
    {"bgr555", NULL, 16, 1280, 640, 640, BGR555, TRUE_COLOR, 0},
    {"444", NULL, 16, 1280, 640, 640, RGB444, TRUE_COLOR, 0},
    {"888", &pel_rgb888, 24, 1920, 640, 640, RGB888, TRUE_COLOR, 0},
    {"888 padded", &pel_rgb888, 24, 2112, 640, 704, RGB888, TRUE_COLOR, 0},
    {"888 padded to 4", &pel_rgb888, 24, 2560, 640, 640, RGB888, TRUE_COLOR, 0},
    {"888, 1366 wide", &pel_rgb888, 24, 4128, 1366, 1366, RGB888, TRUE_COLOR,
     0},
    {"bgr888", &pel_bgr888, 24, 1920, 640, 640, BGR888, TRUE_COLOR, 0},
    {"xrgb8888", &pel_xrgb8888, 32, 2560, 640, 640, RGB888, TRUE_COLOR, 0},
    {"xrgb8888 said to be 16", &pel_xrgb8888, 16, 2560, 640, 640, RGB888,
     TRUE_COLOR, 0},
    {"xbgr8888", &pel_xbgr8888, 32, 2560, 640, 640, BGR888, TRUE_COLOR, 0},
    {"rgbx8888", &pel_rgbx8888, 32, 2560, 640, 640, RGBX8888, TRUE_COLOR, 0},
    {"bgrx8888", &pel_bgrx8888, 32, 2560, 640, 640, BGRX8888, TRUE_COLOR, 0},
    {"direct colour", &pel_xrgb8888, 32, 2560, 640, 640, RGB888, DIRECT_COLOR,
     0},
    {"10 bits", NULL, 32, 2560, 640, 640, RGB101010, TRUE_COLOR, 0},
    {"332", &pel_rgb332, 8, 640, 640, 640, RGB332, TRUE_COLOR, 0},
    {"palette", &pel_rgb332, 8, 640, 640, 640, INDEX8, PALETTE, 0},
    {"palette of 16", NULL, 4, 320, 640, 640, INDEX4, PALETTE, 0},
    {"grey", &pel_gray8, 8, 640, 640, 640, INDEX8, STATIC_PALETTE, 1},
    {"mono", &pel_mono1, 1, 80, 640, 640, INDEX1, MONO, 0},
    {"mono, lines too short", NULL, 1, 79, 640, 640, INDEX1, MONO, 0},
    {"palette of 4", &pel_gray8, 2, 160, 640, 640, INDEX2, PALETTE, 0},
    {"565, padded to 4", &pel_rgb565_le, 16, 1284, 641, 641, RGB565, TRUE_COLOR,
     0},
    {"888, padded to 4", &pel_rgb888, 24, 1924, 641, 641, RGB888, TRUE_COLOR,
     0},
    {"a FOURCC format", NULL, 16, 1280, 640, 640, RGB565, TRUE_COLOR,
     0x56595559},
    {"lines too short", NULL, 32, 1900, 640, 640, RGB888, TRUE_COLOR, 0},
    {"no width", NULL, 32, 2560, 0, 0, RGB888, TRUE_COLOR, 0},
};

static struct pel_fb_mode mode_of(const struct row *r)
{
    const unsigned *c = channels[r->channels];
    struct pel_fb_mode mode;
    memset(&mode, 0, sizeof(mode));
    mode.fixed.line_length = r->line;
    mode.fixed.smem_len = r->line * 480;
    mode.fixed.visual = r->visual;
    mode.variable.xres = r->width;
    mode.variable.xres_virtual = r->virtual_width;
    mode.variable.yres = mode.variable.yres_virtual = 480;
    mode.variable.bits_per_pixel = r->bits;
    mode.variable.grayscale = r->gray;
    mode.variable.red.offset = c[0];
    mode.variable.red.length = c[1];
    mode.variable.green.offset = c[2];
    mode.variable.green.length = c[3];
    mode.variable.blue.offset = c[4];
    mode.variable.blue.length = c[5];
    return mode;
}

static int check(const char *name, const struct pel_fb_mode *mode,
                 const struct pel_format *expected)
{
    struct pel_message message = {""};
    const struct pel_format *format = pel_fb_format(mode, &message);
    int right = format == expected && (format || strstr(message.text, "line"));
    if (!right)
        printf("FAIL layout %s: format %d, expected %d; %s\n", name,
               format ? format->id : 0, expected ? expected->id : 0,
               message.text);
    return !right;
}

/* Offsets into the memory, and memory that is too small for them. */
static int check_places(void)
{
    struct pel_fb_mode mode = mode_of(&rows[0]);
    mode.fixed.smem_len = 1280 * 960;
    mode.variable.yres_virtual = 960;
    mode.variable.yoffset = 480;
    int bad = check("second page", &mode, &pel_rgb565_le);
    mode.variable.yoffset = 481;
    bad += check("past the memory", &mode, NULL);
    mode.variable.yoffset = 0;
    mode.variable.xoffset = 1;
    bad += check("past the line", &mode, NULL);
    mode.variable.xoffset = 0;
    mode.variable.red.msb_right = 1;
    bad += check("bits from the right", &mode, NULL);
    mode.variable.red.msb_right = 0;
    mode.fixed.type = FB_TYPE_PLANES;
    bad += check("planes", &mode, NULL);
    return bad;
}

/* Entry i of the map of a mode is this color, of 65535 each. */
static int check_color(const struct pel_fb_mode *mode, unsigned count,
                       unsigned i, const unsigned expected[3])
{
    uint16_t map[3][PEL_FB_COLORS];
    struct pel_message message;
    unsigned n = pel_fb_color_map(mode, pel_fb_format(mode, &message), map);
    int right = n == count && (n == 0 || (map[0][i] == expected[0] &&
                                          map[1][i] == expected[1] &&
                                          map[2][i] == expected[2]));
    if (!right)
        printf("FAIL colour map: %u entries, entry %u wrong\n", n, i);
    return !right;
}

static int check_color_maps(void)
{
    static const unsigned palette[3] = {0xB6B6, 0x4949, 0x5555};
    static const unsigned direct[3] = {65535 * 20 / 31, 65535 * 20 / 63,
                                       65535 * 20 / 31};
    static const unsigned last[3] = {65535, 65535 * 40 / 63, 65535};
    static const unsigned none[3] = {0, 0, 0};
    struct pel_fb_mode mode = mode_of(&rows[0]);
    int bad = check_color(&mode, 0, 0, none);
    mode.fixed.visual = FB_VISUAL_DIRECTCOLOR;
    bad += check_color(&mode, 64, 20, direct);
    bad += check_color(&mode, 64, 40, last);
    mode = mode_of(&rows[0]);
    mode.variable.bits_per_pixel = 8;
    mode.fixed.visual = FB_VISUAL_PSEUDOCOLOR;
    bad += check_color(&mode, 256, 5 << 5 | 2 << 2 | 1, palette);
    /* Grey, from a driver that fills in no channels. */
    mode.fixed.visual = FB_VISUAL_DIRECTCOLOR;
    mode.variable.grayscale = 1;
    mode.variable.red.length = mode.variable.blue.length = 0;
    mode.variable.green.length = 32;
    bad += check_color(&mode, 0, 0, none);
    mode = mode_of(&rows[0]);
    mode.variable.bits_per_pixel = 8;
    mode.fixed.visual = FB_VISUAL_DIRECTCOLOR;
    mode.variable.red.offset = 5;
    mode.variable.red.length = mode.variable.green.length = 3;
    mode.variable.green.offset = 2;
    mode.variable.blue.length = 2;
    static const unsigned few[3] = {65535 * 2 / 7, 65535 * 2 / 7,
                                    65535 * 2 / 3};
    bad += check_color(&mode, 8, 2, few);
    return bad;
}

int main(void)
{
    int bad = check_places() + check_color_maps();
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        struct pel_fb_mode mode = mode_of(&rows[i]);
        bad += check(rows[i].name, &mode, rows[i].expected);
    }
    if (!bad)
        printf("layout: %d layouts right\n",
               (int)(sizeof(rows) / sizeof(rows[0])) + 5);
    return bad != 0;
}
