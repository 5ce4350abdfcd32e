#include "scene_commands.h"

static const struct pel_point *points(const int32_t *v)
{
    /* A pel_point is two int32_t, and so is each pair of coordinates. */
    return (const struct pel_point *)(const void *)v;
}

static void draw_clear(struct scene_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pel_clear(pen->surface, (pel_color)v[0]);
}

static void set_clip(struct scene_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pen->clip.x0 = v[0];
    pen->clip.y0 = v[1];
    pen->clip.x1 = v[0] + v[2];
    pen->clip.y1 = v[1] + v[3];
    pel_surface_clip(pen->surface, &pen->clip);
}

static void set_collinear_line(struct scene_pen *pen, const int32_t *v,
                               size_t n)
{
    (void)v;
    (void)n;
    pen->collinear_line = true;
}

static void set_collinear_nothing(struct scene_pen *pen, const int32_t *v,
                                  size_t n)
{
    (void)v;
    (void)n;
    pen->collinear_line = false;
}

static void set_flat(struct scene_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pen->flat.color = (pel_color)v[0];
    pen->make = NULL;
    pen->by_vertex = false;
}

static void set_vertex(struct scene_pen *pen, const int32_t *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        pen->corner[i] = (pel_color)v[i];
    pen->by_vertex = true;
}

static void draw_triangle(struct scene_pen *pen, const int32_t *v, size_t n)
{
    struct pel_gouraud gouraud;
    const struct pel_paint *paint = scene_paint(pen);
    (void)n;
    if (pen->by_vertex) {
        pel_gouraud_init(&gouraud, points(v), pen->corner);
        paint = scene_dithered(pen, &gouraud.paint);
    }
    if (pen->collinear_line)
        pel_triangle_or_line(pen->surface, points(v), paint);
    else
        pel_triangle(pen->surface, points(v), paint);
}

static void draw_polygon(struct scene_pen *pen, const int32_t *v, size_t n,
                         enum pel_fill_rule rule)
{
    const struct pel_polygon_shape outline = {points(v), (int32_t)(n / 2),
                                              rule};
    /* Cannot fail: vertices and scratch memory were checked before. */
    pel_polygon(pen->surface, &outline, scene_paint(pen), pen->scratch,
                pen->scratch_size);
}

static void draw_evenodd(struct scene_pen *pen, const int32_t *v, size_t n)
{
    draw_polygon(pen, v, n, PEL_EVEN_ODD);
}

static void draw_nonzero(struct scene_pen *pen, const int32_t *v, size_t n)
{
    draw_polygon(pen, v, n, PEL_NON_ZERO);
}

static void draw_circle(struct scene_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pel_circle(pen->surface, points(v)[0], v[2], scene_paint(pen));
}

static const char *check_rect(const int32_t *v, size_t n)
{
    (void)n;
    if (v[0] + v[2] > PEL_COORDINATE_MAX || v[1] + v[3] > PEL_COORDINATE_MAX)
        return "the right and the bottom side must lie below 32768";
    return NULL;
}

static void draw_rect(struct scene_pen *pen, const int32_t *v, size_t n)
{
    const struct pel_point to = {v[0] + v[2], v[1] + v[3]};
    (void)n;
    pel_rectangle(pen->surface, points(v)[0], to, scene_paint(pen));
}

static void draw_line(struct scene_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pel_line(pen->surface, points(v)[0], points(v)[1], scene_paint(pen));
}

const struct scene_command scene_commands[] = {
    {"canvas", "ssf", "WIDTH HEIGHT FORMAT", SCENE_CANVAS, NULL, NULL},
    {"clear", "c", "COLOUR", SCENE_STATE, draw_clear, NULL},
    {"clip", "iinn", "X Y WIDTH HEIGHT", SCENE_STATE, set_clip, NULL},
    {"bands", "n", "ROWS", SCENE_BANDS, NULL, NULL},
    {"option collinear line", "", "", SCENE_STATE, set_collinear_line, NULL},
    {"option collinear nothing", "", "", SCENE_STATE, set_collinear_nothing,
     NULL},
    {"paint flat", "c", "COLOUR", SCENE_PAINT, set_flat, NULL},
    {"paint vertex", "ccc", "COLOUR0 COLOUR1 COLOUR2", SCENE_PAINT_VERTEX,
     set_vertex, NULL},
    {"triangle", "pppppp", "X0 Y0 X1 Y1 X2 Y2", SCENE_TRIANGLE, draw_triangle,
     NULL},
    {"polygon evenodd", "pppppp*", "X Y X Y X Y ...", SCENE_SHAPE, draw_evenodd,
     NULL},
    {"polygon nonzero", "pppppp*", "X Y X Y X Y ...", SCENE_SHAPE, draw_nonzero,
     NULL},
    {"circle", "ppl", "CX CY R", SCENE_SHAPE, draw_circle, NULL},
    {"rect", "ppll", "X Y WIDTH HEIGHT", SCENE_SHAPE, draw_rect, check_rect},
    {"line", "pppp", "X0 Y0 X1 Y1", SCENE_SHAPE, draw_line, NULL},
    {NULL, NULL, NULL, SCENE_STATE, NULL, NULL},
};

const struct scene_command *const scene_tables[] = {
    scene_commands,       scene_shapes,        scene_images,
    scene_paint_commands, scene_mesh_commands, NULL,
};
