#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "display_linux_drm.h"

#include <drm_fourcc.h>
#include <poll.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#include <xf86drm.h>

#include <pel/pel.h>
#include "linux_io.h"

enum { FLIP_TIMEOUT = 1000 /* ms */ };

static int failed(struct pel_display_drm *drm, const char *what)
{
    errno = errno ? errno : EINVAL;
    return pel_message_errno(drm->message, what);
}

static void buffer_free(int fd, struct pel_drm_buffer *b)
{
    if (b->map)
        munmap(b->map, b->length);
    if (b->id)
        drmModeRmFB(fd, b->id);
    if (b->handle)
        drmModeDestroyDumbBuffer(fd, b->handle);
    memset(b, 0, sizeof(*b));
}

/* A buffer of the mode's size that the device can show in this format. */
static int buffer_make(struct pel_display_drm *drm, struct pel_drm_buffer *b)
{
    const uint32_t width = drm->mode.hdisplay, height = drm->mode.vdisplay;
    const uint32_t code =
        drm->format->bits == 16 ? DRM_FORMAT_RGB565 : DRM_FORMAT_XRGB8888;
    uint32_t pitches[4] = {0}, handles[4] = {0}, offsets[4] = {0};
    uint64_t length, offset;
    if (drmModeCreateDumbBuffer(drm->fd, width, height, drm->format->bits, 0,
                                &b->handle, &pitches[0], &length))
        return failed(drm, "cannot make a dumb buffer");
    handles[0] = b->handle;
    b->length = (size_t)length;
    if (drmModeAddFB2(drm->fd, width, height, code, handles, pitches, offsets,
                      &b->id, 0))
        return failed(drm, "the device does not show this pixel format");
    if (drmModeMapDumbBuffer(drm->fd, b->handle, &offset))
        return failed(drm, "cannot map a dumb buffer");
    void *map = mmap(NULL, b->length, PROT_READ | PROT_WRITE, MAP_SHARED,
                     drm->fd, (off_t)offset);
    if (map == MAP_FAILED)
        return failed(drm, "cannot map a dumb buffer's memory");
    b->map = map;
    memset(map, 0, b->length);
    const struct pel_rect screen = {0, 0, (int32_t)width, (int32_t)height};
    errno = EINVAL;
    if (pel_surface_init_rect(&b->surface, drm->format, map,
                              (int32_t)pitches[0], &screen))
        return failed(drm, "a dumb buffer's lines are not aligned");
    return 0;
}

static int buffers_make(struct pel_display_drm *drm)
{
    int error = buffer_make(drm, &drm->buffer[0]);
    return error ? error : buffer_make(drm, &drm->buffer[1]);
}

static void buffers_free(struct pel_display_drm *drm)
{
    for (int i = 0; i < 2; i++)
        buffer_free(drm->fd, &drm->buffer[i]);
}

static enum pel_status gone(struct pel_display_drm *drm, const char *what)
{
    failed(drm, what);
    return PEL_ERROR_DEVICE;
}

static void flip_done(int fd, unsigned int frame, unsigned int seconds,
                      unsigned int microseconds, void *data)
{
    struct pel_display_drm *drm = data;
    (void)fd, (void)frame, (void)seconds, (void)microseconds;
    drm->flipping = false;
}

/* One event, or why there is none: 0 or an errno. */
static int take_event(int fd)
{
    drmEventContext events = {.version = 2, .page_flip_handler = flip_done};
    struct pollfd line = {.fd = fd, .events = POLLIN};
    int n = poll(&line, 1, FLIP_TIMEOUT);
    if (n == 0)
        return ETIMEDOUT;
    if (n > 0 && line.revents & (POLLERR | POLLHUP))
        return ENODEV;
    if (n < 0)
        return errno;
    errno = EIO;
    return drmHandleEvent(fd, &events) ? errno : 0;
}

/* Until no page flip is on its way. */
static enum pel_status finish_flip(struct pel_display_drm *drm)
{
    while (drm->flipping) {
        int error = take_event(drm->fd);
        if (error == 0 || error == EINTR || error == EAGAIN)
            continue;
        drm->flipping = false;
        errno = error;
        return gone(drm, "the display does not finish a page flip");
    }
    return PEL_OK;
}

static bool is_turned(const struct pel_display_drm *drm)
{
    return drm->frame.turns != 0;
}

static enum pel_status drm_wait(const struct pel_display *display)
{
    return finish_flip(display->context);
}

static enum pel_status drm_begin(const struct pel_display *display,
                                 const struct pel_rect *area,
                                 struct pel_surface *surface)
{
    struct pel_display_drm *drm = display->context;
    enum pel_status status = finish_flip(drm);
    *surface =
        is_turned(drm) ? drm->frame.upright : drm->buffer[drm->back].surface;
    pel_surface_clip(surface, area);
    return status;
}

/* The pixels are where the device reads them, or are copied there by the flip.
 */
static enum pel_status drm_flush(const struct pel_display *display,
                                 const struct pel_surface *surface)
{
    struct pel_display_drm *drm = display->context;
    pel_turned_change(&drm->frame, &surface->clip);
    return PEL_OK;
}

static struct pel_turned_memory memory_of(const struct pel_drm_buffer *b)
{
    const struct pel_surface *const s = &b->surface;
    return (struct pel_turned_memory){.pixels = b->map,
                                      .stride = s->stride,
                                      .width = s->bounds.x1,
                                      .height = s->bounds.y1,
                                      .bits = s->format->bits};
}

/* The hidden buffer misses what has changed since it was shown, and differs in
 * no more from the one that is shown. */
static void copy_changes(struct pel_display_drm *drm)
{
    const struct pel_turned_memory memory = memory_of(&drm->buffer[drm->back]);
    const struct pel_rect now = drm->frame.changed;
    pel_turned_change(&drm->frame, &drm->last_change);
    if (is_turned(drm))
        pel_turned_copy(&drm->frame, &drm->frame.changed, &memory);
    drm->area = pel_turned_place(&drm->frame, &drm->frame.changed);
    drm->last_change = now;
    pel_turned_forget(&drm->frame);
}

static int show(struct pel_display_drm *drm, uint32_t id)
{
    return drmModeSetCrtc(drm->fd, drm->crtc, id, 0, 0, &drm->connector, 1,
                          &drm->mode);
}

/* Without a page flip. If that fails, the frame's changes stay in the list: the
 * other buffer still misses them. */
static int show_and_announce(struct pel_display_drm *drm, uint32_t id)
{
    if (show(drm, id)) {
        pel_turned_change(&drm->frame, &drm->last_change);
        return -1;
    }
    const struct pel_rect *const a = &drm->area;
    drmModeClip clip = {(uint16_t)a->x0, (uint16_t)a->y0, (uint16_t)a->x1,
                        (uint16_t)a->y1};
    drmModeDirtyFB(drm->fd, id, &clip, drm->shown && !pel_rect_empty(a));
    drm->shown = true;
    if (!drm->no_flips)
        pel_drm_damage_find(&drm->damage, drm->fd, id);
    return 0;
}

/* Told of its damage, or not. */
static int request_flip(struct pel_display_drm *drm, uint32_t id)
{
    if (pel_drm_damage_flip(&drm->damage, drm->fd, id, &drm->area, drm) == 0)
        return 0;
    return drmModePageFlip(drm->fd, drm->crtc, id, DRM_MODE_PAGE_FLIP_EVENT,
                           drm);
}

static enum pel_status drm_flip(const struct pel_display *display)
{
    struct pel_display_drm *drm = display->context;
    const uint32_t id = drm->buffer[drm->back].id;
    copy_changes(drm);
    if (drm->shown && !drm->no_flips) {
        drm->flipping = request_flip(drm, id) == 0;
        drm->no_flips = !drm->flipping;
    }
    if (!drm->flipping && show_and_announce(drm, id))
        return gone(drm, errno == EACCES || errno == EBUSY
                             ? "another program, a desktop perhaps, has the "
                               "screen"
                             : "the display does not show a frame");
    drm->back = !drm->back;
    return PEL_OK;
}

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

/* `unknown`: outputs whose driver cannot tell whether a screen is there, such
 * as panels and analogue ones without EDID; they have the modes that it
 * guesses. */
static int take(struct pel_display_drm *drm, const drmModeConnector *c,
                const drmModeRes *all, bool unknown)
{
    if (c->connection !=
            (unknown ? DRM_MODE_UNKNOWNCONNECTION : DRM_MODE_CONNECTED) ||
        c->count_modes < 1)
        return 0;
    drm->crtc = crtc_of(drm->fd, c, all);
    drm->connector = c->connector_id;
    drm->mode = *preferred_mode(c);
    return drm->crtc != 0;
}

/* Sets connector, crtc and mode: the first connected output, or the first that
 * may be, its preferred mode (the first one where none is), the CRTC that feeds
 * it, or one that can. 0 or an errno, with the message. */
static int find_output(struct pel_display_drm *drm, const char *path)
{
    int found = 0;
    drmModeRes *all = drmModeGetResources(drm->fd);
    if (!all)
        return pel_message_set(drm->message, errno ? errno : EINVAL,
                               "%s is no DRM device with a display: %s", path,
                               strerror(errno ? errno : EINVAL));
    for (int i = 0; !found && i < 2 * all->count_connectors; i++) {
        const bool unknown = i >= all->count_connectors;
        drmModeConnector *c = drmModeGetConnector(
            drm->fd, all->connectors[i % all->count_connectors]);
        found = c && take(drm, c, all, unknown);
        drmModeFreeConnector(c);
    }
    drmModeFreeResources(all);
    return found ? 0
                 : pel_message_set(drm->message, ENODEV,
                                   "no screen is connected to %s; plug one in, "
                                   "or name another device",
                                   path);
}

int pel_display_drm_open(struct pel_display_drm *drm, const char *path,
                         struct pel_message *message)
{
    memset(drm, 0, sizeof(*drm));
    drm->message = message;
    drm->fd = pel_linux_open(path, O_RDWR);
    if (drm->fd < 0)
        return pel_message_open(message, path, errno,
                                "is the driver loaded? ls /dev/dri/card*");
    int error = find_output(drm, path);
    if (error)
        pel_display_drm_close(drm);
    return error;
}

/* The device's preferred depth first; whatever it shows then. */
int pel_display_drm_start(struct pel_display *display,
                          struct pel_display_drm *drm, int32_t turns)
{
    uint64_t depth = 0;
    drmGetCap(drm->fd, DRM_CAP_DUMB_PREFERRED_DEPTH, &depth);
    drm->format = depth == 16 ? &pel_rgb565_le : &pel_xrgb8888;
    drm->before = drmModeGetCrtc(drm->fd, drm->crtc);
    int error = buffers_make(drm);
    if (error) {
        buffers_free(drm);
        drm->format = depth == 16 ? &pel_xrgb8888 : &pel_rgb565_le;
        error = buffers_make(drm);
    }
    if (!error && turns) {
        const struct pel_turned_memory memory = memory_of(&drm->buffer[0]);
        errno = pel_turned_make(&drm->frame, drm->format, &memory, turns);
        error = errno ? failed(drm, "no memory for a frame") : 0;
    }
    const int32_t width = drm->mode.hdisplay, height = drm->mode.vdisplay;
    *display = (struct pel_display){.context = drm,
                                    .width = turns & 1 ? height : width,
                                    .height = turns & 1 ? width : height,
                                    .format = drm->format,
                                    .pages = turns ? 1 : 2,
                                    .flush = drm_flush,
                                    .begin = drm_begin,
                                    .wait = drm_wait,
                                    .flip = drm_flip};
    return error;
}

/* The event of a flip that is still on its way would later pass for that of
 * another. */
void pel_display_drm_leave(void *display)
{
    struct pel_display_drm *drm = display;
    finish_flip(drm);
    drmDropMaster(drm->fd);
}

void pel_display_drm_enter(void *display)
{
    struct pel_display_drm *drm = display;
    drmSetMaster(drm->fd);
    drm->shown = false;
    drm->flipping = false;
}

void pel_display_drm_close(struct pel_display_drm *drm)
{
    drmModeCrtc *before = drm->before;
    if (drm->fd < 0)
        return;
    finish_flip(drm);
    if (drm->shown && before && before->buffer_id)
        drmModeSetCrtc(drm->fd, before->crtc_id, before->buffer_id, before->x,
                       before->y, &drm->connector, 1, &before->mode);
    if (before)
        drmModeFreeCrtc(before);
    drm->before = NULL;
    buffers_free(drm);
    pel_turned_free(&drm->frame);
    close(drm->fd);
    drm->fd = -1;
}
