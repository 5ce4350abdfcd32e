#include <stdlib.h>

#include "api.h"
#include "tests/support/any_shape.h"

/* Numbers for any shape. */
struct shape {
    struct any_shape any;
    pel_color color[3];
};

static void shape_take(struct api *a, struct shape *shape)
{
    struct any_shape *s = &shape->any;
    s->n = (int32_t)input_below(&a->in, ANY_POINTS + 1);
    for (int i = 0; i < ANY_POINTS; i++)
        s->v[i] = i < 3 || i < s->n ? api_point(a) : s->v[i - 1];
    s->radius = input_number(&a->in);
    s->inner = input_number(&a->in);
    s->from = input_number(&a->in);
    s->to = input_number(&a->in);
    s->rule = input_byte(&a->in) & 1 ? PEL_NON_ZERO : PEL_EVEN_ODD;
    for (int i = 0; i < 3; i++)
        shape->color[i] = input_word(&a->in);
}

static struct pel_rect box_of(const struct any_shape *s)
{
    return (struct pel_rect){s->v[0].x, s->v[0].y, s->v[1].x, s->v[1].y};
}

/* With exactly the scratch memory that is asked for. */
static void draw_polygon(const struct pel_surface *surface,
                         const struct any_shape *s, bool outline,
                         const struct pel_paint *paint)
{
    const struct pel_polygon_shape polygon = {s->v, s->n, s->rule};
    const size_t size = outline ? pel_polygon_outline_scratch_size(s->n)
                                : pel_polygon_scratch_size(s->n);
    void *scratch = malloc(size + 1);
    (outline ? pel_polygon_outline : pel_polygon)(surface, &polygon, paint,
                                                  scratch, size);
    free(scratch);
}

static void draw_kind(const struct pel_surface *surface, struct any_shape s,
                      enum any_kind kind, bool outline,
                      const struct pel_paint *paint)
{
    s.kind = kind;
    if (kind == ANY_POLYGON)
        draw_polygon(surface, &s, outline, paint);
    else
        (outline ? any_draw_outline : any_draw)(surface, &s, paint);
}

/* Or a convex polygon, which it need not be. Paths are drawn in api_paths.c, in
 * little memory: in much of it dashes that all share columns take minutes. */
static void draw_smooth(const struct pel_surface *surface,
                        const struct shape *s, uint32_t kind,
                        const struct pel_paint *paint)
{
    struct any_shape any = s->any;
    any.kind = (enum any_kind)(kind % ANY_PATH);
    if (!any_draw_smooth(surface, &any, paint))
        pel_smooth_convex(surface, any.v, any.n, paint);
}

static void draw_straight(const struct pel_surface *surface,
                          const struct shape *s, uint32_t kind,
                          const struct pel_paint *paint)
{
    static const enum any_kind kinds[8] = {
        ANY_TRIANGLE,   ANY_KINDS,     ANY_KINDS, ANY_LINE,
        ANY_THICK_LINE, ANY_RECTANGLE, ANY_KINDS, ANY_POLYGON};
    const struct pel_rect box = box_of(&s->any);
    if (kind == 1)
        pel_triangle_or_line(surface, s->any.v, paint);
    else if (kind == 2)
        pel_triangle_gouraud(surface, s->any.v, s->color);
    else if (kind == 6)
        pel_box(surface, &box, paint);
    else
        draw_kind(surface, s->any, kinds[kind], false, paint);
}

static void draw(const struct pel_surface *surface, const struct shape *s,
                 uint32_t kind, const struct pel_paint *paint)
{
    static const enum any_kind round[6] = {ANY_CIRCLE,  ANY_RING,
                                           ANY_SECTOR,  ANY_ARC,
                                           ANY_ELLIPSE, ANY_ROUNDED_RECTANGLE};
    static const enum any_kind outlines[7] = {
        ANY_TRIANGLE, ANY_RECTANGLE, ANY_ROUNDED_RECTANGLE,
        ANY_CIRCLE,   ANY_ELLIPSE,   ANY_SECTOR,
        ANY_POLYGON};
    if (kind % 4 == 0)
        draw_kind(surface, s->any, outlines[kind / 4 % 7], true, paint);
    else if (kind % 4 == 1)
        draw_kind(surface, s->any, round[kind / 4 % 6], false, paint);
    else
        draw_straight(surface, s, kind / 4 % 8, paint);
}

/* With the rim's own paint: not Gouraud's triangle, and no outline. Polygons
 * may have more runs in a row: those are left out. */
static void draw_rim(const struct pel_surface *surface, const struct shape *s,
                     uint32_t kind, const struct pel_paint *paint)
{
    struct pel_span memory[PEL_OUTLINE_FILTER_SPANS(3)];
    struct pel_outline_filter filter;
    if (!pel_outline_filter_begin(&filter, surface, paint, memory,
                                  PEL_OUTLINE_FILTER_SPANS(3)))
        return;
    draw(&filter.surface, s, kind, &filter.paint);
    pel_outline_filter_end(&filter);
}

void api_shape(struct api *a, const struct pel_surface *surface,
               const struct pel_paint *paint)
{
    const uint32_t how = input_byte(&a->in), kind = input_byte(&a->in);
    struct pel_dirty dirty;
    struct shape s;
    shape_take(a, &s);
    pel_dirty_begin(&dirty, how & 1 ? paint : NULL);
    if (how % 16 == 0)
        pel_clear(surface, s.color[0]);
    else if (how % 16 < 4)
        draw(surface, &s, kind, &dirty.paint);
    else if (how % 16 < 6)
        draw_rim(surface, &s, kind & 8 ? kind | 17 : kind | 1, paint);
    else if (how % 16 < 10)
        draw_smooth(surface, &s, kind, how & 16 ? paint : &dirty.paint);
    else
        draw(surface, &s, kind, paint);
}

static bool target_hit(const struct pel_target *target, int32_t x, int32_t y)
{
    (void)target;
    return (x ^ y) & 1;
}

void api_hit(struct api *a)
{
    struct shape shape;
    struct any_shape *s = &shape.any;
    const int32_t x = input_number(&a->in), y = input_number(&a->in);
    shape_take(a, &shape);
    const struct pel_target target = {target_hit, box_of(s)};
    const struct pel_target *const list[] = {&target, &target};
    for (int kind = 0; kind < ANY_KINDS; kind++) {
        s->kind = (enum any_kind)kind;
        any_hit(s, x, y);
    }
    pel_hit_topmost(list, s->inner > 2 ? 2 : s->inner, x, y);
    pel_hsv(s->from, shape.color[0] & 255, shape.color[1] & 255);
    pel_hsv_degrees(s->to, shape.color[0] & 255, shape.color[1] & 255);
    pel_turn_of(s->from % (1 << 25), s->to % (1 << 25));
}
