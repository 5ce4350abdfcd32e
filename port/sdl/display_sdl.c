#include "display_sdl.h"

#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>

#include "display_sdl_draw.h"

/* The same pixels in the panel's own format. */
static struct pel_surface plain(const struct pel_display_sdl *w,
                                const struct pel_surface *surface)
{
    struct pel_surface s = *surface;
    if (s.format == &w->counting)
        s.format = w->options.format;
    return s;
}

static enum pel_status flush(const struct pel_display *display,
                             const struct pel_surface *surface)
{
    struct pel_display_sdl *w = display->context;
    const struct pel_surface s = plain(w, surface);
    const struct pel_rect area = pel_rect_intersect(&s.clip, &w->glass.bounds);
    const struct pel_copy_part part = {&s, area, area.x0, area.y0};
    if (w->closed)
        return PEL_ERROR_DEVICE;
    if (pel_rect_empty(&area))
        return PEL_OK;
    pel_copy(&w->glass, &part);
    if (w->heat)
        pel_display_sdl_settle(w, &area, surface->format == &w->counting);
    w->bytes +=
        (area.x1 - area.x0) * (area.y1 - area.y0) * w->options.format->bits / 8;
    if (w->flushes < PEL_DISPLAY_SDL_FLUSHES)
        w->flush[w->flushes++] = area;
    return PEL_OK;
}

static void write_picture(const struct pel_display_sdl *w)
{
    const struct pel_rect *all = &w->glass.bounds;
    char path[16];
    FILE *file = NULL;
    for (int i = 1; i < 1000 && !file; i++) {
        snprintf(path, sizeof path, "pel-%03d.ppm", i);
        file = fopen(path, "wbx");
    }
    if (!file) {
        fprintf(stderr, "%s: pel-001.ppm to pel-999.ppm cannot be written\n",
                w->options.title);
        return;
    }
    fprintf(file, "P6\n%d %d 255\n", (int)all->x1, (int)all->y1);
    for (int32_t i = 0; i < all->x1 * all->y1; i++) {
        pel_color c;
        w->glass.format->load(&w->glass, i % all->x1, i / all->x1, 1, &c);
        fputc((int)pel_red(c), file);
        fputc((int)pel_green(c), file);
        fputc((int)pel_blue(c), file);
    }
    fprintf(stderr, fclose(file) == 0 ? "written: %s\n" : "not written: %s\n",
            path);
}

static void print_keys(void)
{
    fputs("F1          these keys\n"
          "F2 F3       smaller, larger pixels\n"
          "F4          how often each pixel is painted, from then on\n"
          "F5 F6       bands, a box around each flush\n"
          "F7          a magnifier at the pointer\n"
          "F8          write the picture to a file\n",
          stderr);
}

/* From the next band on. */
static void set_heat(struct pel_display_sdl *w, bool on)
{
    const bool pages = w->options.format->id == PEL_FORMAT_MONO1_PAGES;
    w->heat = on;
    w->display->format = on && !pages ? &w->counting : w->options.format;
    pel_display_sdl_forget(w);
}

/* A key of the window's own. */
static void press(struct pel_display_sdl *w, int key)
{
    switch (key - PEL_KEY_F1) {
    case 0:
        print_keys();
        break;
    case 1:
    case 2:
        w->options.zoom += key == PEL_KEY_F1 + 2 ? 1 : -1;
        w->options.zoom = pel_max(1, pel_min(w->options.zoom, 32));
        break;
    case 3:
        set_heat(w, !w->heat);
        break;
    case 4:
        w->bands = !w->bands;
        break;
    case 5:
        w->boxes = !w->boxes;
        break;
    case 6:
        w->magnifier = !w->magnifier;
        break;
    default:
        write_picture(w);
    }
    w->stale = true;
}

/* From the window's pixels to the panel's; a place outside is that of the
 * nearest one. */
static void point(struct pel_display_sdl *w, struct pel_input *e)
{
    const struct pel_rect all = pel_display_sdl_place(w, &w->glass.bounds);
    const int32_t x = (pel_max(e->x, all.x0) - all.x0) / w->options.zoom;
    const int32_t y = (pel_max(e->y, all.y0) - all.y0) / w->options.zoom;
    e->x = (int16_t)pel_min(x, w->glass.bounds.x1 - 1);
    e->y = (int16_t)pel_min(y, w->glass.bounds.y1 - 1);
    w->stale = w->stale || w->magnifier;
    w->at[0] = e->x;
    w->at[1] = e->y;
}

/* The left button as a finger. False: what happened is nothing for one. */
static bool touch(struct pel_display_sdl *w, struct pel_input *e)
{
    if (e->kind == PEL_INPUT_POINT) {
        e->state = PEL_INPUT_AGAIN;
        if (!w->held)
            return false;
    } else if (e->kind == PEL_INPUT_BUTTON && e->code == 1) {
        w->held = e->state == PEL_INPUT_DOWN;
    } else {
        return true;
    }
    e->kind = PEL_INPUT_TOUCH;
    e->code = 0;
    return true;
}

static void take(struct pel_display_sdl *w, struct pel_input *e)
{
    const bool key = e->kind == PEL_INPUT_KEY;
    if (e->kind == PEL_INPUT_POINT || e->kind == PEL_INPUT_BUTTON)
        point(w, e);
    if (key && e->code >= PEL_KEY_F1 && e->code < PEL_KEY_F1 + 8) {
        if (e->state == PEL_INPUT_DOWN)
            press(w, e->code);
    } else if (!w->options.touch || touch(w, e)) {
        pel_input_push(&w->queue, e);
    }
}

/* Takes the events that have come, waits at most so many ms for the first. */
static void pump(struct pel_display_sdl *w, int32_t ms)
{
    struct pel_input input;
    enum pel_window_event event;
    while (!w->closed &&
           (event = pel_window_sdl_event(&input, ms)) != PEL_WINDOW_NOTHING) {
        w->closed = event == PEL_WINDOW_CLOSE;
        w->stale = w->stale || event == PEL_WINDOW_REDRAW;
        if (event == PEL_WINDOW_INPUT)
            take(w, &input);
        ms = 0;
    }
    if (w->stale && !w->closed && !pel_display_sdl_draw(w)) {
        w->message = w->window.message;
        w->closed = true;
    }
}

static enum pel_status flip(const struct pel_display *display)
{
    struct pel_display_sdl *w = display->context;
    w->shown = w->flushes;
    w->shown_bytes = w->bytes;
    w->stale = true;
    pump(w, 0);
    w->flushes = w->bytes = 0;
    int32_t left = (int32_t)(w->due - SDL_GetTicks());
    const uint32_t from = left > 0 ? w->due : SDL_GetTicks();
    for (; w->options.period > 0 && left > 0 && !w->closed;
         left = (int32_t)(w->due - SDL_GetTicks()))
        pump(w, left);
    w->due = from + (uint32_t)w->options.period;
    return w->closed ? PEL_ERROR_DEVICE : PEL_OK;
}

bool pel_display_sdl_next(struct pel_display_sdl *w, struct pel_input *event)
{
    pump(w, 0);
    return pel_input_pop(&w->queue, event);
}

bool pel_display_sdl_wait(struct pel_display_sdl *w, int32_t ms,
                          struct pel_input *event)
{
    const uint32_t start = SDL_GetTicks();
    while (!pel_display_sdl_next(w, event)) {
        const int32_t passed = (int32_t)(SDL_GetTicks() - start);
        if (w->closed || (ms >= 0 && passed >= ms))
            return false;
        pump(w, ms < 0 ? 50 : pel_min(ms - passed, 50));
    }
    return true;
}

/* Memory for a surface of the panel's size. */
static enum pel_status surface_of(struct pel_surface *s,
                                  const struct pel_format *format,
                                  const struct pel_display_sdl_options *o)
{
    const struct pel_rect all = {0, 0, o->width, o->height};
    const size_t size =
        (size_t)pel_stride(format, o->width) * (size_t)pel_max(o->height, 0);
    void *const pixels = calloc(size + 1, 1);
    const enum pel_status status =
        pixels ? pel_surface_init(s, format, pixels, size, &all)
               : PEL_ERROR_SIZE;
    s->pixels = pixels;
    return status;
}

static enum pel_status open_all(struct pel_display_sdl *w,
                                const struct pel_display_sdl_options *o)
{
    enum pel_status status = surface_of(&w->glass, o->format, o);
    if (status == PEL_OK)
        status = surface_of(&w->counts, &pel_heat, o);
    if (status == PEL_OK)
        status = surface_of(&w->counted, &pel_heat, o);
    if (status != PEL_OK) {
        w->message = "no panel has this size, or memory is short";
        return status;
    }
    const int32_t zoom = w->options.zoom;
    const struct pel_window_sdl_options window = {
        o->title, o->width * zoom, o->height * zoom, o->period == 0};
    w->closed = !pel_window_sdl_open(&w->window, &window);
    w->message = w->closed ? w->window.message : NULL;
    return w->closed ? PEL_ERROR_DEVICE : PEL_OK;
}

enum pel_status pel_display_sdl_open(struct pel_display *display,
                                     struct pel_display_sdl *w,
                                     const struct pel_display_sdl_options *o)
{
    *w = (struct pel_display_sdl){
        .options = *o, .display = display, .closed = true};
    if (!display || !o->format)
        return PEL_ERROR_NULL;
    if (!o->format->load || !o->format->put) {
        w->message = "the format of the panel cannot be read";
        return PEL_ERROR_FORMAT;
    }
    if (!o->title)
        w->options.title = "Pel";
    if (o->zoom < 1 || o->zoom > 32)
        w->options.zoom = pel_max(
            1, pel_min(480 / pel_max(pel_max(o->width, o->height), 1), 32));
    w->queue.events = w->events;
    w->queue.size = PEL_DISPLAY_SDL_EVENTS;
    w->counting = pel_display_sdl_counting(o->format);
    *display = (struct pel_display){.context = w,
                                    .width = o->width,
                                    .height = o->height,
                                    .format = o->format,
                                    .flush = flush,
                                    .flip = flip};
    return open_all(w, &w->options);
}

void pel_display_sdl_close(struct pel_display_sdl *w)
{
    pel_window_sdl_close(&w->window);
    free(w->glass.pixels);
    free(w->counts.pixels);
    free(w->counted.pixels);
    w->glass.pixels = w->counts.pixels = w->counted.pixels = NULL;
    w->closed = true;
}
