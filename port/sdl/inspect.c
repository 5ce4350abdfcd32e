#include "inspect.h"

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

const struct pel_format pel_heat = {.id = 251,
                                    .bits = 32,
                                    .word = 4,
                                    .pack = color_word,
                                    .unpack = heat_color,
                                    .fill = count_spans,
                                    .blend = count_spans,
                                    .put = count_put,
                                    .load = heat_load};

void pel_inspect_enlarge(const struct pel_surface *surface,
                         const struct pel_surface *picture, int32_t x,
                         int32_t y, int32_t zoom)
{
    const struct pel_rect *from = &picture->bounds;
    const struct pel_rect at = {x, y, x + (from->x1 - from->x0) * zoom,
                                y + (from->y1 - from->y0) * zoom};
    if (zoom == 1) {
        const struct pel_copy_part all = {picture, *from, x, y};
        pel_copy(surface, &all);
        return;
    }
    const uint64_t step = (UINT64_C(1) << 32) / (uint64_t)zoom + 1;
    const struct pel_texture_map map = {
        {step / 2 - (uint64_t)(int64_t)x * step, step, 0},
        {step / 2 - (uint64_t)(int64_t)y * step, 0, step}};
    const struct pel_texels texels = {.surface = picture};
    struct pel_texture paint;
    pel_texture_init_nearest(&paint, &texels, &map);
    pel_box(surface, &at, &paint.base.paint);
}

void pel_inspect_tint(const struct pel_surface *surface,
                      const struct pel_rect *area)
{
    static const struct pel_flat tint = PEL_FLAT(PEL_RGBA(255, 255, 255, 40));
    pel_box(surface, area, &tint.paint);
}

void pel_inspect_box(const struct pel_surface *surface,
                     const struct pel_rect *area, pel_color color)
{
    const struct pel_flat paint = PEL_FLAT(color);
    const struct pel_rect *c = &surface->clip; /* and a pixel around it */
    const struct pel_rect seen = {c->x0 - 1, c->y0 - 1, c->x1 + 1, c->y1 + 1};
    const struct pel_rect b = pel_rect_intersect(area, &seen);
    if (!pel_rect_empty(&b))
        pel_rectangle_outline(
            surface, (struct pel_point){PEL_PX(b.x0), PEL_PX(b.y0)},
            (struct pel_point){PEL_PX(b.x1), PEL_PX(b.y1)}, &paint.paint);
}

/* The pixels, and a dot at each centre. */
static void draw_pixels(const struct pel_lens *l,
                        const struct pel_surface *picture)
{
    enum { ZOOM = PEL_LENS_ZOOM, PIXELS = PEL_LENS_PIXELS };
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
        pel_box(&l->surface, &box, &paint.paint);
        pel_circle(&l->surface, pel_at(left + ZOOM / 2, top + ZOOM / 2),
                   PEL_PX(1), &dot.paint);
    }
}

void pel_lens_draw(struct pel_lens *lens, const struct pel_surface *surface,
                   const struct pel_surface *picture, int32_t x, int32_t y)
{
    enum { SIDE = PEL_LENS_PIXELS * PEL_LENS_ZOOM };
    static const struct pel_flat gray = PEL_FLAT(PEL_RGB(96, 96, 96));
    const struct pel_rect *all = &surface->clip;
    const bool right = 2 * x < picture->bounds.x1;
    const bool below = 2 * y < picture->bounds.y1;
    *lens = (struct pel_lens){
        *surface, x - PEL_LENS_PIXELS / 2, y - PEL_LENS_PIXELS / 2,
        right ? all->x1 - SIDE : all->x0, below ? all->y1 - SIDE : all->y0};
    const struct pel_rect box = {lens->left, lens->top, lens->left + SIDE,
                                 lens->top + SIDE};
    const struct pel_rect seen = pel_rect_intersect(&box, all);
    pel_surface_clip(&lens->surface, &seen);
    pel_box(&lens->surface, &seen, &gray.paint);
    draw_pixels(lens, picture);
}
