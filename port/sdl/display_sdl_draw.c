#include "display_sdl_draw.h"

#include <stdio.h>
#include <string.h>

struct pel_rect pel_display_sdl_place(const struct pel_display_sdl *w,
                                      const struct pel_rect *area)
{
    const int32_t zoom = w->options.zoom;
    const struct pel_rect *all = &w->window.surface.bounds;
    const int32_t x = (all->x1 - w->options.width * zoom) / 2;
    const int32_t y = (all->y1 - w->options.height * zoom) / 2;
    return (struct pel_rect){x + area->x0 * zoom, y + area->y0 * zoom,
                             x + area->x1 * zoom, y + area->y1 * zoom};
}

static void draw_flushes(const struct pel_display_sdl *w)
{
    const struct pel_surface *s = &w->window.surface;
    for (int32_t i = 0; i < w->shown; i++) {
        const struct pel_rect at = pel_display_sdl_place(w, &w->flush[i]);
        const struct pel_rect seen = pel_rect_intersect(&at, &s->clip);
        if (w->bands && i % 2 == 0)
            pel_inspect_tint(s, &seen);
        if (w->boxes)
            pel_inspect_box(s, &at, PEL_RGB(255, 0, 0));
    }
}

static void set_title(struct pel_display_sdl *w)
{
    char title[200];
    snprintf(title, sizeof title,
             "%.80s: %d x %d, pixels x %d%s, %d bytes in %d flushes. F1: keys",
             w->options.title, (int)w->options.width, (int)w->options.height,
             (int)w->options.zoom, w->heat ? ", how often painted" : "",
             (int)w->shown_bytes, (int)w->shown);
    pel_window_sdl_title(&w->window, title);
}

bool pel_display_sdl_draw(struct pel_display_sdl *w)
{
    const struct pel_surface *picture = w->heat ? &w->counted : &w->glass;
    bool anew;
    if (!pel_window_sdl_fit(&w->window, &anew))
        return false;
    const struct pel_surface *s = &w->window.surface;
    const struct pel_rect at = pel_display_sdl_place(w, &w->glass.bounds);
    struct pel_lens lens;
    pel_clear(s, PEL_RGB(0, 0, 0));
    pel_inspect_enlarge(s, picture, at.x0, at.y0, w->options.zoom);
    draw_flushes(w);
    if (w->magnifier)
        pel_lens_draw(&lens, s, picture, w->at[0], w->at[1]);
    set_title(w);
    w->stale = false;
    return pel_window_sdl_show(&w->window);
}

/* The window of a surface of its counting format. */
static const struct pel_display_sdl *window_of(const struct pel_surface *s)
{
    return (const void *)((const char *)s->format -
                          offsetof(struct pel_display_sdl, counting));
}

/* Pixels of one row, as far as they are of the panel. */
static struct pel_span part(const struct pel_display_sdl *w,
                            const struct pel_span *span, int32_t y)
{
    const struct pel_rect *all = &w->counts.bounds;
    const bool inside = y >= 0 && y < all->y1;
    return (struct pel_span){pel_max(span->x0, 0),
                             inside ? pel_min(span->x1, all->x1) : 0};
}

static void count(const struct pel_display_sdl *w,
                  const struct pel_spans *spans, pel_color color)
{
    for (int32_t i = 0; i < spans->n; i++) {
        const int32_t y = spans->y + i * spans->step;
        const struct pel_span own = part(w, &spans->span[i], y);
        const struct pel_spans one = {&w->counts, &own, y, 1, 0};
        pel_heat.fill(&one, color);
    }
}

static const struct pel_format *format_of(const struct pel_surface *s)
{
    return window_of(s)->options.format;
}

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    count(window_of(spans->surface), spans, PEL_RGB(0, 0, 0));
    format_of(spans->surface)->fill(spans, pixel);
}

static void blend(const struct pel_spans *spans, pel_color color)
{
    count(window_of(spans->surface), spans, color);
    format_of(spans->surface)->blend(spans, color);
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    for (int32_t i = 0; i < n; i++) {
        const struct pel_span one = {x + i, x + i + 1};
        const struct pel_spans spans = {s, &one, y, 1, 0};
        count(window_of(s), &spans, colors[i]);
    }
    format_of(s)->put(s, x, y, n, colors);
}

static void dither_fill(const struct pel_surface *s,
                        const struct pel_spans *spans, pel_color color,
                        const pel_thresholds *rows)
{
    count(window_of(s), spans, color);
    format_of(s)->channels->fill(s, spans, color, rows);
}

static int32_t dither_put(const struct pel_surface *s,
                          const struct pel_spans *spans,
                          const pel_color *colors, const pel_thresholds *rows)
{
    const int32_t done = format_of(s)->channels->put(s, spans, colors, rows);
    const struct pel_span one = {spans->span->x0, spans->span->x0 + done};
    const struct pel_spans put = {s, &one, spans->y, 1, 0};
    count(window_of(s), &put, PEL_RGB(0, 0, 0));
    return done;
}

static const struct pel_channels gray_channels = {.fill = dither_fill,
                                                  .put = dither_put};

struct pel_format pel_display_sdl_counting(const struct pel_format *of)
{
    struct pel_format format = *of;
    const struct pel_channels *const channels = of->channels;
    format.id = 250;
    format.fill = fill;
    format.blend = blend;
    format.put = put;
    format.channels =
        channels && channels->fill && channels->put ? &gray_channels : NULL;
    return format;
}

static void clear_counts(const struct pel_surface *counts,
                         const struct pel_rect *area)
{
    for (int32_t y = area->y0; y < area->y1; y++)
        memset(pel_surface_line(counts, y) + 4 * (size_t)area->x0, 0,
               4 * (size_t)(area->x1 - area->x0));
}

void pel_display_sdl_settle(struct pel_display_sdl *w,
                            const struct pel_rect *area, bool counted)
{
    static const struct pel_flat once = PEL_FLAT(PEL_RGB(0, 0, 0));
    const struct pel_copy_part part = {&w->counts, *area, area->x0, area->y0};
    if (!counted)
        pel_box(&w->counts, area, &once.paint);
    pel_copy(&w->counted, &part);
    clear_counts(&w->counts, area);
}

void pel_display_sdl_forget(struct pel_display_sdl *w)
{
    clear_counts(&w->counts, &w->counts.bounds);
    clear_counts(&w->counted, &w->counted.bounds);
}
