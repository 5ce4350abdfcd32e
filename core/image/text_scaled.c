#include "../raster/rectangle.h"
#include "glyph_text.h"

/* A paint of a surface whose pixels are squares of another one. */
struct squares {
    struct pel_paint paint;
    const struct pel_surface *surface; /* the other one */
    const struct pel_paint *inner;
    int32_t x, y, scale; /* px of the other one: where (0, 0) is; a square */
};

/* The squares of span i. */
static struct pel_rect box_of(const struct squares *s,
                              const struct pel_spans *spans, int32_t i)
{
    const struct pel_span *span = &spans->span[i];
    const int32_t y = s->y + (spans->y + i * spans->step) * s->scale;
    return (struct pel_rect){s->x + span->x0 * s->scale, y,
                             s->x + span->x1 * s->scale, y + s->scale};
}

static void squares_fill(const struct pel_paint *paint,
                         const struct pel_spans *spans)
{
    const struct squares *s = (const void *)paint;
    for (int32_t i = 0; i < spans->n; i++) {
        const struct pel_rect box = box_of(s, spans, i);
        pel_box(s->surface, &box, s->inner);
    }
}

/* floor(a / scale) of a from -98,304 to 98,303. */
static int32_t square_of(int32_t a, int32_t scale)
{
    return a / scale - (a % scale < 0);
}

/* The squares that reach into the clip. */
static struct pel_rect squares_in(const struct squares *s)
{
    const struct pel_rect *c = &s->surface->clip;
    return (struct pel_rect){square_of(c->x0 - s->x, s->scale),
                             square_of(c->y0 - s->y, s->scale),
                             square_of(c->x1 - 1 - s->x, s->scale) + 1,
                             square_of(c->y1 - 1 - s->y, s->scale) + 1};
}

static bool legal(const struct pel_text_block *text, int32_t scale)
{
    const struct pel_font_asset *font = text->font;
    while (font && !font->kind)
        font = font->next;
    return !font && scale >= 1 && scale <= 1024 &&
           pel_offset_legal(text->x, text->y);
}

void pel_text_scaled(const struct pel_surface *surface,
                     const struct pel_text_block *text, int32_t scale,
                     const struct pel_paint *paint)
{
    const bool is_legal = legal(text, scale);
    PEL_ASSERT(is_legal);
    if (!is_legal)
        return;
    const struct squares squares = {
        {.fill = squares_fill}, surface, paint, text->x, text->y, scale};
    const struct pel_rect all = squares_in(&squares);
    const struct pel_surface field = {.bounds = all, .clip = all};
    const struct pel_text_block small = {text->font, text->string, 0, 0};
    if (scale == 1)
        pel_text(surface, text, paint);
    else
        pel_text(&field, &small, &squares.paint);
}
