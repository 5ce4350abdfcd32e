/* Page flips that tell a DRM device which part of the picture is another one,
 * by an atomic commit with the property FB_DAMAGE_CLIPS: a device that copies
 * pixels, to a virtual machine's host, over USB or SPI, copies these alone. */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_DRM_DAMAGE_H
#define PEL_DRIVERS_DISPLAY_LINUX_DRM_DAMAGE_H

#include <pel/pel.h>

PEL_BEGIN_DECLS

struct pel_drm_damage {
    uint32_t plane;         /* 0: none, or one that is not told */
    uint32_t buffer, clips; /* its properties */
};

/* Finds the plane that shows this buffer, and its properties. */
void pel_drm_damage_find(struct pel_drm_damage *damage, int fd,
                         uint32_t buffer);

/* Asks for a page flip, whose event has this context. Outside of `area`, px of
 * the device, the buffer is like the one that is shown; an empty one stands for
 * all. 0, or the plane is not told of it. */
int pel_drm_damage_flip(const struct pel_drm_damage *damage, int fd,
                        uint32_t buffer, const struct pel_rect *area,
                        void *context);
PEL_END_DECLS
#endif
