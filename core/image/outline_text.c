#include "outline_text.h"

#include "../path/pen.h"
#include "../path/transform.h"
#include "outline_glyphs.h"

PEL_STATIC_ASSERT(pel_outline_drawing_fits,
                  sizeof(struct pel_outline_drawing) <= PEL_PENS_SIZE);
PEL_STATIC_ASSERT(pel_outline_points_are_overwritten,
                  PEL_SMOOTH_PENS_AT +
                          offsetof(struct pel_outline_drawing, points) <=
                      PEL_SMOOTH_PAINT_AT);

/* How far a coordinate moves; sizes are those of the asset. */
static int32_t take_move(struct pel_outline_points *p, uint32_t size)
{
    if (size == 0 || p->end - p->at < (size == 3 ? 2 : 1))
        return 0;
    const int32_t n = *p->at++;
    return size == 1 ? n : size == 2 ? -n : (int16_t)(n + 256 * *p->at++);
}

/* The coordinates are modulo 2^16. */
static bool take_point(struct pel_outline_points *p)
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
static enum pel_status end_curve(struct pel_outline_points *p)
{
    const int n = p->controls;
    p->controls = 0;
    return pel_curves_add(&p->curves, (enum pel_verb)((int)PEL_LINE + n));
}

/* Where a part begins it closes the one before it. */
static enum pel_status end_part(struct pel_outline_points *p)
{
    if (p->controls == 0)
        return PEL_OK;
    p->curves.v[p->controls + 1] = p->curves.start;
    return end_curve(p);
}

/* A quadratic curve ends half-way between its control and the next one, v. */
static enum pel_status end_half_way(struct pel_outline_points *p,
                                    struct pel_point v)
{
    const struct pel_point *const c = &p->curves.v[p->controls];
    if (p->kind != PEL_OUTLINE_QUAD || p->controls == 0)
        return PEL_OK;
    p->curves.v[p->controls + 1] =
        (struct pel_point){(c->x + v.x) >> 1, (c->y + v.y) >> 1};
    return end_curve(p);
}

static enum pel_status draw_point(struct pel_outline_points *p)
{
    struct pel_point v;
    if (!pel_transform_point(p->transform, p->x, p->y, &v))
        return PEL_ERROR_RANGE;
    const enum pel_status status =
        p->kind == PEL_OUTLINE_BEGIN ? end_part(p) : end_half_way(p, v);
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

static void begin_points(const struct pel_outline_placed *g,
                         struct pel_sides *sides)
{
    struct pel_outline_points *const p = g->points;
    const uint8_t *const at = g->text->font->points + g->glyph->offset;
    *p = (struct pel_outline_points){
        .at = at,
        .end = at + g->glyph->size,
        .transform = &g->transform,
        .curves = {.pen = &p->pen.pen, .tolerance = g->text->tolerance}};
    pel_fill_pen_begin(&p->pen, sides);
}

static enum pel_status walk_glyph(const void *shape, struct pel_sides *sides)
{
    struct pel_outline_points *const p =
        ((const struct pel_outline_placed *)shape)->points;
    enum pel_status status = PEL_OK;
    begin_points(shape, sides);
    while (status == PEL_OK && take_point(p))
        status = draw_point(p);
    if (status == PEL_OK)
        status = end_part(p);
    return status == PEL_OK ? p->pen.pen.draw(&p->pen.pen, PEL_MOVE, NULL)
                            : status;
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
    const struct pel_outline_pair *const pair = pel_font_pair_find(
        font->pair, font->pairs, sizeof *font->pair, left, right);
    return pair ? pair->x : 0;
}

static void advance(struct pel_outline_line *l)
{
    if (l->glyph != PEL_FONT_NONE)
        l->x += l->font->glyph[l->glyph].advance;
}

/* Moves the pen to the next glyph of the line; false at its end, where the pen
 * has passed the last one. */
static bool next_glyph(struct pel_outline_line *l)
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
    struct pel_outline_line l = {font, string, 0, 0, PEL_FONT_NONE};
    while (next_glyph(&l))
        ;
    return l.x;
}

static PEL_NOINLINE void begin_line(struct pel_outline_line *l,
                                    const struct pel_outline_text_block *text)
{
    const int32_t width = text->align == PEL_TEXT_LEFT
                              ? 0
                              : pel_outline_text_width(text->font, l->next);
    l->x = -(text->align == PEL_TEXT_CENTER ? width / 2 : width);
    l->glyph = PEL_FONT_NONE;
}

static void begin_text(struct pel_outline_visitor *v,
                       struct pel_outline_points *points,
                       const struct pel_outline_text_block *text)
{
    v->line.font = text->font;
    v->line.next = text->string;
    v->line.y = 0;
    v->placed.text = text;
    v->placed.points = points;
    v->placed.transform = text->transform;
}

/* Places the next glyph that has points; false: there is none on the line. */
static bool place_next(struct pel_outline_visitor *v)
{
    struct pel_outline_placed *const g = &v->placed;
    while (next_glyph(&v->line)) {
        g->glyph = &v->line.font->glyph[v->line.glyph];
        if (g->glyph->size > 0 &&
            pel_transform_point(&g->text->transform, v->line.x, v->line.y,
                                &g->transform.at))
            return true;
    }
    return false;
}

/* After begin_text: until one says anything but PEL_OK. */
static enum pel_status visit(struct pel_outline_visitor *v)
{
    enum pel_status status = PEL_OK;
    for (;; v->line.next++,
            v->line.y -= v->line.font->ascent + v->line.font->descent) {
        begin_line(&v->line, v->placed.text);
        while (status == PEL_OK && place_next(v))
            status = v->take(v);
        if (status != PEL_OK || !*v->line.next)
            return status;
    }
}

/* The pixels of the font's box around a glyph, and one more on each side. */
static struct pel_rect box_of(const struct pel_outline_placed *g)
{
    const struct pel_outline_font_asset *const f = g->text->font;
    const struct pel_rect units = {f->left, f->bottom, f->right, f->top};
    return pel_transform_box(&g->transform, units);
}

static PEL_NOINLINE enum pel_status begin_glyph(struct pel_outline_drawing *d)
{
    const struct pel_rect box = box_of(&d->visitor.placed);
    d->surface.clip = pel_rect_intersect(&box, &d->target->clip);
    return d->fill.begin(&d->surface, PEL_NON_ZERO, d->fill.paint,
                         &d->fill.scratch);
}

static enum pel_status draw_glyph(struct pel_outline_visitor *v)
{
    struct pel_outline_drawing *const d =
        (struct pel_outline_drawing *)(void *)v;
    const enum pel_status status = begin_glyph(d);
    return status == PEL_OK
               ? pel_sides_draw(d->fill.scratch.memory, walk_glyph, &v->placed)
               : status;
}

static enum pel_status begin_drawing(struct pel_outline_drawing *d,
                                     const struct pel_surface *surface,
                                     const struct pel_outline_text_block *text)
{
    if (!surface || !text || !text->font || !text->string || !d->fill.paint ||
        !d->fill.scratch.memory)
        return PEL_ERROR_NULL;
    if (!pel_tolerance_legal(text->tolerance))
        return PEL_ERROR_RANGE;
    d->visitor.take = draw_glyph;
    d->surface = *surface;
    d->target = surface;
    begin_text(&d->visitor, &d->points, text);
    return PEL_OK;
}

enum pel_status pel_outline_text_draw(struct pel_outline_drawing *d,
                                      const struct pel_surface *surface,
                                      const struct pel_outline_text_block *text)
{
    const enum pel_status status = begin_drawing(d, surface, text);
    return status == PEL_OK ? visit(&d->visitor) : status;
}

enum pel_status pel_outline_text(const struct pel_surface *surface,
                                 const struct pel_outline_text_block *text,
                                 const struct pel_paint *paint, void *scratch,
                                 size_t size)
{
    struct pel_outline_drawing d;
    d.fill =
        (struct pel_outline_fill){pel_sides_begin_fill, paint, {scratch, size}};
    return pel_outline_text_draw(&d, surface, text);
}

struct hit {
    struct pel_outline_visitor visitor;
    struct pel_outline_points points;
    int32_t x, y;
};

/* An error where it is inside. */
static enum pel_status hit_glyph(struct pel_outline_visitor *v)
{
    struct hit *const h = (struct hit *)(void *)v;
    const struct pel_rect box = box_of(&v->placed);
    return h->x >= box.x0 && h->x < box.x1 && h->y >= box.y0 && h->y < box.y1 &&
                   pel_sides_hit(walk_glyph, &v->placed, PEL_NON_ZERO, h->x,
                                 h->y)
               ? PEL_ERROR_RANGE
               : PEL_OK;
}

bool pel_hit_outline_text(const struct pel_outline_text_block *text, int32_t x,
                          int32_t y)
{
    struct hit h = {.visitor = {.take = hit_glyph}, .x = x, .y = y};
    if (!pel_tolerance_legal(text->tolerance))
        return false;
    begin_text(&h.visitor, &h.points, text);
    return visit(&h.visitor) != PEL_OK;
}

/* An em is 256 units at least. */
struct pel_transform pel_outline_transform(
    const struct pel_outline_font_asset *font, int32_t size, int32_t turn,
    struct pel_point at)
{
    return pel_transform_turned(pel_transform_scale(size, font->em), turn, true,
                                at);
}
