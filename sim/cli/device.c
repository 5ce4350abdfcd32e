#include "sim/cli/device.h"

#include <stdio.h>
#include <string.h>

#include "core/raster/rectangle.h"
#include "sim/cli/message.h"
#include "port/linux/bands.h"

const struct option_row device_option_table[] = {
    {"device", "NAME",
     "show the picture until a key is pressed: fb:/dev/fb0 (with ,direct "
     ",shadow or ,pages after it), drm:/dev/dri/card0, either with ,rotate=90 "
     "(180, 270), "
     "panel:st7789,spi=/dev/spidev0.0,dc=GPIO25,reset=GPIO27 and so on "
     "(docs/linux.md), or auto: what FRAMEBUFFER names, else /dev/fb0, else "
     "DRM",
     OPTION_TEXT, .offset = offsetof(struct device_options, name)},
    {"jobs", "N",
     "threads that draw bands side by side (0: one for each processor)",
     OPTION_INTEGER, .offset = offsetof(struct device_options, jobs), .low = 0,
     .high = PEL_POOL_MOST},
    {.help = NULL},
};

const struct option_row output_option_table[] = {
    {"output", "FILE", "the picture: .ppm, .png or .bmp", OPTION_TEXT,
     .letter = 'o'},
    {.help = NULL},
};

bool device_check_output(const struct device_options *o, const char *output)
{
    return !o->name || strcmp(output, "-") == 0 ||
           message_error(
               "--device shows the picture and -o writes it: expected "
               "one of them");
}

struct job {
    device_draw_function *draw;
    const void *context;
    int failed; /* set by any thread */
};

static void draw_band(void *context, const struct pel_surface *band)
{
    struct job *job = context;
    struct canvas part = {.surface = *band};
    if (!job->draw(&part, job->context))
        __atomic_store_n(&job->failed, 1, __ATOMIC_RELAXED);
}

bool device_draw_bands(struct pel_pool *pool, struct canvas *canvas,
                       device_draw_function *draw, const void *context)
{
    struct job job = {draw, context, 0};
    if (pool->threads == 0)
        return draw(canvas, context);
    pel_bands_draw(pool, &canvas->surface, draw_band, &job);
    return !job.failed;
}

static void start_pool(struct pel_pool *pool, const struct device_options *o)
{
    pel_pool_start(pool, o->jobs ? o->jobs : pel_pool_processors());
}

static bool save(const struct device_options *o,
                 const struct device_picture *picture, const char *path)
{
    struct canvas canvas;
    struct pel_pool pool;
    if (!canvas_init(&canvas, *picture->format, picture->width,
                     picture->height))
        return false;
    start_pool(&pool, o);
    const bool done =
        device_draw_bands(&pool, &canvas, picture->draw, picture->context);
    pel_pool_end(&pool);
    const bool saved = done && canvas_save(&canvas, path);
    canvas_free(&canvas);
    return saved;
}

/* The part of the picture that the screen holds, as a canvas with the picture's
 * coordinates: its pixel (0, 0) lies at (left, top) of the screen, where a byte
 * of its memory begins. */
static struct canvas place(const struct pel_surface *screen,
                           const struct device_picture *picture)
{
    struct canvas canvas = {.surface = *screen};
    const struct pel_format *format = screen->format;
    const int32_t pixels = format->bits < 8 ? 8 / format->bits : 1;
    const bool pages = format->id == PEL_FORMAT_MONO1_PAGES;
    struct pel_rect whole = {0, 0, picture->width, picture->height};
    const int32_t left = (screen->bounds.x1 - picture->width) / 2 & -pixels;
    const int32_t top = (screen->bounds.y1 - picture->height) / 2 & -pixels;
    const struct pel_rect visible = {-left, -top, screen->bounds.x1 - left,
                                     screen->bounds.y1 - top};
    const struct pel_rect shown = pel_rect_intersect(&whole, &visible);
    const int32_t x = shown.x0 + left, y = shown.y0 + top;
    canvas.surface.pixels = (uint8_t *)screen->pixels +
                            (pages ? y / 8 * screen->stride + x
                                   : y * screen->stride + x * format->bits / 8);
    canvas.surface.bounds = canvas.surface.clip = shown;
    return canvas;
}

static bool fails(const struct pel_display_linux *screen)
{
    return message_error("%s", screen->message.text);
}

bool device_open(struct pel_display_linux *screen,
                 const struct device_options *o, enum pel_fb_way way)
{
    const char *name = strcmp(o->name, "auto") == 0 ? NULL : o->name;
    if (pel_display_linux_open(screen, name, way) != PEL_OK)
        return fails(screen);
    if (screen->note.text[0])
        message_error("%s", screen->note.text);
    if (screen->console.text[0])
        message_error("%s", screen->console.text);
    return true;
}

bool device_frame(struct pel_display_linux *screen, device_frame_function *draw,
                  void *context)
{
    struct pel_surface surface;
    struct pel_dirty_areas changed = {.window = 256};
    enum pel_status status =
        pel_display_begin(&screen->display, &screen->area, &surface);
    if (status != PEL_OK)
        return fails(screen);
    pel_clear(&surface, PEL_RGB(0, 0, 0));
    if (!draw(&surface, &changed, context))
        return false;
    for (int i = 0; status == PEL_OK && i < changed.count; i++) {
        pel_display_align(&screen->display, &changed.area[i]);
        surface.clip = changed.area[i];
        status = pel_display_flush(&screen->display, &surface);
    }
    if (status == PEL_OK)
        status = pel_display_flip(&screen->display);
    return status == PEL_OK || fails(screen);
}

/* A picture, and the threads that draw it. */
struct showing {
    const struct device_picture *picture;
    struct pel_pool pool;
};

static bool draw_placed(struct pel_surface *surface,
                        struct pel_dirty_areas *changed, void *context)
{
    struct showing *s = context;
    pel_dirty_areas_add(changed, &surface->clip);
    struct canvas canvas = place(surface, s->picture);
    return device_draw_bands(&s->pool, &canvas, s->picture->draw,
                             s->picture->context);
}

static bool show(struct pel_display_linux *screen, struct showing *s)
{
    enum pel_console_event event;
    do {
        if (!device_frame(screen, draw_placed, s))
            return false;
        do
            event = pel_display_linux_wait(screen, -1);
        while (event == PEL_CONSOLE_NOTHING);
    } while (event == PEL_CONSOLE_REDRAW);
    return true;
}

static bool show_on_screen(const struct device_options *o,
                           const struct device_picture *picture)
{
    struct pel_display_linux screen;
    struct showing showing = {.picture = picture};
    if (!device_open(&screen, o, PEL_FB_STILL))
        return false;
    *picture->format = screen.display.format;
    start_pool(&showing.pool, o);
    const bool shown = show(&screen, &showing);
    pel_pool_end(&showing.pool);
    pel_display_linux_close(&screen);
    return shown;
}

bool device_show(const struct device_options *o,
                 const struct device_picture *picture, const char *output)
{
    return o->name ? show_on_screen(o, picture) : save(o, picture, output);
}
