/* The canvas, shapes and what clips and bands them. */
#include "core/outline/outline.h"
#include "core/raster/thick_line.h"
#include "core/round/arc.h"
#include "core/round/ring.h"
#include "sim/script/commands.h"

/* A pel_point is two int32_t, and so is each pair of coordinates. */
static const struct pel_point *points(const int32_t *v)
{
    return (const struct pel_point *)(const void *)v;
}

static struct pel_point far_corner(const int32_t *v)
{
    return (struct pel_point){v[0] + v[2], v[1] + v[3]};
}

static struct pel_thick_line_shape thick_line(const int32_t *v)
{
    return (struct pel_thick_line_shape){points(v)[0], points(v)[1], v[4]};
}

static const char *check_rect(const int32_t *v, size_t n)
{
    (void)n;
    if (v[0] + v[2] > PEL_COORDINATE_MAX || v[1] + v[3] > PEL_COORDINATE_MAX)
        return "expected a right and a bottom side below 32768";
    return NULL;
}

/* FROM and TO are the last. Angles of 0 and 1 are the same, and the whole turn
 * from 0 to 1. */
static const char *check_turns(const int32_t *v, size_t n)
{
    const int32_t from = v[n - 2], to = v[n - 1];
    return to <= from && !((from - to) & 65535)
               ? "FROM and TO are the same angle: 0 1 is the whole turn"
               : NULL;
}

static const char *check_thick(const int32_t *v, size_t n)
{
    (void)n;
    const struct pel_thick_line_shape line = thick_line(v);
    struct pel_point corner[4];
    return pel_thick_line_corners(&line, corner)
               ? NULL
               : "expected ends half the width away from -32768 and 32768";
}

static void draw_clear(struct script_pen *pen, const int32_t *v)
{
    pel_clear(pen->surface, (pel_color)v[0]);
}

static void set_clip(struct script_pen *pen, const int32_t *v)
{
    pen->clip = (struct pel_rect){v[0], v[1], v[0] + v[2], v[1] + v[3]};
    pel_surface_clip(pen->surface, &pen->clip);
}

/* The function that fills a shape, or its smooth twin. */
#define FILL(pen, name) ((pen)->smooth ? pel_smooth_##name : pel_##name)

/* The functions below draw a shape or, as the row of the table says, its
 * outline. */

static bool outlined(const struct script_pen *pen)
{
    return pen->item->command->outline;
}

static void draw_triangle(struct script_pen *pen, const int32_t *v)
{
    const bool or_line = pen->collinear_line && !pen->smooth;
    (outlined(pen) ? pel_triangle_outline
     : or_line
         ? pel_triangle_or_line
         : FILL(pen, triangle))(pen->surface, points(v), script_paint(pen));
}

/* Cannot fail: vertices and scratch memory were checked before. */
static void draw_polygon(struct script_pen *pen, const int32_t *v)
{
    const struct pel_polygon_shape shape = {
        points(v), (int32_t)(pen->item->count / 2), pen->item->command->rule};
    (outlined(pen) ? pel_polygon_outline : FILL(pen, polygon))(
        pen->surface, &shape, script_paint(pen), pen->scratch,
        pen->scratch_size);
}

static void draw_circle(struct script_pen *pen, const int32_t *v)
{
    (outlined(pen) ? pel_circle_outline : FILL(pen, circle))(
        pen->surface, *points(v), v[2], script_paint(pen));
}

static void draw_rect(struct script_pen *pen, const int32_t *v)
{
    (outlined(pen) ? pel_rectangle_outline : FILL(pen, rectangle))(
        pen->surface, *points(v), far_corner(v), script_paint(pen));
}

static void draw_ellipse(struct script_pen *pen, const int32_t *v)
{
    const struct pel_ellipse_shape shape = {points(v)[0], points(v)[1]};
    (outlined(pen) ? pel_ellipse_outline : FILL(pen, ellipse))(
        pen->surface, &shape, script_paint(pen));
}

static void draw_rounded(struct script_pen *pen, const int32_t *v)
{
    const struct pel_rounded_shape shape = {*points(v), far_corner(v), v[4]};
    (outlined(pen) ? pel_rounded_rectangle_outline
                   : FILL(pen, rounded_rectangle))(pen->surface, &shape,
                                                   script_paint(pen));
}

/* The outline of a sector's round side is called an arc. */
static void draw_sector(struct script_pen *pen, const int32_t *v)
{
    const struct pel_sector_shape shape = {*points(v), v[2], v[3], v[4]};
    (outlined(pen) ? pel_arc_outline : FILL(pen, sector))(pen->surface, &shape,
                                                          script_paint(pen));
}

static void draw_line(struct script_pen *pen, const int32_t *v)
{
    pel_line(pen->surface, points(v)[0], points(v)[1], script_paint(pen));
}

static void draw_ring(struct script_pen *pen, const int32_t *v)
{
    const struct pel_ring_shape ring = {*points(v), v[2], v[3]};
    FILL(pen, ring)(pen->surface, &ring, script_paint(pen));
}

static void draw_arc(struct script_pen *pen, const int32_t *v)
{
    const struct pel_arc_shape arc = {*points(v), v[2], v[3], v[4], v[5]};
    FILL(pen, arc)(pen->surface, &arc, script_paint(pen));
}

static void draw_thick(struct script_pen *pen, const int32_t *v)
{
    const struct pel_thick_line_shape line = thick_line(v);
    FILL(pen, thick_line)(pen->surface, &line, script_paint(pen));
}

const struct script_command script_shapes[] = {
    {"canvas", "ssf", "WIDTH HEIGHT FORMAT", .role = SCRIPT_CANVAS},
    {"clear", "c", "COLOUR", SCRIPT_CLEAR, .draw = draw_clear},
    {"clip", "iinn", "X Y WIDTH HEIGHT", SCRIPT_STATE, .draw = set_clip},
    {"bands", "n", "ROWS", .role = SCRIPT_BANDS},
    {"option collinear", "o", "nothing|line", SCRIPT_STATE,
     SCRIPT_SETTING(struct script_pen, collinear_line, 1)},
    {"option smooth", "o", "off|on", SCRIPT_STATE,
     SCRIPT_SETTING(struct script_pen, smooth, 1)},
    {"triangle", "pppppp", "X0 Y0 X1 Y1 X2 Y2", SCRIPT_TRIANGLE,
     .draw = draw_triangle, .form = FORM_TRIANGLE},
    {"polygon evenodd", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_polygon, .form = FORM_POLYGON, .rule = PEL_EVEN_ODD},
    {"polygon nonzero", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_polygon, .form = FORM_POLYGON, .rule = PEL_NON_ZERO},
    {"circle", "ppl", "CX CY R", SCRIPT_SHAPE, .draw = draw_circle,
     .form = FORM_ROUND},
    {"rect", "ppll", "X Y WIDTH HEIGHT", SCRIPT_SHAPE, .draw = draw_rect,
     .form = FORM_RECTANGLE, .check = check_rect},
    {"line", "pppp", "X0 Y0 X1 Y1", SCRIPT_SHAPE, .draw = draw_line,
     .form = FORM_LINE},
    {"ring", "ppll", "CX CY INNER OUTER", SCRIPT_SHAPE, .draw = draw_ring,
     .form = FORM_ROUND},
    {"sector", "ppltt", "CX CY R FROM TO", SCRIPT_SHAPE, .draw = draw_sector,
     .form = FORM_ROUND, .check = check_turns},
    {"arc", "pplltt", "CX CY INNER OUTER FROM TO", SCRIPT_SHAPE,
     .draw = draw_arc, .form = FORM_ROUND, .check = check_turns},
    {"ellipse", "ppll", "CX CY RX RY", SCRIPT_SHAPE, .draw = draw_ellipse,
     .form = FORM_ELLIPSE},
    {"roundrect", "pplll", "X Y WIDTH HEIGHT R", SCRIPT_SHAPE,
     .draw = draw_rounded, .form = FORM_RECTANGLE, .check = check_rect},
    {"thickline", "ppppl", "X0 Y0 X1 Y1 WIDTH", SCRIPT_SHAPE,
     .draw = draw_thick, .form = FORM_THICK_LINE, .check = check_thick},
    {"outline triangle", "pppppp", "X0 Y0 X1 Y1 X2 Y2", SCRIPT_SHAPE,
     .draw = draw_triangle, .form = FORM_TRIANGLE, .outline = true},
    {"outline rect", "ppll", "X Y WIDTH HEIGHT", SCRIPT_SHAPE,
     .draw = draw_rect, .form = FORM_RECTANGLE, .check = check_rect,
     .outline = true},
    {"outline roundrect", "pplll", "X Y WIDTH HEIGHT R", SCRIPT_SHAPE,
     .draw = draw_rounded, .form = FORM_RECTANGLE, .check = check_rect,
     .outline = true},
    {"outline circle", "ppl", "CX CY R", SCRIPT_SHAPE, .draw = draw_circle,
     .form = FORM_ROUND, .outline = true},
    {"outline ellipse", "ppll", "CX CY RX RY", SCRIPT_SHAPE,
     .draw = draw_ellipse, .form = FORM_ELLIPSE, .outline = true},
    {"outline arc", "ppltt", "CX CY R FROM TO", SCRIPT_SHAPE,
     .draw = draw_sector, .form = FORM_ROUND, .check = check_turns,
     .outline = true},
    {"outline polygon evenodd", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_polygon, .form = FORM_POLYGON, .rule = PEL_EVEN_ODD,
     .outline = true},
    {"outline polygon nonzero", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_polygon, .form = FORM_POLYGON, .rule = PEL_NON_ZERO,
     .outline = true},
    {.next = script_strokes},
};
