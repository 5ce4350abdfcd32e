/* The frames of a sheet: its picture, whole or where it has changed, and what
 * is shown over it. */
#include <stdio.h>
#include <string.h>

#include "core/raster/rectangle.h"
#include "sim/cli/milliseconds.h"
#include "sim/view/sheet.h"

enum { BAND_ROWS = 16 };

/* Where a part of the picture is on a surface, in the middle of its clip: the
 * window. */
static struct pel_rect place(const struct sheet *s, const struct pel_rect *clip,
                             const struct pel_rect *part)
{
    const int zoom = s->zoom;
    const int left = clip->x0 + (s->width - s->script.width * zoom) / 2;
    const int top = clip->y0 + (s->height - s->script.height * zoom) / 2;
    return (struct pel_rect){left + part->x0 * zoom, top + part->y0 * zoom,
                             left + part->x1 * zoom, top + part->y1 * zoom};
}

bool sheet_pixel(const struct sheet *s, int *x, int *y)
{
    static const struct pel_rect window = {0};
    const struct pel_rect all = {0, 0, s->script.width, s->script.height};
    const struct pel_rect at = place(s, &window, &all);
    *x = (s->pointer[0] - at.x0) / s->zoom;
    *y = (s->pointer[1] - at.y0) / s->zoom;
    return s->pointer[0] >= at.x0 && s->pointer[0] < at.x1 &&
           s->pointer[1] >= at.y0 && s->pointer[1] < at.y1;
}

/* The pixels of figures that have changed, where they were and are. */
static void add_areas(struct sheet *s)
{
    const struct pel_rect *bounds = &s->canvas.surface.bounds;
    const struct figures *was = &s->drawn, *is = &s->figures;
    const bool moved = was->turn != is->turn || was->phase != is->phase ||
                       was->dithered != is->dithered ||
                       was->smooth != is->smooth;
    for (int k = 0; k < s->shapes; k++) {
        const struct style *a = &s->drawn_style[k], *b = &s->style[k];
        if (!moved && a->fill == b->fill && a->color == b->color &&
            a->alpha == b->alpha && a->marked == b->marked)
            continue;
        const struct pel_rect box[2] = {figures_box(&s->drawn, k),
                                        figures_box(&s->figures, k)};
        for (int i = 0; i < 2; i++) {
            struct pel_rect area = pel_rect_intersect(&box[i], bounds);
            area.x0 &= ~7; /* where bytes begin */
            area.x1 = pel_min((area.x1 + 7) & ~7, bounds->x1);
            pel_dirty_areas_add(&s->areas, &area);
        }
    }
}

/* Draws an area of the picture, in its memory. */
static bool draw_area(struct sheet *s, const struct pel_rect *area)
{
    struct canvas part = {.memory = NULL};
    const struct pel_surface *all = &s->canvas.surface;
    pel_surface_init_rect(&part.surface, all->format,
                          pel_surface_line(all, area->y0) +
                              area->x0 * all->format->bits / 8,
                          all->stride, area);
    return script_draw(&s->script, &part, -1);
}

static bool draw_whole(struct sheet *s)
{
    canvas_free(&s->canvas);
    if (!canvas_init(&s->canvas, s->script.format, s->script.width,
                     s->script.height))
        return false;
    if (s->inspect.heat)
        memset(s->canvas.memory, 0,
               (size_t)s->canvas.surface.stride * (size_t)s->script.height);
    s->areas.area[s->areas.count++] = s->canvas.surface.bounds;
    return script_draw(&s->script, &s->canvas, -1);
}

static bool draw_picture(struct sheet *s)
{
    const double start = milliseconds();
    bool done = sheet_compose(s);
    s->areas.count = 0;
    const bool whole = s->whole || s->path || s->inspect.heat;
    if (done && !whole)
        add_areas(s);
    for (int i = 0; done && i < s->areas.count; i++)
        done = draw_area(s, &s->areas.area[i]);
    if (done && whole)
        done = draw_whole(s);
    s->drawn = s->figures;
    memcpy(s->drawn_style, s->style, (size_t)s->shapes * sizeof *s->style);
    s->whole = !done;
    s->milliseconds = milliseconds() - start;
    return done;
}

/* The picture, a pixel as a square of zoom x zoom. */
static void show_picture(const struct sheet *s,
                         const struct pel_surface *surface)
{
    const struct pel_surface *from = &s->canvas.surface;
    const struct pel_rect at =
        place(s, &surface->clip, &s->canvas.surface.bounds);
    pel_inspect_enlarge(surface, from, at.x0, at.y0, s->zoom);
}

static void show_numbers(const struct sheet *s,
                         const struct pel_surface *surface)
{
    char text[200];
    int32_t pixels = 0;
    for (int i = 0; i < s->areas.count; i++) {
        const struct pel_rect *a = &s->areas.area[i];
        pixels += (a->x1 - a->x0) * (a->y1 - a->y0);
    }
    snprintf(text, sizeof text,
             "%.1f ms, %d pixels and %d bytes in %d areas, %s\n"
             "%.1f ms with the window, %d late",
             s->milliseconds, (int)pixels,
             (int)(pixels * s->script.format->bits / 8), (int)s->areas.count,
             inspect_formats[s->inspect.format].name, s->show.draw_time,
             s->show.late);
    inspect_text(surface, &s->font, text, true);
}

static void show_overlays(const struct sheet *s,
                          const struct pel_surface *surface)
{
    const struct inspect *show = &s->inspect;
    const struct pel_rect at =
        place(s, &surface->clip, &s->canvas.surface.bounds);
    int x, y;
    for (int i = 0; show->areas && i < s->areas.count; i++) {
        const struct pel_rect box = place(s, &surface->clip, &s->areas.area[i]);
        pel_inspect_box(surface, &box, PEL_RGB(255, 0, 0));
    }
    if (show->bands)
        inspect_bands(surface, &at, BAND_ROWS, s->zoom);
    if (show->numbers)
        show_numbers(s, surface);
    if (show->help)
        inspect_text(surface, &s->font, SHEET_KEYS_HELP, false);
    if (show->magnifier && sheet_pixel(s, &x, &y))
        inspect_magnifier(surface, &s->canvas.surface, &s->script, x, y);
}

bool sheet_draw(struct show *show, const struct pel_surface *surface)
{
    struct sheet *s = (struct sheet *)show;
    const struct inspect *i = &s->inspect;
    const bool covered =
        i->bands || i->areas || i->magnifier || i->numbers || i->help;
    const bool all = s->whole || s->covered || covered;
    s->covered = covered;
    if (!draw_picture(s))
        return false;
    pel_clear(surface, PEL_RGB(0, 0, 0));
    show_picture(s, surface);
    show_overlays(s, surface);
    if (all)
        return true;
    show->changed.count = 0; /* only the picture has changed */
    for (int k = 0; k < s->areas.count; k++) {
        const struct pel_rect box = place(s, &surface->clip, &s->areas.area[k]);
        const struct pel_rect seen = pel_rect_intersect(&box, &surface->clip);
        pel_dirty_areas_add(&show->changed, &seen);
    }
    return true;
}
