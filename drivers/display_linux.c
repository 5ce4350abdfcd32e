#define _POSIX_C_SOURCE 200809L
#include "display_linux.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <pel/pel.h>

enum { CARDS = 8 }; /* DRM devices that are tried */

/* The device to open: the parts of its name. */
struct choice {
    enum pel_linux_kind kind;
    char path[200];
    const char *panel; /* what comes behind panel: */
    enum pel_fb_way way;
    int32_t turns;
    const char *why;
};

static int refuse(struct pel_display_linux *screen, const char *name,
                  const struct choice *choice)
{
    return pel_message_set(&screen->message, EINVAL,
                           "unknown device '%.200s', %s; use fb:/dev/fb0, "
                           "fb:/dev/fb0,direct (or shadow, pages), "
                           "drm:/dev/dri/card0, either with ,rotate=90 (or "
                           "180, 270), or panel:st7789,...",
                           name, choice->why);
}

/* How frames reach the screen; what the note says of it. */
static const struct {
    const char *name, *note;
} ways[] = {[PEL_FB_PAGES] = {"pages", "two pages, panned"},
            [PEL_FB_SHADOW] = {"shadow", "a shadow, copied"},
            [PEL_FB_DIRECT] = {"direct", "drawn directly"}};

static bool parse_way(const char *text, enum pel_fb_way *way)
{
    for (int i = PEL_FB_PAGES; i <= PEL_FB_DIRECT; i++)
        if (strcmp(text, ways[i].name) == 0) {
            *way = (enum pel_fb_way)i;
            return true;
        }
    return false;
}

/* WAY or rotate=ANGLE behind commas. */
static bool parse_options(const char *text, struct choice *choice)
{
    char word[16];
    for (size_t n; *text == ','; text += n) {
        n = strcspn(++text, ",");
        if (n >= sizeof(word))
            return false;
        memcpy(word, text, n);
        word[n] = 0;
        if (strncmp(word, "rotate=", 7) == 0
                ? !pel_turned_parse(word + 7, &choice->turns)
                : choice->kind != PEL_LINUX_FB ||
                      !parse_way(word, &choice->way))
            return false;
    }
    return true;
}

static int parse(struct pel_display_linux *screen, const char *name,
                 struct choice *choice)
{
    const char *path = name;
    if (strncmp(name, "panel:", 6) == 0) {
        choice->kind = PEL_LINUX_PANEL;
        choice->panel = name + 6;
        return 0;
    }
    choice->kind = strstr(name, "/dri/") ? PEL_LINUX_DRM : PEL_LINUX_FB;
    if (strncmp(name, "fb:", 3) == 0 || strncmp(name, "drm:", 4) == 0) {
        choice->kind = name[0] == 'd' ? PEL_LINUX_DRM : PEL_LINUX_FB;
        path = strchr(name, ':') + 1;
    }
    size_t length = strcspn(path, ",");
    if (path[0] != '/' || length >= sizeof(choice->path))
        return refuse(screen, name, choice);
    if (!parse_options(path + length, choice))
        return refuse(screen, name, choice);
    memcpy(choice->path, path, length);
    choice->path[length] = 0;
    return 0;
}

/* An empty path stands for the first DRM device with an output. */
static int choose(struct pel_display_linux *screen, const char *name,
                  struct choice *choice)
{
    const char *environment = getenv("FRAMEBUFFER");
    choice->why = "asked for";
    if (!name && environment && environment[0]) {
        name = environment;
        choice->why = "named by FRAMEBUFFER";
    } else if (!name && access("/dev/fb0", F_OK) == 0) {
        name = "/dev/fb0";
        choice->why = "the first framebuffer";
    } else if (!name) {
        choice->kind = PEL_LINUX_DRM;
        choice->why = "there is no /dev/fb0";
        return 0;
    }
    return parse(screen, name, choice);
}

static const char *format_name(const struct pel_format *format)
{
    static const char *const names[] = {
        [PEL_FORMAT_RGB565_LE] = "rgb565_le",
        [PEL_FORMAT_RGB565_BE] = "rgb565_be",
        [PEL_FORMAT_BGR565_LE] = "bgr565_le",
        [PEL_FORMAT_XRGB1555_LE] = "xrgb1555_le",
        [PEL_FORMAT_RGB888] = "rgb888",
        [PEL_FORMAT_BGR888] = "bgr888",
        [PEL_FORMAT_XRGB8888] = "xrgb8888",
        [PEL_FORMAT_XBGR8888] = "xbgr8888",
        [PEL_FORMAT_RGBX8888] = "rgbx8888",
        [PEL_FORMAT_BGRX8888] = "bgrx8888",
        [PEL_FORMAT_RGB332] = "rgb332",
        [PEL_FORMAT_GRAY8] = "gray8",
        [PEL_FORMAT_GRAY4] = "gray4",
        [PEL_FORMAT_INKS2] = "inks2",
        [PEL_FORMAT_GRAY2] = "gray2",
        [PEL_FORMAT_MONO1] = "mono1",
        [PEL_FORMAT_MONO1_PAGES] = "mono1_pages"};
    return names[format->id];
}

static void set_note(struct pel_display_linux *screen,
                     const struct choice *choice, const char *id,
                     const char *how)
{
    pel_message_set(&screen->note, 0, "%s (%.16s, %dx%d, %s, %s%s): %s",
                    choice->path, id, (int)screen->display.width,
                    (int)screen->display.height,
                    format_name(screen->display.format), how,
                    choice->turns ? ", turned" : "", choice->why);
}

static void fb_leave(void *context)
{
    (void)context;
    pel_console_restore_framebuffer();
}

static int take_console(struct pel_display_linux *screen, int framebuffer,
                        const struct pel_console_hooks *hooks)
{
    int error = pel_console_take(framebuffer, hooks, &screen->console);
    screen->has_console = !error;
    if (error)
        screen->message = screen->console;
    return error;
}

static int open_fb(struct pel_display_linux *screen,
                   const struct choice *choice)
{
    struct pel_display_fb *fb = &screen->device.fb;
    const struct pel_console_hooks hooks = {fb, fb_leave, pel_display_fb_enter};
    int error = pel_display_fb_open(fb, choice->path, &screen->message);
    if (error)
        return error;
    error = take_console(screen, fb->fd, &hooks);
    if (!error)
        error = pel_display_fb_start(&screen->display, fb, choice->way,
                                     choice->turns);
    if (!error)
        set_note(screen, choice, fb->mode.fixed.id, ways[fb->way].note);
    return error;
}

/* Its console is that of the keyboard: what is typed is not shown there. */
static int open_panel(struct pel_display_linux *screen, struct choice *choice)
{
    static const struct pel_console_hooks none;
    struct pel_display_panel *panel = &screen->device.panel;
    struct pel_panel_request request;
    int error = pel_panel_parse(&request, choice->panel, &screen->message);
    if (!error)
        error = pel_display_panel_open(panel, &request, &screen->message);
    if (!error)
        error = take_console(screen, -1, &none);
    if (!error)
        error = pel_display_panel_start(&screen->display, panel, &request);
    snprintf(choice->path, sizeof(choice->path), "%s", panel->bus.path);
    if (!error)
        set_note(screen, choice, request.chip, "sent");
    return error;
}

#if PEL_WITH_DRM

/* Of several devices, some only compute: a Raspberry Pi has one of each. Who
 * may not open one is told so, and not what the others lack. */
static int find_drm(struct pel_display_linux *screen, struct choice *choice)
{
    struct pel_display_drm *drm = &screen->device.drm;
    int error = ENODEV;
    if (choice->path[0])
        return pel_display_drm_open(drm, choice->path, &screen->message);
    drm->fd = -1;
    pel_message_set(&screen->message, error,
                    "no display: there is neither /dev/fb0 nor /dev/dri/card0; "
                    "is the driver loaded?");
    for (int i = 0; error && error != EACCES && i < CARDS; i++) {
        snprintf(choice->path, sizeof(choice->path), "/dev/dri/card%d", i);
        if (access(choice->path, F_OK) == 0)
            error = pel_display_drm_open(drm, choice->path, &screen->message);
    }
    return error;
}

static int open_drm(struct pel_display_linux *screen, struct choice *choice)
{
    struct pel_display_drm *drm = &screen->device.drm;
    const struct pel_console_hooks hooks = {drm, pel_display_drm_leave,
                                            pel_display_drm_enter};
    int error = find_drm(screen, choice);
    if (error)
        return error;
    error = take_console(screen, -1, &hooks);
    if (!error)
        error = pel_display_drm_start(&screen->display, drm, choice->turns);
    if (!error)
        set_note(screen, choice, "DRM", "two buffers, flipped");
    return error;
}

static void close_drm(struct pel_display_linux *screen)
{
    pel_display_drm_close(&screen->device.drm);
}

#else

static int open_drm(struct pel_display_linux *screen, struct choice *choice)
{
    return pel_message_set(&screen->message, ENOSYS,
                           "%s: this program was built without DRM; install "
                           "libdrm-dev and build again",
                           choice->path[0] ? choice->path : "no /dev/fb0");
}

static void close_drm(struct pel_display_linux *screen)
{
    (void)screen;
}

#endif

enum pel_status pel_display_linux_open(struct pel_display_linux *screen,
                                       const char *name, enum pel_fb_way way)
{
    struct choice choice = {.way = way};
    memset(screen, 0, sizeof(*screen));
    if (choose(screen, name, &choice))
        return PEL_ERROR_DEVICE;
    screen->kind = choice.kind;
    if (choice.kind == PEL_LINUX_FB)
        screen->device.fb.fd = -1;
    int error = choice.kind == PEL_LINUX_DRM     ? open_drm(screen, &choice)
                : choice.kind == PEL_LINUX_PANEL ? open_panel(screen, &choice)
                                                 : open_fb(screen, &choice);
    if (error) {
        pel_display_linux_close(screen);
        return PEL_ERROR_DEVICE;
    }
    screen->area =
        (struct pel_rect){0, 0, screen->display.width, screen->display.height};
    return PEL_OK;
}

enum pel_console_event pel_display_linux_wait(struct pel_display_linux *screen,
                                              int milliseconds)
{
    (void)screen;
    return milliseconds == 0 ? pel_console_check()
                             : pel_console_wait(milliseconds);
}

/* The output's picture comes back before the console's text, which is drawn
 * onto it; a framebuffer's mode comes back with the console, through its
 * descriptor. */
void pel_display_linux_close(struct pel_display_linux *screen)
{
    if (screen->kind == PEL_LINUX_DRM)
        close_drm(screen);
    if (screen->kind == PEL_LINUX_PANEL)
        pel_display_panel_close(&screen->device.panel);
    if (screen->has_console)
        pel_console_give_back();
    screen->has_console = false;
    if (screen->kind == PEL_LINUX_FB)
        pel_display_fb_close(&screen->device.fb);
}
