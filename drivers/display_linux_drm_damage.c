#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "display_linux_drm_damage.h"

#include <string.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

/* 0: the object has none of this name. */
static uint32_t property_of(int fd, const drmModeObjectProperties *all,
                            const char *name)
{
    uint32_t id = 0;
    for (uint32_t i = 0; i < all->count_props && !id; i++) {
        drmModePropertyRes *p = drmModeGetProperty(fd, all->props[i]);
        if (p && strcmp(p->name, name) == 0)
            id = p->prop_id;
        drmModeFreeProperty(p);
    }
    return id;
}

static bool shows(int fd, uint32_t plane, uint32_t buffer)
{
    drmModePlane *p = drmModeGetPlane(fd, plane);
    const bool is = p && p->fb_id == buffer;
    drmModeFreePlane(p);
    return is;
}

void pel_drm_damage_find(struct pel_drm_damage *damage, int fd, uint32_t buffer)
{
    memset(damage, 0, sizeof *damage);
    if (drmSetClientCap(fd, DRM_CLIENT_CAP_ATOMIC, 1))
        return;
    drmModePlaneRes *planes = drmModeGetPlaneResources(fd);
    for (uint32_t i = 0; planes && i < planes->count_planes; i++) {
        const uint32_t plane = planes->planes[i];
        drmModeObjectProperties *all =
            shows(fd, plane, buffer)
                ? drmModeObjectGetProperties(fd, plane, DRM_MODE_OBJECT_PLANE)
                : NULL;
        if (!all)
            continue;
        damage->buffer = property_of(fd, all, "FB_ID");
        damage->clips = property_of(fd, all, "FB_DAMAGE_CLIPS");
        damage->plane = damage->buffer && damage->clips ? plane : 0;
        drmModeFreeObjectProperties(all);
    }
    drmModeFreePlaneResources(planes);
}

static int commit(const struct pel_drm_damage *damage, int fd, uint32_t buffer,
                  uint32_t clips, void *context)
{
    const uint32_t flags = DRM_MODE_PAGE_FLIP_EVENT | DRM_MODE_ATOMIC_NONBLOCK;
    drmModeAtomicReq *request = drmModeAtomicAlloc();
    int error = -1;
    if (request &&
        drmModeAtomicAddProperty(request, damage->plane, damage->buffer,
                                 buffer) >= 0 &&
        drmModeAtomicAddProperty(request, damage->plane, damage->clips,
                                 clips) >= 0)
        error = drmModeAtomicCommit(fd, request, flags, context);
    drmModeAtomicFree(request);
    return error;
}

int pel_drm_damage_flip(const struct pel_drm_damage *damage, int fd,
                        uint32_t buffer, const struct pel_rect *area,
                        void *context)
{
    const struct drm_mode_rect clip = {area->x0, area->y0, area->x1, area->y1};
    uint32_t clips = 0;
    if (!damage->plane ||
        (!pel_rect_empty(area) &&
         drmModeCreatePropertyBlob(fd, &clip, sizeof clip, &clips)))
        return -1;
    const int error = commit(damage, fd, buffer, clips, context);
    if (clips)
        drmModeDestroyPropertyBlob(fd, clips);
    return error;
}
