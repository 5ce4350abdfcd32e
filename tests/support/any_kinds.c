#include "any_shape.h"
#include "check.h"
#include "core/outline/outline.h"
#include "core/outline/outline_filter.h"
#include "reference.h"
#include "reference_shape.h"

/* The shape as core's structs have it. */
#define POLYGON(s) (&(struct pel_polygon_shape){s->v, s->n, s->rule})
#define ELLIPSE(s) (&(struct pel_ellipse_shape){s->v[0], {s->radius, s->inner}})
#define ROUNDED(s) (&(struct pel_rounded_shape){s->v[0], s->v[1], s->radius})
#define RING(s) (&(struct pel_ring_shape){s->v[0], s->inner, s->radius})
#define SECTOR(s) \
    (&(struct pel_sector_shape){s->v[0], s->radius, s->from, s->to})
#define ARC(s) \
    (&(struct pel_arc_shape){s->v[0], s->inner, s->radius, s->from, s->to})
#define THICK(s) (&(struct pel_thick_line_shape){s->v[0], s->v[1], s->radius})

const char *any_name(const struct any_shape *s)
{
    static const char *const names[ANY_KINDS] = {
        "triangle",          "rectangle", "polygon", "circle", "ellipse",
        "rounded rectangle", "ring",      "sector",  "arc",    "line",
        "thick line"};
    return names[s->kind];
}

static void draw_polygon(const struct pel_surface *surface,
                         const struct any_shape *s,
                         const struct pel_paint *paint)
{
    int32_t scratch[PEL_POLYGON_SCRATCH_SIZE(ANY_POINTS) / 4];
    assert_int_equal(
        pel_polygon(surface, POLYGON(s), paint, scratch, sizeof scratch),
        PEL_OK);
}

void any_draw(const struct pel_surface *surface, const struct any_shape *s,
              const struct pel_paint *paint)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        pel_triangle(surface, s->v, paint);
        break;
    case ANY_RECTANGLE:
        pel_rectangle(surface, s->v[0], s->v[1], paint);
        break;
    case ANY_POLYGON:
        draw_polygon(surface, s, paint);
        break;
    case ANY_CIRCLE:
        pel_circle(surface, s->v[0], s->radius, paint);
        break;
    case ANY_ELLIPSE:
        pel_ellipse(surface, ELLIPSE(s), paint);
        break;
    case ANY_ROUNDED_RECTANGLE:
        pel_rounded_rectangle(surface, ROUNDED(s), paint);
        break;
    case ANY_RING:
        pel_ring(surface, RING(s), paint);
        break;
    case ANY_SECTOR:
        pel_sector(surface, SECTOR(s), paint);
        break;
    case ANY_ARC:
        pel_arc(surface, ARC(s), paint);
        break;
    case ANY_LINE:
        pel_line(surface, s->v[0], s->v[1], paint);
        break;
    default:
        pel_thick_line(surface, THICK(s), paint);
    }
}

bool any_hit(const struct any_shape *s, int32_t x, int32_t y)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        return pel_hit_triangle(s->v, x, y);
    case ANY_RECTANGLE:
        return pel_hit_rectangle(s->v[0], s->v[1], x, y);
    case ANY_POLYGON:
        return pel_hit_polygon(POLYGON(s), x, y);
    case ANY_CIRCLE:
        return pel_hit_circle(s->v[0], s->radius, x, y);
    case ANY_ELLIPSE:
        return pel_hit_ellipse(ELLIPSE(s), x, y);
    case ANY_ROUNDED_RECTANGLE:
        return pel_hit_rounded_rectangle(ROUNDED(s), x, y);
    case ANY_RING:
        return pel_hit_ring(RING(s), x, y);
    case ANY_SECTOR:
        return pel_hit_sector(SECTOR(s), x, y);
    case ANY_ARC:
        return pel_hit_arc(ARC(s), x, y);
    case ANY_LINE:
        return pel_hit_line(s->v[0], s->v[1], x, y);
    default:
        return pel_hit_thick_line(THICK(s), x, y);
    }
}

static bool rectangle_at(const struct any_shape *s, int32_t x, int32_t y)
{
    return x * 256 + 128 >= s->v[0].x && x * 256 + 128 < s->v[1].x &&
           y * 256 + 128 >= s->v[0].y && y * 256 + 128 < s->v[1].y;
}

/* The corners have a test of their own. */
static bool thick_line_at(const struct any_shape *s, int32_t x, int32_t y)
{
    struct pel_point v[4];
    const struct pel_polygon_shape outline = {v, 4, PEL_NON_ZERO};
    return pel_thick_line_corners(THICK(s), v) &&
           reference_polygon_at(&outline, x, y);
}

bool any_reference_at(const struct any_shape *s, int32_t x, int32_t y)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        return reference_triangle_at(s->v, x, y);
    case ANY_RECTANGLE:
        return rectangle_at(s, x, y);
    case ANY_POLYGON:
        return reference_polygon_at(POLYGON(s), x, y);
    case ANY_CIRCLE:
        return reference_disc_at(s->v[0], s->radius, x, y);
    case ANY_ELLIPSE:
        return reference_ellipse_at(ELLIPSE(s), x, y);
    case ANY_ROUNDED_RECTANGLE:
        return reference_rounded_at(ROUNDED(s), x, y);
    case ANY_RING:
        return reference_ring_at(RING(s), x, y);
    case ANY_SECTOR:
        return reference_sector_at(SECTOR(s), x, y);
    case ANY_ARC:
        return reference_arc_at(ARC(s), x, y);
    case ANY_LINE:
        return reference_line_at(s->v[0], s->v[1], x, y);
    default:
        return thick_line_at(s, x, y);
    }
}

static void outline_polygon(const struct pel_surface *surface,
                            const struct any_shape *s,
                            const struct pel_paint *paint)
{
    int32_t scratch[PEL_POLYGON_OUTLINE_SCRATCH_SIZE(ANY_POINTS) / 4];
    assert_int_equal(pel_polygon_outline(surface, POLYGON(s), paint, scratch,
                                         sizeof scratch),
                     PEL_OK);
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

void any_draw_outline(const struct pel_surface *surface,
                      const struct any_shape *s, const struct pel_paint *paint)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        pel_triangle_outline(surface, s->v, paint);
        break;
    case ANY_RECTANGLE:
        pel_rectangle_outline(surface, s->v[0], s->v[1], paint);
        break;
    case ANY_POLYGON:
        outline_polygon(surface, s, paint);
        break;
    case ANY_CIRCLE:
        pel_circle_outline(surface, s->v[0], s->radius, paint);
        break;
    case ANY_ELLIPSE:
        pel_ellipse_outline(surface, ELLIPSE(s), paint);
        break;
    case ANY_ROUNDED_RECTANGLE:
        pel_rounded_rectangle_outline(surface, ROUNDED(s), paint);
        break;
    case ANY_SECTOR:
        pel_arc_outline(surface, SECTOR(s), paint);
        break;
    default:
        outline_rim(surface, s, paint);
    }
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

bool any_fill_expected(const void *s, int32_t x, int32_t y)
{
    const bool covered = any_reference_at(s, x, y);
    if (covered != any_hit(s, x, y))
        fail_msg("%s: hit test of %d, %d: expected %d; %s", any_name(s), x, y,
                 covered, cases_replay());
    return covered;
}

bool any_outline_expected(const void *s, int32_t x, int32_t y)
{
    return any_reference_outline_at(s, x, y);
}
