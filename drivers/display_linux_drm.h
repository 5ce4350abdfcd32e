/* A DRM device, /dev/dri/card0: two dumb buffers and page flips, through
 * libdrm. The first connected output, in its preferred mode; xrgb8888, or
 * rgb565_le where the device prefers 16 bits or has no other. Without
 * page flips the buffer is set and announced as dirty instead. The output's
 * former picture comes back on close; after SIGKILL the kernel brings back its
 * console.
 *
 * What was flushed for this flip and for the one before is told to devices
 * that take it, as the part of the screen that is another one.
 *
 * begin gives the hidden buffer, so all of its surfaces are two flips old.
 * Where the picture is turned it gives the one frame that is drawn upright, of
 * which flip copies that part. */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_DRM_H
#define PEL_DRIVERS_DISPLAY_LINUX_DRM_H

#include <stdbool.h>
#include <xf86drmMode.h>

#include "display.h"
#include "display_linux_drm_damage.h"
#include "display_linux_turned.h"
#include "linux_message.h"

PEL_BEGIN_DECLS

struct pel_drm_buffer {
    uint32_t handle, id; /* 0: none */
    void *map;
    size_t length;
    struct pel_surface surface;
};

struct pel_display_drm {
    int fd;
    uint32_t connector, crtc;
    drmModeModeInfo mode;
    drmModeCrtc *before; /* what the output showed */
    const struct pel_format *format;
    struct pel_drm_buffer buffer[2];
    int32_t back;
    struct pel_turned frame;     /* upright; pixels only where it is turned */
    struct pel_rect last_change; /* of it, for the flip before */
    struct pel_rect area;        /* of the screen: what the flip changes */
    struct pel_drm_damage damage;
    bool shown;    /* the output shows a buffer of ours */
    bool no_flips; /* the device has no page flips */
    bool flipping; /* a flip was requested and has not happened */
    struct pel_message *message;
};

/* Opens the device and finds an output. Errors go to `message`, which must
 * outlive the display. An errno, or 0. */
int pel_display_drm_open(struct pel_display_drm *drm, const char *path,
                         struct pel_message *message);

/* Makes the buffers and fills `display`, whose picture is turned so many
 * quarters clockwise, 0..3. An errno, or 0. */
int pel_display_drm_start(struct pel_display *display,
                          struct pel_display_drm *drm, int32_t turns);

/* Another terminal is shown: others may set modes. And back again. For struct
 * pel_console_hooks, with a struct pel_display_drm. */
void pel_display_drm_leave(void *display);
void pel_display_drm_enter(void *display);

void pel_display_drm_close(struct pel_display_drm *drm);
PEL_END_DECLS
#endif
