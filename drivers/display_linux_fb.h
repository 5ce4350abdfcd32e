/* A Linux framebuffer device, /dev/fb0.
 *
 * The layout of a pixel is taken from the offsets and lengths of its channels,
 * lines from line_length, the visible part from xoffset and yoffset. Supported:
 * rgb565_le, bgr565_le, xrgb1555_le, rgb888, bgr888, xrgb8888, xbgr8888,
 * rgbx8888, bgrx8888, rgb332 (as such, or on 8-bit palettes, which get a 3-3-2
 * color map), gray8; 1 bit a pixel, drawn in mono1, and 2 bits, drawn in gray8,
 * whose left pixel is in the low bits, as the kernel draws on little-endian
 * CPUs. Any other layout is refused, its values printed.
 *
 * begin gives a surface in the device's format, and there are three ways:
 *     pages   two pages of device memory; begin gives the hidden one, flip pans
 *             to it. Where yres_virtual is, or can be made, twice the height
 *             and the device is seen to pan
 *     shadow  a frame of ordinary memory; flip copies the area that was
 *             flushed, after the vertical blank where the device reports it.
 *             The only way for pictures that are turned, and for 1 and 2 bits
 *     direct  the visible memory: no copy, but what is drawn is seen at once
 * Only the surfaces of begin can be flushed.
 *
 * Plain devices without panning and without FBIO_WAITFORVSYNC (ENOTTY) tear. */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_FB_H
#define PEL_DRIVERS_DISPLAY_LINUX_FB_H

#include <linux/fb.h>

#include "display.h"
#include "display_linux_turned.h"
#include "linux_message.h"

PEL_BEGIN_DECLS

enum pel_fb_way {
    PEL_FB_ANY,   /* pages, otherwise shadow */
    PEL_FB_STILL, /* pages, otherwise direct: for one picture */
    PEL_FB_PAGES,
    PEL_FB_SHADOW,
    PEL_FB_DIRECT
};

/* The mode of a device, as the kernel reports it. */
struct pel_fb_mode {
    struct fb_fix_screeninfo fixed;
    struct fb_var_screeninfo variable;
};

struct pel_display_fb {
    int fd;
    struct pel_fb_mode mode;
    const struct pel_format *format;
    enum pel_fb_way way;
    uint8_t *map; /* smem_len bytes, begun at a page */
    size_t map_length;
    struct pel_surface page[2]; /* in device memory; direct: one */
    struct pel_turned shadow;
    struct pel_turned_memory memory; /* the device's, for the shadow */
    int32_t back;                    /* the page that begin gives */
    bool no_vsync;                   /* the device has no FBIO_WAITFORVSYNC */
    struct pel_message *message;
};

enum { PEL_FB_COLORS = 256 };

/* The color map that a mode of this format needs: red, green and blue of each
 * value. Palettes get 3 bits of red, 3 of green, 2 of blue, as in the index, or
 * grey; direct color a ramp in each channel. The number of entries; 0: none
 * needed. `format` is what pel_fb_format found for the mode. */
uint32_t pel_fb_color_map(const struct pel_fb_mode *mode,
                          const struct pel_format *format,
                          uint16_t map[3][PEL_FB_COLORS]);

/* 1 or 2, where that many bits are a pixel of grey, or of a palette, which gets
 * greys; else 0. */
uint32_t pel_fb_few_bits(const struct pel_fb_mode *mode);

/* The format that a mode is drawn in, or NULL with the message: the values, and
 * why. */
const struct pel_format *pel_fb_format(const struct pel_fb_mode *mode,
                                       struct pel_message *message);

/* Opens the device and looks at its mode; nothing is changed yet. Errors go to
 * `message`, which must outlive the display. An errno, or 0. */
int pel_display_fb_open(struct pel_display_fb *fb, const char *path,
                        struct pel_message *message);

/* Reads the mode again, which a switch of terminals may have changed since,
 * sets color map and pages, and fills `display`, whose picture is turned so
 * many quarters clockwise, 0..3. An errno, or 0. The caller saved the device's
 * state before (console_linux_state.h) and restores it. */
int pel_display_fb_start(struct pel_display *display, struct pel_display_fb *fb,
                         enum pel_fb_way way, int32_t turns);

/* Sets mode and color map again, after another program had the screen: for
 * struct pel_console_hooks, with a struct pel_display_fb. */
void pel_display_fb_enter(void *display);

/* Releases memory and descriptor; restores nothing. */
void pel_display_fb_close(struct pel_display_fb *fb);
PEL_END_DECLS
#endif
