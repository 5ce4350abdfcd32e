#include "core/outline/outline.h"
#include "core/raster/thick_line.h"
#include "core/round/arc.h"
#include "core/round/ring.h"
#include "sim/script/commands.h"

static struct pel_point point(const int32_t *v)
{
    return (struct pel_point){v[0], v[1]};
}

static struct pel_sector_shape sector(const int32_t *v)
{
    return (struct pel_sector_shape){point(v), v[2], (uint16_t)v[3],
                                     (uint16_t)v[4]};
}

static struct pel_ellipse_shape ellipse(const int32_t *v)
{
    return (struct pel_ellipse_shape){point(v), point(v + 2)};
}

static struct pel_rounded_shape rounded(const int32_t *v)
{
    const struct pel_point to = {v[0] + v[2], v[1] + v[3]};
    return (struct pel_rounded_shape){point(v), to, v[4]};
}

static const char *check_rect(const int32_t *v, size_t n)
{
    (void)n;
    if (v[0] + v[2] > PEL_COORDINATE_MAX || v[1] + v[3] > PEL_COORDINATE_MAX)
        return "the right and the bottom side must lie below 32768";
    return NULL;
}

static const char *check_sector(const int32_t *v, size_t n)
{
    (void)n;
    return v[3] == v[4] ? "FROM and TO are the same angle: circle is the whole"
                        : NULL;
}

static const char *check_arc(const int32_t *v, size_t n)
{
    (void)n;
    return v[4] == v[5] ? "FROM and TO are the same angle: ring is the whole"
                        : NULL;
}

static const char *check_thick(const int32_t *v, size_t n)
{
    (void)n;
    const struct pel_thick_line_shape line = {point(v), point(v + 2), v[4]};
    struct pel_point corner[4];
    return pel_thick_line_corners(&line, corner)
               ? NULL
               : "the ends must keep half the width from -32768 and 32768";
}

static void draw_ring(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_ring_shape ring = {point(v), v[2], v[3]};
    (void)n;
    pel_ring(pen->surface, &ring, script_paint(pen));
}

static void draw_sector(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_sector_shape s = sector(v);
    (void)n;
    pel_sector(pen->surface, &s, script_paint(pen));
}

static void draw_arc(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_arc_shape arc = {point(v), v[2], v[3], (uint16_t)v[4],
                                      (uint16_t)v[5]};
    (void)n;
    pel_arc(pen->surface, &arc, script_paint(pen));
}

static void draw_ellipse(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_ellipse_shape e = ellipse(v);
    (void)n;
    pel_ellipse(pen->surface, &e, script_paint(pen));
}

static void draw_rounded(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_rounded_shape r = rounded(v);
    (void)n;
    pel_rounded_rectangle(pen->surface, &r, script_paint(pen));
}

static void draw_thick(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_thick_line_shape line = {point(v), point(v + 2), v[4]};
    (void)n;
    pel_thick_line(pen->surface, &line, script_paint(pen));
}

static void outline_triangle(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_point p[3] = {point(v), point(v + 2), point(v + 4)};
    (void)n;
    pel_triangle_outline(pen->surface, p, script_paint(pen));
}

static void outline_rect(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_point to = {v[0] + v[2], v[1] + v[3]};
    (void)n;
    pel_rectangle_outline(pen->surface, point(v), to, script_paint(pen));
}

static void outline_rounded(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_rounded_shape r = rounded(v);
    (void)n;
    pel_rounded_rectangle_outline(pen->surface, &r, script_paint(pen));
}

static void outline_circle(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pel_circle_outline(pen->surface, point(v), v[2], script_paint(pen));
}

static void outline_ellipse(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_ellipse_shape e = ellipse(v);
    (void)n;
    pel_ellipse_outline(pen->surface, &e, script_paint(pen));
}

static void outline_arc(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_sector_shape s = sector(v);
    (void)n;
    pel_arc_outline(pen->surface, &s, script_paint(pen));
}

static void outline_polygon(struct script_pen *pen, const int32_t *v, size_t n,
                            enum pel_fill_rule rule)
{
    /* A pel_point is two int32_t, and so is each pair of coordinates. */
    const struct pel_polygon_shape outline = {
        (const struct pel_point *)(const void *)v, (int32_t)(n / 2), rule};
    pel_polygon_outline(pen->surface, &outline, script_paint(pen), pen->scratch,
                        pen->scratch_size);
}

static void outline_evenodd(struct script_pen *pen, const int32_t *v, size_t n)
{
    outline_polygon(pen, v, n, PEL_EVEN_ODD);
}

static void outline_nonzero(struct script_pen *pen, const int32_t *v, size_t n)
{
    outline_polygon(pen, v, n, PEL_NON_ZERO);
}

const struct script_command script_shapes[] = {
    {"ring", "ppll", "CX CY INNER OUTER", SCRIPT_SHAPE, draw_ring, NULL},
    {"sector", "ppltt", "CX CY R FROM TO", SCRIPT_SHAPE, draw_sector,
     check_sector},
    {"arc", "pplltt", "CX CY INNER OUTER FROM TO", SCRIPT_SHAPE, draw_arc,
     check_arc},
    {"ellipse", "ppll", "CX CY RX RY", SCRIPT_SHAPE, draw_ellipse, NULL},
    {"roundrect", "pplll", "X Y WIDTH HEIGHT R", SCRIPT_SHAPE, draw_rounded,
     check_rect},
    {"thickline", "ppppl", "X0 Y0 X1 Y1 WIDTH", SCRIPT_SHAPE, draw_thick,
     check_thick},
    {"outline triangle", "pppppp", "X0 Y0 X1 Y1 X2 Y2", SCRIPT_SHAPE,
     outline_triangle, NULL},
    {"outline rect", "ppll", "X Y WIDTH HEIGHT", SCRIPT_SHAPE, outline_rect,
     check_rect},
    {"outline roundrect", "pplll", "X Y WIDTH HEIGHT R", SCRIPT_SHAPE,
     outline_rounded, check_rect},
    {"outline circle", "ppl", "CX CY R", SCRIPT_SHAPE, outline_circle, NULL},
    {"outline ellipse", "ppll", "CX CY RX RY", SCRIPT_SHAPE, outline_ellipse,
     NULL},
    {"outline arc", "ppltt", "CX CY R FROM TO", SCRIPT_SHAPE, outline_arc,
     check_sector},
    {"outline polygon evenodd", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     outline_evenodd, NULL},
    {"outline polygon nonzero", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     outline_nonzero, NULL},
    {NULL, NULL, NULL, SCRIPT_STATE, NULL, NULL},
};
