/* The golden scenes of smooth edges, paths and strokes. */
#ifndef TESTS_GOLDEN_SMOOTH_H
#define TESTS_GOLDEN_SMOOTH_H

#include "tests/golden/size.h"

static uint64_t outline_scratch[800];

static void draw_smooth_straight(const struct pel_surface *s)
{
    static const struct pel_point v[4] = {
        {300, 500}, {9900, 1100}, {8300, 9900}, {-900, 6000}};
    static const pel_color c[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0),
                                   PEL_RGB(0, 0, 255)};
    static const struct pel_thick_line_shape line = {
        {14000, 700}, {23000, 5333}, 700};
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(240, 200, 90));
    const struct pel_flat glass = PEL_FLAT(PEL_RGBA(90, 220, 250, 140));
    pel_smooth_convex(s, v, 4, &flat.paint);
    pel_smooth_triangle(s, v + 1, &glass.paint);
    pel_smooth_triangle_gouraud(
        s, (struct pel_point[3]){{10100, 3000}, {13000, 17000}, {4100, 12345}},
        c);
    pel_smooth_rectangle(s, (struct pel_point){14001, 11003},
                         (struct pel_point){23877, 17033}, &glass.paint);
    pel_smooth_thick_line(s, &line, &flat.paint);
    for (int32_t i = 0; i < 5; i++) {
        const struct pel_thick_line_shape needle = {
            {17000, 9000}, {17000 + i * 1711, 17777 - i * 400}, 90 * i + 60};
        pel_smooth_thick_line_round(s, &needle, &flat.paint);
    }
}

/* In one color, in a gradient, and in it with alpha below. */
static void draw_smooth_round(const struct pel_surface *s)
{
    static const pel_color ends[2] = {PEL_RGB(255, 220, 0),
                                      PEL_RGBA(0, 60, 200, 90)};
    static const struct pel_ramp ramp = {ends, 2, PEL_REFLECT};
    static const struct pel_rounded_shape box = {
        {900, 9777}, {11000, 17500}, 2100};
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(240, 200, 90));
    struct pel_linear linear;
    if (pel_linear_init(&linear, (struct pel_point){0, 0},
                        (struct pel_point)PEL_AT(31, 17), &ramp))
        printf("linear: refused\n");
    pel_smooth_circle(s, (struct pel_point){4321, 4777}, 3999, &flat.paint);
    pel_smooth_circle(s, (struct pel_point)PEL_AT(31, 9), PEL_PX(7),
                      &linear.base.paint);
    pel_smooth_rounded_rectangle(s, &box, &linear.base.paint);
    pel_smooth_ring(s, &(struct pel_ring_shape){{17000, 5000}, 3100, 4200},
                    &flat.paint);
    pel_smooth_ellipse(
        s, &(struct pel_ellipse_shape){{15000, 14000}, {5000, 2100}},
        &linear.base.paint);
    for (int32_t i = 0; i < 3; i++) {
        const struct pel_arc_shape arc = {{20000, 12000},
                                          1000 * i + 300,
                                          1000 * i + 1111,
                                          9000 * i,
                                          9000 * i + 30000 - 7000 * i};
        if (i % 2)
            pel_smooth_arc(s, &arc, &flat.paint);
        else
            pel_smooth_arc_round(s, &arc, &linear.base.paint);
    }
    pel_smooth_sector(
        s, &(struct pel_sector_shape){{7000, 11000}, 5000, 40000, 60000},
        &flat.paint);
}

/* A fill, and a stroke along it; dashes; a polyline that turns sharply. */
static void draw_outlines(const struct pel_surface *s, bool smooth)
{
    static const uint8_t verbs[] = {PEL_MOVE, PEL_CUBIC, PEL_QUAD, PEL_LINE,
                                    PEL_CLOSE};
    static const int16_t points[] = {0,  0,  70, -40, 90, 90, 60,
                                     50, 80, 10, -20, 45, 10, 70};
    static const struct pel_path path = {
        .verbs = verbs, .points16 = points, .verb_count = 5, .point_count = 7};
    static const struct pel_transform map = {PEL_SCALE(.55),
                                             PEL_SCALE(-.2),
                                             PEL_SCALE(.13),
                                             PEL_SCALE(.6),
                                             {5200, 4100}};
    static const int32_t lengths[3] = {2900, 1500, 0};
    static const struct pel_dashes dashes = {&pel_dashed, lengths, 3, 333};
    static const struct pel_point v[5] = {{2000, 16000},
                                          {23000, 15000},
                                          {9000, 17000},
                                          {14000, 9000},
                                          {2300, 9000}};
    const struct pel_path_shape shape = {
        &path,
        &map,
        PEL_EVEN_ODD,
        {0, PEL_CAP_BUTT, PEL_JOIN_BEVEL, 0, NULL},
        0};
    struct pel_path_shape stroke = shape;
    struct pel_polyline_shape line = {
        v, 5, false, {1300, PEL_CAP_SQUARE, PEL_JOIN_MITER, 0, NULL}};
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(240, 200, 90));
    const struct pel_flat glass = PEL_FLAT(PEL_RGBA(90, 220, 250, 140));
    void *const memory = outline_scratch;
    const size_t size = sizeof outline_scratch;
    stroke.stroke =
        (struct pel_stroke){600, PEL_CAP_ROUND, PEL_JOIN_ROUND, 0, &dashes};
    if (smooth ? pel_smooth_path_fill(s, &shape, &flat.paint, memory, size) ||
                     pel_smooth_path_stroke(s, &stroke, &glass.paint, memory,
                                            size) ||
                     pel_smooth_polyline(s, &line, &glass.paint, memory, size)
               : pel_path_fill(s, &shape, &flat.paint, memory, size) ||
                     pel_path_stroke(s, &stroke, &glass.paint, memory, size) ||
                     pel_polyline(s, &line, &glass.paint, memory, size))
        printf("outlines: refused\n");
}

static void draw_paths(const struct pel_surface *s)
{
    draw_outlines(s, false);
}

static void draw_smooth_paths(const struct pel_surface *s)
{
    draw_outlines(s, true);
}

#endif
