#include "sim/view/inspect.h"

#include <string.h>

#include "core/format/formats.h"
#include "core/format/word.h"
#include "core/image/glyph_text.h"
#include "core/outline/outline.h"
#include "core/raster/line.h"
#include "core/raster/rectangle.h"
#include "core/raster/thick_line.h"
#include "core/round/circle.h"
#include "sim/script/commands.h"

const struct inspect_format inspect_formats[INSPECT_FORMATS] = {
    {&pel_xrgb8888, false, "xrgb8888"},
    {&pel_rgb565_le, false, "rgb565_le"},
    {&pel_rgb565_le, true, "rgb565_le, dithered"},
    {&pel_gray8, false, "gray8"},
    {&pel_mono1, true, "mono1, dithered"},
};

/* The format of counts. */

/* Colors stay apart, so that gradients fill cell by cell. */
static uint32_t color_word(pel_color color)
{
    return color;
}

static pel_color heat_color(uint32_t count)
{
    static const pel_color colors[7] = {
        PEL_RGB(0, 0, 0),      PEL_RGB(0, 0, 255),   PEL_RGB(0, 192, 255),
        PEL_RGB(0, 224, 0),    PEL_RGB(255, 224, 0), PEL_RGB(255, 0, 0),
        PEL_RGB(255, 255, 255)};
    return colors[count < 6 ? count : 6];
}

static void count_spans(const struct pel_spans *spans, uint32_t color)
{
    for (int32_t i = 0; i < spans->n && pel_alpha(color) > 0; i++)
        for (int32_t x = spans->span[i].x0; x < spans->span[i].x1; x++)
            ++*pel_address32(spans->surface, x, spans->y + i * spans->step);
}

static void count_put(const struct pel_surface *s, int32_t x, int32_t y,
                      int32_t n, const pel_color *colors)
{
    for (int32_t i = 0; i < n; i++)
        *pel_address32(s, x + i, y) += pel_alpha(colors[i]) > 0;
}

static void heat_load(const struct pel_surface *s, int32_t x, int32_t y,
                      int32_t n, pel_color *colors)
{
    for (int32_t i = 0; i < n; i++)
        colors[i] = heat_color(*pel_address32(s, x + i, y));
}

const struct pel_format inspect_heat = {.id = 201,
                                        .bits = 32,
                                        .word = 4,
                                        .pack = color_word,
                                        .unpack = heat_color,
                                        .fill = count_spans,
                                        .blend = count_spans,
                                        .put = count_put,
                                        .load = heat_load};

void inspect_box(const struct pel_surface *surface, const struct pel_rect *box,
                 pel_color color)
{
    const struct pel_flat paint = PEL_FLAT(color);
    const struct pel_rect *c = &surface->clip; /* and a pixel around it */
    const struct pel_rect seen = {c->x0 - 1, c->y0 - 1, c->x1 + 1, c->y1 + 1};
    const struct pel_rect b = pel_rect_intersect(box, &seen);
    if (!pel_rect_empty(&b))
        pel_rectangle_outline(
            surface, (struct pel_point){PEL_PX(b.x0), PEL_PX(b.y0)},
            (struct pel_point){PEL_PX(b.x1), PEL_PX(b.y1)}, &paint.paint);
}

void inspect_bands(const struct pel_surface *surface,
                   const struct pel_rect *picture, int rows, int zoom)
{
    const struct pel_flat tint = PEL_FLAT(PEL_RGBA(255, 255, 255, 40));
    const int32_t height = rows * zoom;
    for (int32_t y = picture->y0; y < picture->y1; y += 2 * height) {
        const struct pel_rect band = {picture->x0, y, picture->x1,
                                      pel_min(y + height, picture->y1)};
        pel_box(surface, &band, &tint.paint);
    }
}

void inspect_text(const struct pel_surface *surface,
                  const struct pel_font_asset *font, const char *text,
                  bool below)
{
    enum { MARGIN = 4 };
    static const struct pel_flat ink = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_flat dark = PEL_FLAT(PEL_RGBA(0, 0, 0, 176));
    const struct pel_text_size size = pel_text_measure(font, text);
    const int32_t x = surface->clip.x0, height = size.height + 2 * MARGIN;
    const int32_t y = below ? surface->clip.y1 - height : surface->clip.y0;
    const struct pel_rect box = {x, y, x + size.width + 2 * MARGIN, y + height};
    const struct pel_text_block block = {font, text, x + MARGIN, y + MARGIN};
    pel_box(surface, &box, &dark.paint);
    pel_text(surface, &block, &ink.paint);
}

enum { ZOOM = 16, PIXELS = 17 }; /* of a pixel; each way */

/* The magnified place of a point of the picture. */
struct lens {
    const struct pel_surface *surface;
    int32_t x, y;      /* px of the picture that is at */
    int32_t left, top; /* this pixel */
};

static bool enlarge(const struct lens *l, const int32_t *v, struct pel_point *p)
{
    const int64_t x = (v[0] - (int64_t)PEL_PX(l->x)) * ZOOM + PEL_PX(l->left);
    const int64_t y = (v[1] - (int64_t)PEL_PX(l->y)) * ZOOM + PEL_PX(l->top);
    *p = (struct pel_point){(int32_t)x, (int32_t)y};
    return x > -PEL_PX(32000) && x < PEL_PX(32000) && y > -PEL_PX(32000) &&
           y < PEL_PX(32000);
}

/* The sides of what has corners, and circles. */
static void draw_shape(const struct lens *l, const struct script *script,
                       const struct script_item *item)
{
    static const struct pel_flat line = PEL_FLAT(PEL_RGB(255, 0, 128));
    const char *name = item->command->name;
    const int32_t *v = script->values + item->first;
    const bool has_corners =
        strcmp(name, "triangle") == 0 || strncmp(name, "polygon", 7) == 0;
    struct pel_point a, b;
    if (strcmp(name, "circle") == 0 && enlarge(l, v, &a) &&
        v[2] < PEL_PX(32000) / ZOOM)
        pel_circle_outline(l->surface, a, v[2] * ZOOM, &line.paint);
    for (size_t i = 0; has_corners && i < item->count; i += 2)
        if (enlarge(l, v + i, &a) && enlarge(l, v + (i + 2) % item->count, &b))
            pel_line(l->surface, a, b, &line.paint);
}

/* The pixels, and a dot at each centre. */
static void draw_pixels(const struct lens *l, const struct pel_surface *picture)
{
    static const struct pel_flat dot = PEL_FLAT(PEL_RGBA(128, 128, 128, 200));
    for (int32_t i = 0; i < PIXELS * PIXELS; i++) {
        const int32_t x = l->x + i % PIXELS, y = l->y + i / PIXELS;
        const int32_t left = l->left + i % PIXELS * ZOOM;
        const int32_t top = l->top + i / PIXELS * ZOOM;
        const struct pel_rect box = {left + 1, top + 1, left + ZOOM,
                                     top + ZOOM};
        struct pel_flat paint = PEL_FLAT(PEL_RGB(0, 0, 0));
        if (x >= 0 && y >= 0 && x < picture->bounds.x1 &&
            y < picture->bounds.y1)
            picture->format->load(picture, x, y, 1, &paint.color);
        pel_box(l->surface, &box, &paint.paint);
        pel_circle(
            l->surface,
            (struct pel_point){PEL_PX(left + ZOOM / 2), PEL_PX(top + ZOOM / 2)},
            PEL_PX(1), &dot.paint);
    }
}

void inspect_magnifier(const struct pel_surface *surface,
                       const struct pel_surface *picture,
                       const struct script *script, int x, int y)
{
    const struct pel_rect *all = &surface->clip;
    struct pel_surface own = *surface;
    const bool right = 2 * x < picture->bounds.x1;
    const bool below = 2 * y < picture->bounds.y1;
    const struct lens l = {&own, x - PIXELS / 2, y - PIXELS / 2,
                           right ? all->x1 - PIXELS * ZOOM : all->x0,
                           below ? all->y1 - PIXELS * ZOOM : all->y0};
    struct pel_rect box = {l.left, l.top, l.left + PIXELS * ZOOM,
                           l.top + PIXELS * ZOOM};
    box = pel_rect_intersect(&box, all);
    static const struct pel_flat gray = PEL_FLAT(PEL_RGB(96, 96, 96));
    pel_surface_clip(&own, &box);
    pel_box(&own, &box, &gray.paint);
    draw_pixels(&l, picture);
    for (size_t i = 0; i < script->item_count; i++)
        draw_shape(&l, script, &script->items[i]);
}
