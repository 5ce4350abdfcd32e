#include "paint_mask.h"

/* A row of memory: grey, until a paint puts a color there, which it weighs.
 * Grey has alpha 0, so what is not painted stays invisible. */
static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    pel_color *to = pel_address32(s, x, y);
    for (int32_t i = 0; i < n; i++)
        to[i] = pel_weighed(colors[i], pel_blue(to[i]));
}

static void fill(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step)
        for (int32_t x = span->x0; x < span->x1; x++)
            put(spans->surface, x, y, 1, &color);
}

static pel_color same(uint32_t color)
{
    return color;
}

static const struct pel_format row_format = {.id = 254,
                                             .bits = 32,
                                             .word = 4,
                                             .pack = same,
                                             .unpack = same,
                                             .fill = fill,
                                             .blend = fill,
                                             .put = put};

static void colors_of(const struct pel_color_paint *paint, int32_t x, int32_t y,
                      int32_t n, pel_color *colors)
{
    const struct pel_masked *p = (const void *)paint;
    const struct pel_rect row = {x, y, x + n, y + 1};
    const struct pel_rect r = pel_rect_intersect(&row, &p->box);
    const struct pel_surface surface = {colors, 0, row, row, &row_format};
    const struct pel_span span = {r.x0, r.x1};
    const struct pel_spans spans = {&surface, &span, y, 1, 1};
    for (int32_t i = 0; i < n; i++)
        colors[i] = 0;
    if (pel_rect_empty(&r))
        return;
    p->mask->format->load(p->mask, r.x0 - p->box.x0 + p->mask->bounds.x0,
                          y - p->box.y0 + p->mask->bounds.y0, r.x1 - r.x0,
                          colors + (r.x0 - x));
    for (int32_t i = 0; i < n; i++)
        colors[i] = pel_blue(colors[i]);
    p->paint->fill(p->paint, &spans);
}

enum pel_status pel_masked_init(struct pel_masked *paint,
                                const struct pel_surface *mask, int32_t x,
                                int32_t y, const struct pel_paint *inner)
{
    if (!paint)
        return PEL_ERROR_NULL;
    pel_paint_clear(&paint->base.paint);
    if (!mask || !inner)
        return PEL_ERROR_NULL;
    if (inner == &paint->base.paint)
        return PEL_ERROR_RANGE;
    if (!mask->format || !mask->format->load)
        return PEL_ERROR_FORMAT;
    if (!pel_pixel_legal(x, y))
        return PEL_ERROR_RANGE;
    const struct pel_rect *b = &mask->bounds;
    pel_color_paint_init(&paint->base, colors_of, false);
    paint->mask = mask;
    paint->paint = inner;
    paint->box = (struct pel_rect){x, y, x + b->x1 - b->x0, y + b->y1 - b->y0};
    return PEL_OK;
}
