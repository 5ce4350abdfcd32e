#include "sim/script/commands.h"

static const struct pel_point *points(const int32_t *v)
{
    /* A pel_point is two int32_t, and so is each pair of coordinates. */
    return (const struct pel_point *)(const void *)v;
}

static void draw_clear(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pel_clear(pen->surface, (pel_color)v[0]);
}

static void set_clip(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pen->clip.x0 = v[0];
    pen->clip.y0 = v[1];
    pen->clip.x1 = v[0] + v[2];
    pen->clip.y1 = v[1] + v[3];
    pel_surface_clip(pen->surface, &pen->clip);
}

static void set_collinear_line(struct script_pen *pen, const int32_t *v,
                               size_t n)
{
    (void)v;
    (void)n;
    pen->collinear_line = true;
}

static void set_collinear_nothing(struct script_pen *pen, const int32_t *v,
                                  size_t n)
{
    (void)v;
    (void)n;
    pen->collinear_line = false;
}

static void set_flat(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pen->flat.color = (pel_color)v[0];
    pen->make = NULL;
    pen->by_vertex = false;
}

static void set_vertex(struct script_pen *pen, const int32_t *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        pen->corner[i] = (pel_color)v[i];
    pen->by_vertex = true;
}

static void draw_triangle(struct script_pen *pen, const int32_t *v, size_t n)
{
    struct pel_gouraud gouraud;
    const struct pel_paint *paint = script_paint(pen);
    (void)n;
    if (pen->by_vertex) {
        pel_gouraud_init(&gouraud, points(v), pen->corner);
        paint = script_dithered(pen, &gouraud.paint);
    }
    if (pen->collinear_line)
        pel_triangle_or_line(pen->surface, points(v), paint);
    else
        pel_triangle(pen->surface, points(v), paint);
}

static void draw_polygon(struct script_pen *pen, const int32_t *v, size_t n,
                         enum pel_fill_rule rule)
{
    const struct pel_polygon_shape outline = {points(v), (int32_t)(n / 2),
                                              rule};
    /* Cannot fail: vertices and scratch memory were checked before. */
    pel_polygon(pen->surface, &outline, script_paint(pen), pen->scratch,
                pen->scratch_size);
}

static void draw_evenodd(struct script_pen *pen, const int32_t *v, size_t n)
{
    draw_polygon(pen, v, n, PEL_EVEN_ODD);
}

static void draw_nonzero(struct script_pen *pen, const int32_t *v, size_t n)
{
    draw_polygon(pen, v, n, PEL_NON_ZERO);
}

static void draw_circle(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pel_circle(pen->surface, points(v)[0], v[2], script_paint(pen));
}

static const char *check_rect(const int32_t *v, size_t n)
{
    (void)n;
    if (v[0] + v[2] > PEL_COORDINATE_MAX || v[1] + v[3] > PEL_COORDINATE_MAX)
        return "the right and the bottom side must lie below 32768";
    return NULL;
}

static void draw_rect(struct script_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_point to = {v[0] + v[2], v[1] + v[3]};
    (void)n;
    pel_rectangle(pen->surface, points(v)[0], to, script_paint(pen));
}

static void draw_line(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pel_line(pen->surface, points(v)[0], points(v)[1], script_paint(pen));
}

const struct script_command script_commands[] = {
    {"canvas", "ssf", "WIDTH HEIGHT FORMAT", SCRIPT_CANVAS, NULL, NULL},
    {"clear", "c", "COLOUR", SCRIPT_STATE, draw_clear, NULL},
    {"clip", "iinn", "X Y WIDTH HEIGHT", SCRIPT_STATE, set_clip, NULL},
    {"bands", "n", "ROWS", SCRIPT_BANDS, NULL, NULL},
    {"option collinear line", "", "", SCRIPT_STATE, set_collinear_line, NULL},
    {"option collinear nothing", "", "", SCRIPT_STATE, set_collinear_nothing,
     NULL},
    {"paint flat", "c", "COLOUR", SCRIPT_PAINT, set_flat, NULL},
    {"paint vertex", "ccc", "COLOUR0 COLOUR1 COLOUR2", SCRIPT_PAINT_VERTEX,
     set_vertex, NULL},
    {"triangle", "pppppp", "X0 Y0 X1 Y1 X2 Y2", SCRIPT_TRIANGLE, draw_triangle,
     NULL},
    {"polygon evenodd", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     draw_evenodd, NULL},
    {"polygon nonzero", "pppppp*", "X Y X Y X Y ...", SCRIPT_SHAPE,
     draw_nonzero, NULL},
    {"circle", "ppl", "CX CY R", SCRIPT_SHAPE, draw_circle, NULL},
    {"rect", "ppll", "X Y WIDTH HEIGHT", SCRIPT_SHAPE, draw_rect, check_rect},
    {"line", "pppp", "X0 Y0 X1 Y1", SCRIPT_SHAPE, draw_line, NULL},
    {NULL, NULL, NULL, SCRIPT_STATE, NULL, NULL},
};

const struct script_command *const script_tables[] = {
    script_commands,       script_shapes,        script_images,
    script_paint_commands, script_mesh_commands, NULL,
};
