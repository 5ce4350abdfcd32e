#include "any_shape.h"
#include "check.h"
#include "core/outline/outline.h"
#include "core/outline/outline_filter.h"
#include "reference.h"
#include "reference_shape.h"

typedef void draw_function(const struct pel_surface *surface,
                           const struct any_shape *s,
                           const struct pel_paint *paint);
typedef bool at_function(const struct any_shape *s, int32_t x, int32_t y);

static void draw_triangle(const struct pel_surface *surface,
                          const struct any_shape *s,
                          const struct pel_paint *paint)
{
    pel_triangle(surface, s->v, paint);
}

static bool hit_triangle(const struct any_shape *s, int32_t x, int32_t y)
{
    return pel_hit_triangle(s->v, x, y);
}

static bool triangle_at(const struct any_shape *s, int32_t x, int32_t y)
{
    return reference_triangle_at(s->v, x, y);
}

static void outline_triangle(const struct pel_surface *surface,
                             const struct any_shape *s,
                             const struct pel_paint *paint)
{
    pel_triangle_outline(surface, s->v, paint);
}

static void draw_rectangle(const struct pel_surface *surface,
                           const struct any_shape *s,
                           const struct pel_paint *paint)
{
    pel_rectangle(surface, s->v[0], s->v[1], paint);
}

static bool hit_rectangle(const struct any_shape *s, int32_t x, int32_t y)
{
    return pel_hit_rectangle(s->v[0], s->v[1], x, y);
}

static bool rectangle_at(const struct any_shape *s, int32_t x, int32_t y)
{
    return x * 256 + 128 >= s->v[0].x && x * 256 + 128 < s->v[1].x &&
           y * 256 + 128 >= s->v[0].y && y * 256 + 128 < s->v[1].y;
}

static void outline_rectangle(const struct pel_surface *surface,
                              const struct any_shape *s,
                              const struct pel_paint *paint)
{
    pel_rectangle_outline(surface, s->v[0], s->v[1], paint);
}

static void draw_polygon(const struct pel_surface *surface,
                         const struct any_shape *s,
                         const struct pel_paint *paint)
{
    const struct pel_polygon_shape p = {s->v, s->n, s->rule};
    int32_t scratch[PEL_POLYGON_SCRATCH_SIZE(ANY_POINTS) / 4];
    assert_int_equal(pel_polygon(surface, &p, paint, scratch, sizeof scratch),
                     PEL_OK);
}

static bool hit_polygon(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_polygon_shape p = {s->v, s->n, s->rule};
    return pel_hit_polygon(&p, x, y);
}

static bool polygon_at(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_polygon_shape p = {s->v, s->n, s->rule};
    return reference_polygon_at(&p, x, y);
}

static void outline_polygon(const struct pel_surface *surface,
                            const struct any_shape *s,
                            const struct pel_paint *paint)
{
    const struct pel_polygon_shape p = {s->v, s->n, s->rule};
    int32_t scratch[PEL_POLYGON_OUTLINE_SCRATCH_SIZE(ANY_POINTS) / 4];
    assert_int_equal(
        pel_polygon_outline(surface, &p, paint, scratch, sizeof scratch),
        PEL_OK);
}

static void draw_circle(const struct pel_surface *surface,
                        const struct any_shape *s,
                        const struct pel_paint *paint)
{
    pel_circle(surface, s->v[0], s->radius, paint);
}

static bool hit_circle(const struct any_shape *s, int32_t x, int32_t y)
{
    return pel_hit_circle(s->v[0], s->radius, x, y);
}

static bool circle_at(const struct any_shape *s, int32_t x, int32_t y)
{
    return reference_disc_at(s->v[0], s->radius, x, y);
}

static void outline_circle(const struct pel_surface *surface,
                           const struct any_shape *s,
                           const struct pel_paint *paint)
{
    pel_circle_outline(surface, s->v[0], s->radius, paint);
}

static void draw_ellipse(const struct pel_surface *surface,
                         const struct any_shape *s,
                         const struct pel_paint *paint)
{
    const struct pel_ellipse_shape e = {s->v[0], {s->radius, s->inner}};
    pel_ellipse(surface, &e, paint);
}

static bool hit_ellipse(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_ellipse_shape e = {s->v[0], {s->radius, s->inner}};
    return pel_hit_ellipse(&e, x, y);
}

static bool ellipse_at(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_ellipse_shape e = {s->v[0], {s->radius, s->inner}};
    return reference_ellipse_at(&e, x, y);
}

static void outline_ellipse(const struct pel_surface *surface,
                            const struct any_shape *s,
                            const struct pel_paint *paint)
{
    const struct pel_ellipse_shape e = {s->v[0], {s->radius, s->inner}};
    pel_ellipse_outline(surface, &e, paint);
}

static void draw_rounded(const struct pel_surface *surface,
                         const struct any_shape *s,
                         const struct pel_paint *paint)
{
    const struct pel_rounded_shape r = {s->v[0], s->v[1], s->radius};
    pel_rounded_rectangle(surface, &r, paint);
}

static bool hit_rounded(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_rounded_shape r = {s->v[0], s->v[1], s->radius};
    return pel_hit_rounded_rectangle(&r, x, y);
}

static bool rounded_at(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_rounded_shape r = {s->v[0], s->v[1], s->radius};
    return reference_rounded_at(&r, x, y);
}

static void outline_rounded(const struct pel_surface *surface,
                            const struct any_shape *s,
                            const struct pel_paint *paint)
{
    const struct pel_rounded_shape r = {s->v[0], s->v[1], s->radius};
    pel_rounded_rectangle_outline(surface, &r, paint);
}

static void draw_ring(const struct pel_surface *surface,
                      const struct any_shape *s, const struct pel_paint *paint)
{
    const struct pel_ring_shape r = {s->v[0], s->inner, s->radius};
    pel_ring(surface, &r, paint);
}

static bool hit_ring(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_ring_shape r = {s->v[0], s->inner, s->radius};
    return pel_hit_ring(&r, x, y);
}

static bool ring_at(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_ring_shape r = {s->v[0], s->inner, s->radius};
    return reference_ring_at(&r, x, y);
}

static void draw_sector(const struct pel_surface *surface,
                        const struct any_shape *s,
                        const struct pel_paint *paint)
{
    const struct pel_sector_shape a = {s->v[0], s->radius, s->from, s->to};
    pel_sector(surface, &a, paint);
}

static bool hit_sector(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_sector_shape a = {s->v[0], s->radius, s->from, s->to};
    return pel_hit_sector(&a, x, y);
}

static bool sector_at(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_sector_shape a = {s->v[0], s->radius, s->from, s->to};
    return reference_sector_at(&a, x, y);
}

static void outline_sector(const struct pel_surface *surface,
                           const struct any_shape *s,
                           const struct pel_paint *paint)
{
    const struct pel_sector_shape a = {s->v[0], s->radius, s->from, s->to};
    pel_arc_outline(surface, &a, paint);
}

static void draw_arc(const struct pel_surface *surface,
                     const struct any_shape *s, const struct pel_paint *paint)
{
    const struct pel_arc_shape a = {s->v[0], s->inner, s->radius, s->from,
                                    s->to};
    pel_arc(surface, &a, paint);
}

static bool hit_arc(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_arc_shape a = {s->v[0], s->inner, s->radius, s->from,
                                    s->to};
    return pel_hit_arc(&a, x, y);
}

static bool arc_at(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_arc_shape a = {s->v[0], s->inner, s->radius, s->from,
                                    s->to};
    return reference_arc_at(&a, x, y);
}

static void draw_line(const struct pel_surface *surface,
                      const struct any_shape *s, const struct pel_paint *paint)
{
    pel_line(surface, s->v[0], s->v[1], paint);
}

static bool hit_line(const struct any_shape *s, int32_t x, int32_t y)
{
    return pel_hit_line(s->v[0], s->v[1], x, y);
}

static bool line_at(const struct any_shape *s, int32_t x, int32_t y)
{
    return reference_line_at(s->v[0], s->v[1], x, y);
}

static void draw_thick_line(const struct pel_surface *surface,
                            const struct any_shape *s,
                            const struct pel_paint *paint)
{
    const struct pel_thick_line_shape t = {s->v[0], s->v[1], s->radius};
    pel_thick_line(surface, &t, paint);
}

static bool hit_thick_line(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_thick_line_shape t = {s->v[0], s->v[1], s->radius};
    return pel_hit_thick_line(&t, x, y);
}

/* The corners have a test of their own. */
static bool thick_line_at(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_thick_line_shape t = {s->v[0], s->v[1], s->radius};
    struct pel_point v[4];
    const struct pel_polygon_shape outline = {v, 4, PEL_NON_ZERO};
    return pel_thick_line_corners(&t, v) &&
           reference_polygon_at(&outline, x, y);
}

/* Shapes that have no outline function: by the filter. */
static void outline_rim(const struct pel_surface *surface,
                        const struct any_shape *s,
                        const struct pel_paint *paint)
{
    struct pel_span memory[PEL_OUTLINE_FILTER_SPANS(3)];
    struct pel_outline_filter filter;
    if (!pel_outline_filter_begin(&filter, surface, paint, memory,
                                  PEL_OUTLINE_FILTER_SPANS(3)))
        return;
    any_draw(&filter.surface, s, &filter.paint);
    pel_outline_filter_end(&filter);
}

static const struct {
    const char *name;
    draw_function *draw;
    at_function *hit, *reference;
    draw_function *outline;
} kinds[ANY_KINDS] = {
    {"triangle", draw_triangle, hit_triangle, triangle_at, outline_triangle},
    {"rectangle", draw_rectangle, hit_rectangle, rectangle_at,
     outline_rectangle},
    {"polygon", draw_polygon, hit_polygon, polygon_at, outline_polygon},
    {"circle", draw_circle, hit_circle, circle_at, outline_circle},
    {"ellipse", draw_ellipse, hit_ellipse, ellipse_at, outline_ellipse},
    {"rounded rectangle", draw_rounded, hit_rounded, rounded_at,
     outline_rounded},
    {"ring", draw_ring, hit_ring, ring_at, outline_rim},
    {"sector", draw_sector, hit_sector, sector_at, outline_sector},
    {"arc", draw_arc, hit_arc, arc_at, outline_rim},
    {"line", draw_line, hit_line, line_at, outline_rim},
    {"thick line", draw_thick_line, hit_thick_line, thick_line_at, outline_rim},
};

const char *any_name(const struct any_shape *s)
{
    return kinds[s->kind].name;
}

void any_draw(const struct pel_surface *surface, const struct any_shape *s,
              const struct pel_paint *paint)
{
    kinds[s->kind].draw(surface, s, paint);
}

bool any_hit(const struct any_shape *s, int32_t x, int32_t y)
{
    return kinds[s->kind].hit(s, x, y);
}

bool any_reference_at(const struct any_shape *s, int32_t x, int32_t y)
{
    return kinds[s->kind].reference(s, x, y);
}

void any_draw_outline(const struct pel_surface *surface,
                      const struct any_shape *s, const struct pel_paint *paint)
{
    kinds[s->kind].outline(surface, s, paint);
}

bool any_reference_outline_at(const struct any_shape *s, int32_t x, int32_t y)
{
    struct any_shape whole = *s;
    if (!any_reference_at(s, x, y))
        return false;
    if (s->kind == ANY_SECTOR)
        whole.kind = ANY_CIRCLE;
    return !any_reference_at(&whole, x - 1, y) ||
           !any_reference_at(&whole, x + 1, y) ||
           !any_reference_at(&whole, x, y - 1) ||
           !any_reference_at(&whole, x, y + 1);
}
