#include <stdlib.h>

#include "api.h"

enum { POINTS = 12 };

/* Numbers for any shape. */
struct shape {
    struct pel_point v[POINTS];
    int32_t n, radius, inner;
    int32_t from, to;
    enum pel_fill_rule rule;
    pel_color color[3];
};

static void shape_take(struct api *a, struct shape *s)
{
    s->n = (int32_t)input_below(&a->in, POINTS + 1);
    for (int i = 0; i < POINTS; i++)
        s->v[i] = i < 3 || i < s->n ? api_point(a) : s->v[i - 1];
    s->radius = input_number(&a->in);
    s->inner = input_number(&a->in);
    s->from = input_number(&a->in);
    s->to = input_number(&a->in);
    s->rule = input_byte(&a->in) & 1 ? PEL_NON_ZERO : PEL_EVEN_ODD;
    for (int i = 0; i < 3; i++)
        s->color[i] = input_word(&a->in);
}

/* With exactly the scratch memory that is asked for. */
static void draw_polygon(const struct pel_surface *surface,
                         const struct shape *s, bool outline,
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

static void draw_straight(const struct pel_surface *surface,
                          const struct shape *s, uint32_t kind,
                          const struct pel_paint *paint)
{
    const struct pel_point *const v = s->v;
    const struct pel_rect box = {s->v[0].x, s->v[0].y, s->v[1].x, s->v[1].y};
    const struct pel_thick_line_shape thick = {s->v[0], s->v[1], s->radius};
    switch (kind % 8) {
    case 0:
        pel_triangle(surface, v, paint);
        break;
    case 1:
        pel_triangle_or_line(surface, v, paint);
        break;
    case 2:
        pel_triangle_gouraud(surface, v, s->color);
        break;
    case 3:
        pel_line(surface, v[0], v[1], paint);
        break;
    case 4:
        pel_thick_line(surface, &thick, paint);
        break;
    case 5:
        pel_rectangle(surface, v[0], v[1], paint);
        break;
    case 6:
        pel_box(surface, &box, paint);
        break;
    default:
        draw_polygon(surface, s, false, paint);
        break;
    }
}

static void draw_round(const struct pel_surface *surface, const struct shape *s,
                       uint32_t kind, const struct pel_paint *paint)
{
    const struct pel_ring_shape ring = {s->v[0], s->inner, s->radius};
    const struct pel_sector_shape sector = {s->v[0], s->radius, s->from, s->to};
    const struct pel_arc_shape arc = {s->v[0], s->inner, s->radius, s->from,
                                      s->to};
    const struct pel_ellipse_shape ellipse = {s->v[0], {s->radius, s->inner}};
    const struct pel_rounded_shape rounded = {s->v[0], s->v[1], s->radius};
    switch (kind % 6) {
    case 0:
        pel_circle(surface, s->v[0], s->radius, paint);
        break;
    case 1:
        pel_ring(surface, &ring, paint);
        break;
    case 2:
        pel_sector(surface, &sector, paint);
        break;
    case 3:
        pel_arc(surface, &arc, paint);
        break;
    case 4:
        pel_ellipse(surface, &ellipse, paint);
        break;
    default:
        pel_rounded_rectangle(surface, &rounded, paint);
        break;
    }
}

static void draw_outline(const struct pel_surface *surface,
                         const struct shape *s, uint32_t kind,
                         const struct pel_paint *paint)
{
    const struct pel_sector_shape sector = {s->v[0], s->radius, s->from, s->to};
    const struct pel_ellipse_shape ellipse = {s->v[0], {s->radius, s->inner}};
    const struct pel_rounded_shape rounded = {s->v[0], s->v[1], s->radius};
    switch (kind % 7) {
    case 0:
        pel_triangle_outline(surface, s->v, paint);
        break;
    case 1:
        pel_rectangle_outline(surface, s->v[0], s->v[1], paint);
        break;
    case 2:
        pel_rounded_rectangle_outline(surface, &rounded, paint);
        break;
    case 3:
        pel_circle_outline(surface, s->v[0], s->radius, paint);
        break;
    case 4:
        pel_ellipse_outline(surface, &ellipse, paint);
        break;
    case 5:
        pel_arc_outline(surface, &sector, paint);
        break;
    default:
        draw_polygon(surface, s, true, paint);
        break;
    }
}

static void draw(const struct pel_surface *surface, const struct shape *s,
                 uint32_t kind, const struct pel_paint *paint)
{
    if (kind % 4 == 0)
        draw_outline(surface, s, kind / 4, paint);
    else if (kind % 4 == 1)
        draw_round(surface, s, kind / 4, paint);
    else
        draw_straight(surface, s, kind / 4, paint);
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
    struct shape s;
    const int32_t x = input_number(&a->in), y = input_number(&a->in);
    shape_take(a, &s);
    const struct pel_polygon_shape polygon = {s.v, s.n, s.rule};
    const struct pel_ring_shape ring = {s.v[0], s.inner, s.radius};
    const struct pel_sector_shape sector = {s.v[0], s.radius, s.from, s.to};
    const struct pel_arc_shape arc = {s.v[0], s.inner, s.radius, s.from, s.to};
    const struct pel_ellipse_shape ellipse = {s.v[0], {s.radius, s.inner}};
    const struct pel_rounded_shape rounded = {s.v[0], s.v[1], s.radius};
    const struct pel_thick_line_shape thick = {s.v[0], s.v[1], s.radius};
    const struct pel_target target = {target_hit,
                                      {s.v[0].x, s.v[0].y, s.v[1].x, s.v[1].y}};
    const struct pel_target *const list[] = {&target, &target};
    pel_hit_triangle(s.v, x, y);
    pel_hit_rectangle(s.v[0], s.v[1], x, y);
    pel_hit_circle(s.v[0], s.radius, x, y);
    pel_hit_line(s.v[0], s.v[1], x, y);
    pel_hit_polygon(&polygon, x, y);
    pel_hit_ring(&ring, x, y);
    pel_hit_sector(&sector, x, y);
    pel_hit_arc(&arc, x, y);
    pel_hit_ellipse(&ellipse, x, y);
    pel_hit_rounded_rectangle(&rounded, x, y);
    pel_hit_thick_line(&thick, x, y);
    pel_hit_topmost(list, s.inner > 2 ? 2 : s.inner, x, y);
    pel_hsv(s.from, s.color[0] & 255, s.color[1] & 255);
    pel_hsv_degrees(s.to, s.color[0] & 255, s.color[1] & 255);
    pel_turn_of(s.from % (1 << 25), s.to % (1 << 25));
}
