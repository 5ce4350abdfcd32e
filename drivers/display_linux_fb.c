#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "display_linux_fb.h"

#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "linux_io.h"

#ifndef FBIO_WAITFORVSYNC
#define FBIO_WAITFORVSYNC _IOW('F', 0x20, uint32_t)
#endif

static int failed(struct pel_display_fb *fb, const char *what)
{
    return pel_message_errno(fb->message, what);
}

/* The mode as the kernel reports it: FBIOPUT_VSCREENINFO may return 0
 * and change nothing. */
static int read_mode(int fd, struct pel_fb_mode *mode)
{
    if (pel_linux_ioctl(fd, FBIOGET_VSCREENINFO, &mode->variable) ||
        pel_linux_ioctl(fd, FBIOGET_FSCREENINFO, &mode->fixed))
        return -1;
    return 0;
}

static struct pel_rect screen_of(const struct pel_display_fb *fb)
{
    struct pel_rect screen = {0, 0, (int32_t)fb->mode.variable.xres,
                              (int32_t)fb->mode.variable.yres};
    return screen;
}

/* Of a pixel in memory: fewer than 8, or those of the format. */
static uint32_t pixel_bits(const struct pel_display_fb *fb)
{
    const uint32_t few = pel_fb_few_bits(&fb->mode);
    return few ? few : fb->format->bits;
}

static int set_color_map(struct pel_display_fb *fb)
{
    uint16_t channel[3][PEL_FB_COLORS];
    struct fb_cmap map = {
        .red = channel[0], .green = channel[1], .blue = channel[2]};
    map.len = pel_fb_color_map(&fb->mode, fb->format, channel);
    return map.len ? pel_linux_ioctl(fb->fd, FBIOPUTCMAP, &map) : 0;
}

static int pan(struct pel_display_fb *fb, uint32_t yoffset)
{
    struct fb_var_screeninfo v = fb->mode.variable;
    v.yoffset = yoffset;
    v.activate = FB_ACTIVATE_VBL;
    if (pel_linux_ioctl(fb->fd, FBIOPAN_DISPLAY, &v))
        return -1;
    fb->mode.variable.yoffset = yoffset;
    return 0;
}

static bool has_two_pages(const struct pel_fb_mode *mode)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    return v->yres_virtual >= 2 * v->yres && mode->fixed.ypanstep &&
           v->yres % mode->fixed.ypanstep == 0 &&
           (uint64_t)2 * v->yres * mode->fixed.line_length <=
               mode->fixed.smem_len;
}

static bool same_layout(const struct pel_fb_mode *a,
                        const struct pel_fb_mode *b)
{
    enum { CHANNEL = sizeof(struct fb_bitfield) };
    return a->variable.xres == b->variable.xres &&
           a->variable.yres == b->variable.yres &&
           a->variable.xoffset == b->variable.xoffset &&
           a->variable.bits_per_pixel == b->variable.bits_per_pixel &&
           memcmp(&a->variable.red, &b->variable.red, CHANNEL) == 0 &&
           memcmp(&a->variable.green, &b->variable.green, CHANNEL) == 0 &&
           memcmp(&a->variable.blue, &b->variable.blue, CHANNEL) == 0 &&
           a->fixed.line_length == b->fixed.line_length &&
           a->fixed.visual == b->fixed.visual;
}

/* Makes room for two pages where there is none and the device can pan. */
static void ask_for_pages(struct pel_display_fb *fb)
{
    struct pel_fb_mode now = fb->mode;
    struct fb_var_screeninfo v = fb->mode.variable;
    if (v.yres_virtual >= 2 * v.yres || !fb->mode.fixed.ypanstep)
        return;
    v.yres_virtual = 2 * v.yres;
    v.activate = FB_ACTIVATE_NOW;
    if (pel_linux_ioctl(fb->fd, FBIOPUT_VSCREENINFO, &v) == 0 &&
        read_mode(fb->fd, &now) == 0 && same_layout(&now, &fb->mode)) {
        fb->mode = now;
        return;
    }
    v = fb->mode.variable;
    pel_linux_ioctl(fb->fd, FBIOPUT_VSCREENINFO, &v);
}

/* Panning is believed when the device then says that it shows the other page
 * and comes back. */
static bool pans(struct pel_display_fb *fb)
{
    struct pel_fb_mode now;
    const uint32_t other =
        fb->mode.variable.yoffset ? 0 : fb->mode.variable.yres;
    const uint32_t before = fb->mode.variable.yoffset;
    if (!has_two_pages(&fb->mode) || pan(fb, other))
        return false;
    bool moved = read_mode(fb->fd, &now) == 0 && now.variable.yoffset == other;
    return pan(fb, before) == 0 && moved;
}

/* Must all be copied from a shadow? */
static bool is_copied(const struct pel_display_fb *fb, int32_t turns)
{
    return turns != 0 || pel_fb_few_bits(&fb->mode);
}

static void choose_way(struct pel_display_fb *fb, enum pel_fb_way way,
                       int32_t turns)
{
    const bool any = way == PEL_FB_ANY || way == PEL_FB_STILL;
    fb->way = any && is_copied(fb, turns) ? PEL_FB_SHADOW : way;
    way = fb->way;
    if (way == PEL_FB_SHADOW || way == PEL_FB_DIRECT)
        return;
    ask_for_pages(fb);
    if (pans(fb))
        fb->way = PEL_FB_PAGES;
    else
        fb->way = way == PEL_FB_STILL ? PEL_FB_DIRECT : PEL_FB_SHADOW;
}

/* The kernel maps whole memory pages; smem_start may lie inside the first. */
static int map_memory(struct pel_display_fb *fb)
{
    const long page = sysconf(_SC_PAGESIZE);
    const size_t skip = (size_t)fb->mode.fixed.smem_start & (size_t)(page - 1);
    fb->map_length = fb->mode.fixed.smem_len + skip;
    void *map = mmap(NULL, fb->map_length, PROT_READ | PROT_WRITE, MAP_SHARED,
                     fb->fd, 0);
    if (map == MAP_FAILED)
        return failed(fb, "cannot map the framebuffer's memory");
    fb->map = map;
    const struct fb_var_screeninfo *v = &fb->mode.variable;
    const struct pel_rect screen = screen_of(fb);
    const int32_t line = (int32_t)fb->mode.fixed.line_length;
    const uint32_t bits = pixel_bits(fb);
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t top = fb->way == PEL_FB_PAGES ? i * v->yres : v->yoffset;
        uint8_t *first = fb->map + skip + (size_t)top * (size_t)line +
                         (size_t)v->xoffset * bits / 8;
        if (fb->way == PEL_FB_SHADOW) {
            fb->memory = (struct pel_turned_memory){
                .pixels = first,
                .stride = line,
                .width = screen.x1,
                .height = screen.y1,
                .bits = (uint8_t)bits,
                .low_first = PEL_LE16(1) == 1,
                .inverted = fb->mode.fixed.visual == FB_VISUAL_MONO01};
            return 0;
        }
        if (pel_surface_init_rect(&fb->page[i], fb->format, first, line,
                                  &screen)) {
            errno = EINVAL;
            return failed(fb, "the framebuffer's lines are not aligned");
        }
    }
    return 0;
}

static int make_shadow(struct pel_display_fb *fb, int32_t turns)
{
    errno = pel_turned_make(&fb->shadow, fb->format, &fb->memory, turns);
    return errno ? failed(fb, "no memory for a frame") : 0;
}

static enum pel_status fb_begin(const struct pel_display *display,
                                const struct pel_rect *area,
                                struct pel_surface *surface)
{
    struct pel_display_fb *fb = display->context;
    *surface =
        fb->way == PEL_FB_SHADOW ? fb->shadow.upright : fb->page[fb->back];
    pel_surface_clip(surface, area);
    return PEL_OK;
}

static enum pel_status fb_flush(const struct pel_display *display,
                                const struct pel_surface *surface)
{
    struct pel_display_fb *fb = display->context;
    pel_turned_change(&fb->shadow, &surface->clip);
    return PEL_OK;
}

/* A device without the request gets it once. */
static void wait_for_vsync(struct pel_display_fb *fb)
{
    uint32_t head = 0;
    if (!fb->no_vsync && pel_linux_ioctl(fb->fd, FBIO_WAITFORVSYNC, &head))
        fb->no_vsync = errno != ETIMEDOUT;
}

/* Notices that the device went away, or that another program set its mode. */
static enum pel_status check_mode(struct pel_display_fb *fb)
{
    struct pel_fb_mode now;
    if (read_mode(fb->fd, &now)) {
        failed(fb, "the framebuffer device is gone");
        return PEL_ERROR_DEVICE;
    }
    if (same_layout(&now, &fb->mode))
        return PEL_OK;
    pel_message_set(fb->message, EINVAL,
                    "another program changed the framebuffer's mode, to %ux%u "
                    "with %u bits; begin again in the new one",
                    now.variable.xres, now.variable.yres,
                    now.variable.bits_per_pixel);
    return PEL_ERROR_DEVICE;
}

static enum pel_status show_page(struct pel_display_fb *fb)
{
    if (pan(fb, (uint32_t)fb->back * fb->mode.variable.yres)) {
        int error = errno;
        enum pel_status status = check_mode(fb);
        errno = error;
        if (status == PEL_OK)
            failed(fb, "the framebuffer does not pan any more");
        return PEL_ERROR_DEVICE;
    }
    wait_for_vsync(fb);
    fb->back = !fb->back;
    return PEL_OK;
}

static enum pel_status fb_flip(const struct pel_display *display)
{
    struct pel_display_fb *fb = display->context;
    enum pel_status status = check_mode(fb);
    if (status)
        return status;
    if (fb->way == PEL_FB_SHADOW) {
        wait_for_vsync(fb);
        pel_turned_copy(&fb->shadow, &fb->shadow.changed, &fb->memory);
    } else if (fb->way == PEL_FB_PAGES) {
        status = show_page(fb);
    }
    pel_turned_forget(&fb->shadow);
    return status;
}

/* The mode of the device now, and its format. */
static int read_format(struct pel_display_fb *fb)
{
    if (read_mode(fb->fd, &fb->mode))
        return failed(fb, "cannot read the framebuffer's mode");
    fb->format = pel_fb_format(&fb->mode, fb->message);
    return fb->format ? 0 : EINVAL;
}

int pel_display_fb_open(struct pel_display_fb *fb, const char *path,
                        struct pel_message *message)
{
    memset(fb, 0, sizeof(*fb));
    fb->message = message;
    fb->fd = pel_linux_open(path, O_RDWR);
    if (fb->fd < 0)
        return pel_message_open(message, path, errno,
                                "is the driver loaded? ls /dev/fb*");
    int error = read_format(fb);
    if (error == ENOTTY)
        pel_message_set(message, error, "%s is no framebuffer device", path);
    if (error)
        pel_display_fb_close(fb);
    return error;
}

int pel_display_fb_start(struct pel_display *display, struct pel_display_fb *fb,
                         enum pel_fb_way way, int32_t turns)
{
    int error = read_format(fb);
    if (error)
        return error;
    choose_way(fb, way, turns);
    if (fb->way != PEL_FB_SHADOW && is_copied(fb, turns))
        return pel_message_set(
            fb->message, EINVAL,
            "%.16s: a picture that is turned, or of %u bits, "
            "is drawn in a shadow; use no other way",
            fb->mode.fixed.id, fb->mode.variable.bits_per_pixel);
    if (way == PEL_FB_PAGES && fb->way != PEL_FB_PAGES)
        return pel_message_set(fb->message, EINVAL,
                               "%.16s does not pan: no two pages; use "
                               "shadow or direct",
                               fb->mode.fixed.id);
    fb->back = fb->way == PEL_FB_PAGES && fb->mode.variable.yoffset == 0;
    if (set_color_map(fb))
        return failed(fb, "cannot set the colour map (FBIOPUTCMAP)");
    error = map_memory(fb);
    if (!error && fb->way == PEL_FB_SHADOW)
        error = make_shadow(fb, turns);
    const struct pel_rect screen = screen_of(fb);
    *display = (struct pel_display){.context = fb,
                                    .width = turns & 1 ? screen.y1 : screen.x1,
                                    .height = turns & 1 ? screen.x1 : screen.y1,
                                    .format = fb->format,
                                    .pages = fb->way == PEL_FB_PAGES ? 2 : 1,
                                    .flush = fb_flush,
                                    .begin = fb_begin,
                                    .flip = fb_flip};
    return error;
}

void pel_display_fb_enter(void *display)
{
    struct pel_display_fb *fb = display;
    struct fb_var_screeninfo v = fb->mode.variable;
    v.activate = FB_ACTIVATE_NOW;
    pel_linux_ioctl(fb->fd, FBIOPUT_VSCREENINFO, &v);
    set_color_map(fb);
    if (fb->way == PEL_FB_SHADOW)
        fb->shadow.changed = fb->shadow.upright.bounds;
}

void pel_display_fb_close(struct pel_display_fb *fb)
{
    if (fb->map)
        munmap(fb->map, fb->map_length);
    pel_turned_free(&fb->shadow);
    fb->map = NULL;
    if (fb->fd >= 0)
        close(fb->fd);
    fb->fd = -1;
}
