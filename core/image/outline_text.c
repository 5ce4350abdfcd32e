#include "outline_text.h"

#include "../path/pen.h"
#include "../path/transform.h"
#include "outline_glyphs.h"

/* A glyph at its place: what an outline source walks. */
struct placed {
    const struct pel_outline_font_asset *font;
    const struct pel_outline_glyph *glyph;
    struct pel_transform transform;
    int32_t tolerance;
};

/* Points of a glyph on their way to curves. */
struct points {
    const uint8_t *at, *end;
    uint32_t kind; /* enum pel_outline_point */
    int16_t x, y;
    int controls; /* that wait for the end of their curve */
    const struct pel_transform *transform;
    struct pel_curves curves;
};

/* How far a coordinate moves; sizes are those of the asset. */
static int32_t take_move(struct points *p, uint32_t size)
{
    if (size == 0 || p->end - p->at < (size == 3 ? 2 : 1))
        return 0;
    const int32_t n = *p->at++;
    return size == 1 ? n : size == 2 ? -n : (int16_t)(n + 256 * *p->at++);
}

/* The coordinates are modulo 2^16. */
static bool take_point(struct points *p)
{
    if (p->at == p->end)
        return false;
    const uint32_t head = *p->at++;
    p->kind = head & 3;
    p->x = (int16_t)(p->x + take_move(p, head >> 2 & 3));
    p->y = (int16_t)(p->y + take_move(p, head >> 4 & 3));
    return true;
}

/* The curve whose controls wait ends in v[controls + 1]. */
static enum pel_status end_curve(struct points *p)
{
    const int n = p->controls;
    p->controls = 0;
    return pel_curves_add(&p->curves, (enum pel_verb)((int)PEL_LINE + n));
}

/* Where a part begins it closes the one before it. */
static enum pel_status end_part(struct points *p)
{
    if (p->controls == 0)
        return PEL_OK;
    p->curves.v[p->controls + 1] = p->curves.start;
    return end_curve(p);
}

/* A quadratic curve ends half-way between two controls, (x, y) and this one. */
static enum pel_status end_half_way(struct points *p, int32_t x, int32_t y)
{
    if (p->kind != PEL_OUTLINE_QUAD || p->controls == 0)
        return PEL_OK;
    if (!pel_transform_point(p->transform, (x + p->x) >> 1, (y + p->y) >> 1,
                             &p->curves.v[p->controls + 1]))
        return PEL_ERROR_RANGE;
    return end_curve(p);
}

/* Behind (x, y). */
static enum pel_status draw_point(struct points *p, int32_t x, int32_t y)
{
    struct pel_point v;
    if (!pel_transform_point(p->transform, p->x, p->y, &v))
        return PEL_ERROR_RANGE;
    const enum pel_status status =
        p->kind == PEL_OUTLINE_BEGIN ? end_part(p) : end_half_way(p, x, y);
    if (status != PEL_OK)
        return status;
    if (p->kind >= PEL_OUTLINE_QUAD) {
        p->controls = pel_min(p->controls + 1, 2);
        p->curves.v[p->controls] = v;
        return PEL_OK;
    }
    p->curves.v[p->controls + 1] = v;
    return p->kind == PEL_OUTLINE_ON ? end_curve(p)
                                     : pel_curves_add(&p->curves, PEL_MOVE);
}

static enum pel_status walk_glyph(const void *shape, struct pel_sides *sides)
{
    const struct placed *const g = shape;
    const uint8_t *const at = g->font->points + g->glyph->offset;
    struct pel_fill_pen pen;
    struct points p = {.at = at,
                       .end = at + g->glyph->size,
                       .transform = &g->transform,
                       .curves = {.pen = &pen.pen, .tolerance = g->tolerance}};
    enum pel_status status = PEL_OK;
    int32_t x = 0, y = 0;
    pel_fill_pen_begin(&pen, sides);
    for (; status == PEL_OK && take_point(&p); x = p.x, y = p.y)
        status = draw_point(&p, x, y);
    if (status == PEL_OK)
        status = end_part(&p);
    return status == PEL_OK ? pen.pen.draw(&pen.pen, PEL_MOVE, NULL) : status;
}

static uint32_t glyph_of(const struct pel_outline_font_asset *font,
                         uint32_t code)
{
    const uint32_t glyph =
        pel_font_ranges_find(font->range, font->ranges, code);
    return glyph == PEL_FONT_NONE ? font->missing : glyph;
}

static int32_t kerning(const struct pel_outline_font_asset *font, uint32_t left,
                       uint32_t right)
{
    int32_t low = 0, high = font->pairs;
    while (left < 256 && right < 256 && low < high) {
        const int32_t middle = (low + high) / 2;
        const struct pel_outline_pair *const pair = &font->pair[middle];
        const uint32_t at = (uint32_t)pair->left << 8 | pair->right;
        if (at == (left << 8 | right))
            return pair->x;
        if (at < (left << 8 | right))
            low = middle + 1;
        else
            high = middle;
    }
    return 0;
}

/* The pen on a line of text, in units of the font. */
struct line {
    const struct pel_outline_font_asset *font;
    const char *next;
    int32_t x, y;
    uint32_t glyph; /* the last one, whose advance is still to come, or
                       PEL_FONT_NONE */
};

static void advance(struct line *l)
{
    if (l->glyph != PEL_FONT_NONE)
        l->x += l->font->glyph[l->glyph].advance;
}

/* Moves the pen to the next glyph of the line; false at its end, where the pen
 * has passed the last one. */
static bool next_glyph(struct line *l)
{
    while (*l->next && *l->next != '\n') {
        const uint32_t glyph = glyph_of(l->font, pel_utf8_next(&l->next));
        if (glyph == PEL_FONT_NONE)
            continue;
        advance(l);
        l->x += kerning(l->font, l->glyph, glyph);
        l->glyph = glyph;
        return true;
    }
    advance(l);
    return false;
}

int32_t pel_outline_text_width(const struct pel_outline_font_asset *font,
                               const char *string)
{
    struct line l = {font, string, 0, 0, PEL_FONT_NONE};
    while (next_glyph(&l))
        ;
    return l.x;
}

/* What is done with each glyph: false ends the text. */
struct visitor {
    bool (*take)(struct visitor *visitor, struct placed *glyph);
};

static void begin_line(struct line *l,
                       const struct pel_outline_text_block *text)
{
    const int32_t width = text->align == PEL_TEXT_LEFT
                              ? 0
                              : pel_outline_text_width(text->font, l->next);
    l->x = -(text->align == PEL_TEXT_CENTER ? width / 2 : width);
    l->glyph = PEL_FONT_NONE;
}

static void visit(const struct pel_outline_text_block *text,
                  struct visitor *visitor)
{
    const struct pel_outline_font_asset *const font = text->font;
    struct line l = {.font = font, .next = text->string};
    struct placed g = {.font = font,
                       .transform = text->transform,
                       .tolerance = text->tolerance};
    for (;; l.next++, l.y -= font->ascent + font->descent) {
        begin_line(&l, text);
        while (next_glyph(&l)) {
            g.glyph = &font->glyph[l.glyph];
            if (g.glyph->size > 0 &&
                pel_transform_point(&text->transform, l.x, l.y,
                                    &g.transform.at) &&
                !visitor->take(visitor, &g))
                return;
        }
        if (!*l.next)
            return;
    }
}

/* The pixels of the font's box around a glyph, and one more on each side. */
static struct pel_rect box_of(const struct placed *g)
{
    const struct pel_outline_font_asset *const f = g->font;
    const struct pel_rect units = {f->left, f->bottom, f->right, f->top};
    return pel_transform_box(&g->transform, units);
}

struct drawing {
    struct visitor visitor;
    struct pel_surface surface;
    struct pel_rect clip;
    const struct pel_outline_fill *fill;
    enum pel_status status;
};

static bool draw_glyph(struct visitor *visitor, struct placed *g)
{
    struct drawing *const d = (struct drawing *)(void *)visitor;
    const struct pel_outline_source source = {walk_glyph, g};
    const struct pel_rect box = box_of(g);
    d->surface.clip = pel_rect_intersect(&box, &d->clip);
    if (!pel_rect_empty(&d->surface.clip))
        d->status = d->fill->fill(&d->surface, &source, PEL_NON_ZERO,
                                  d->fill->paint, &d->fill->scratch);
    return d->status == PEL_OK;
}

enum pel_status pel_outline_text_fill(const struct pel_surface *surface,
                                      const struct pel_outline_text_block *text,
                                      const struct pel_outline_fill *fill)
{
    struct drawing d = {.visitor = {draw_glyph}, .fill = fill};
    if (!surface || !text || !text->font || !text->string || !fill->paint ||
        !fill->scratch.memory)
        return PEL_ERROR_NULL;
    if (!pel_tolerance_legal(text->tolerance))
        return PEL_ERROR_RANGE;
    d.surface = *surface;
    d.clip = surface->clip;
    visit(text, &d.visitor);
    return d.status;
}

enum pel_status pel_outline_text(const struct pel_surface *surface,
                                 const struct pel_outline_text_block *text,
                                 const struct pel_paint *paint, void *scratch,
                                 size_t size)
{
    const struct pel_outline_fill fill = {
        pel_sides_fill, paint, {scratch, size}};
    return pel_outline_text_fill(surface, text, &fill);
}

struct hit {
    struct visitor visitor;
    int32_t x, y;
    bool inside;
};

static bool hit_glyph(struct visitor *visitor, struct placed *g)
{
    struct hit *const h = (struct hit *)(void *)visitor;
    const struct pel_outline_source source = {walk_glyph, g};
    const struct pel_rect box = box_of(g);
    h->inside = h->x >= box.x0 && h->x < box.x1 && h->y >= box.y0 &&
                h->y < box.y1 &&
                pel_sides_hit(&source, PEL_NON_ZERO, h->x, h->y);
    return !h->inside;
}

bool pel_hit_outline_text(const struct pel_outline_text_block *text, int32_t x,
                          int32_t y)
{
    struct hit h = {.visitor = {hit_glyph}, .x = x, .y = y};
    if (pel_tolerance_legal(text->tolerance))
        visit(text, &h.visitor);
    return h.inside;
}

/* An em is 256 units at least. */
struct pel_transform pel_outline_transform(
    const struct pel_outline_font_asset *font, int32_t size, int32_t turn,
    struct pel_point at)
{
    return pel_transform_turned(pel_transform_scale(size, font->em), turn, true,
                                at);
}
