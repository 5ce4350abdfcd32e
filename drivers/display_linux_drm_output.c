#include "display_linux_drm_output.h"

#include <errno.h>
#include <string.h>

static uint32_t crtc_of_encoder(int fd, uint32_t id, const drmModeRes *all)
{
    uint32_t crtc = 0;
    drmModeEncoder *encoder = drmModeGetEncoder(fd, id);
    if (!encoder)
        return 0;
    crtc = encoder->crtc_id;
    for (int i = 0; !crtc && i < all->count_crtcs; i++)
        if (encoder->possible_crtcs >> i & 1)
            crtc = all->crtcs[i];
    drmModeFreeEncoder(encoder);
    return crtc;
}

static uint32_t crtc_of(int fd, const drmModeConnector *c,
                        const drmModeRes *all)
{
    uint32_t crtc = c->encoder_id ? crtc_of_encoder(fd, c->encoder_id, all) : 0;
    for (int i = 0; !crtc && i < c->count_encoders; i++)
        crtc = crtc_of_encoder(fd, c->encoders[i], all);
    return crtc;
}

static const drmModeModeInfo *preferred_mode(const drmModeConnector *c)
{
    for (int i = 0; i < c->count_modes; i++)
        if (c->modes[i].type & DRM_MODE_TYPE_PREFERRED)
            return &c->modes[i];
    return &c->modes[0];
}

static int take(struct pel_display_drm *drm, const drmModeConnector *c,
                const drmModeRes *all)
{
    if (c->connection != DRM_MODE_CONNECTED || c->count_modes < 1)
        return 0;
    drm->crtc = crtc_of(drm->fd, c, all);
    drm->connector = c->connector_id;
    drm->mode = *preferred_mode(c);
    return drm->crtc != 0;
}

int pel_drm_find_output(struct pel_display_drm *drm, const char *path)
{
    int found = 0;
    drmModeRes *all = drmModeGetResources(drm->fd);
    if (!all) {
        int error = errno ? errno : EINVAL;
        pel_message_set(drm->message, "%s is no DRM device with a display: %s",
                        path, strerror(error));
        return error;
    }
    for (int i = 0; !found && i < all->count_connectors; i++) {
        drmModeConnector *c = drmModeGetConnector(drm->fd, all->connectors[i]);
        found = c && take(drm, c, all);
        drmModeFreeConnector(c);
    }
    drmModeFreeResources(all);
    if (found)
        return 0;
    pel_message_set(drm->message,
                    "no screen is connected to %s; plug one in, or name "
                    "another device",
                    path);
    return ENODEV;
}
