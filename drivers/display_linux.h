/* A display of a Linux device, found, opened and given back with its console.
 * PEL_WITH_DRM (0 or 1) is the same in all files of a program.
 *
 *     struct pel_display_linux screen;
 *     if (pel_display_linux_open(&screen, NULL, PEL_FB_ANY) != PEL_OK)
 *         puts(screen.message.text), exit(2);
 *     puts(screen.note.text);
 *     do {
 *         pel_display_begin(&screen.display, &screen.area, &surface);
 *         ...draw...
 *         pel_display_flush(&screen.display, &surface);
 *     } while (pel_display_flip(&screen.display) == PEL_OK &&
 *              pel_display_linux_wait(&screen, -1) != PEL_CONSOLE_KEY);
 *     pel_display_linux_close(&screen);
 *
 * One per process, because of the console; console_linux.h tells what happens
 * to it. */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_H
#define PEL_DRIVERS_DISPLAY_LINUX_H

#include "console_linux.h"
#include "display_linux_fb.h"
#include "display_linux_panel.h"
#ifndef PEL_WITH_DRM
#define PEL_WITH_DRM 0
#endif
#if PEL_WITH_DRM
#include "display_linux_drm.h"
#endif

PEL_BEGIN_DECLS

enum pel_linux_kind { PEL_LINUX_FB, PEL_LINUX_DRM, PEL_LINUX_PANEL };

struct pel_display_linux {
    struct pel_display display;
    struct pel_rect area; /* the whole screen */
    enum pel_linux_kind kind;
    bool has_console;
    union {
        struct pel_display_fb fb;
        struct pel_display_panel panel;
#if PEL_WITH_DRM
        struct pel_display_drm drm;
#endif
    } device;
    struct pel_message message; /* the last error */
    struct pel_message note;    /* what was taken, and why */
    struct pel_message console; /* what the console lacks, or "" */
};

/* Opens `name`:
 *     fb:PATH[,direct|shadow|pages]    a framebuffer device
 *     drm:PATH                         a DRM device (built with PEL_WITH_DRM)
 *     either with ,rotate=90|180|270   the picture, clockwise
 *     panel:CHIP,OPTION=VALUE,...      a panel at SPI or I2C pins
 *     PATH                             what of these the name tells
 *
 * docs/linux.md has the options of panels. NULL is what FRAMEBUFFER in the
 * environment names; then /dev/fb0; then, when there is none, the first of
 * /dev/dri/card0 to card7 that has a screen. `way` is for framebuffers for
 * which `name` gives none. The struct is not moved while open.
 * PEL_ERROR_DEVICE, with the message, and everything as before: so too when
 * this process has a display open already. */
enum pel_status pel_display_linux_open(struct pel_display_linux *screen,
                                       const char *name, enum pel_fb_way way);

/* Waits for a key or until all has to be drawn again (pel_console_wait); 0
 * milliseconds: only lets terminals switch. */
enum pel_console_event pel_display_linux_wait(struct pel_display_linux *screen,
                                              int milliseconds);

/* Gives all back. Nothing when it is not open. */
void pel_display_linux_close(struct pel_display_linux *screen);
PEL_END_DECLS
#endif
