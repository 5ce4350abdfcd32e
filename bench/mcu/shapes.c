/* Shapes that are hardly there: outside of the clip, and narrow arcs. */
#include <stdio.h>

#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

/* What a shape outside of the clip may take on an M0+: so much, and for each of
 * its vertices. */
enum { OUTSIDE = 300, OUTSIDE_VERTEX = 15 };

enum { SIDE = 220, VERTICES = 8 };

static uint16_t pixels[SIDE * SIDE];
static struct pel_surface surface;
static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));

/* The shapes have the centre c and are at most 80 px wide and high. */
static struct pel_point c;

static struct pel_point at(int32_t x, int32_t y)
{
    return (struct pel_point){c.x + PEL_PX(x), c.y + PEL_PX(y)};
}

static void triangle(void)
{
    const struct pel_point v[3] = {at(-30, -40), at(20, -20), at(-20, 30)};
    pel_triangle(&surface, v, &flat.paint);
}

static void triangle_or_line(void)
{
    const struct pel_point v[3] = {at(-30, -40), at(20, -20), at(-20, 30)};
    pel_triangle_or_line(&surface, v, &flat.paint);
}

static void triangle_outline(void)
{
    const struct pel_point v[3] = {at(-30, -40), at(20, -20), at(-20, 30)};
    pel_triangle_outline(&surface, v, &flat.paint);
}

static void rectangle(void)
{
    pel_rectangle(&surface, at(-40, -20), at(40, 20), &flat.paint);
}

static void rectangle_outline(void)
{
    pel_rectangle_outline(&surface, at(-40, -20), at(40, 20), &flat.paint);
}

static const struct pel_polygon_shape *polygon(void)
{
    static struct pel_point v[VERTICES];
    static const struct pel_polygon_shape shape = {v, VERTICES, PEL_NON_ZERO};
    for (int i = 0; i < VERTICES; i++) {
        const struct pel_point d =
            pel_direction((uint16_t)(i * (65536 / VERTICES)));
        v[i] = (struct pel_point){c.x + d.x / 4, c.y + d.y / 3};
    }
    return &shape;
}

static const struct pel_polygon_shape *octagon;
static uint64_t scratch[100];

static void polygon_fill(void)
{
    pel_polygon(&surface, octagon, &flat.paint, scratch, sizeof scratch);
}

static void polygon_outline(void)
{
    pel_polygon_outline(&surface, octagon, &flat.paint, scratch,
                        sizeof scratch);
}

static void circle(void)
{
    pel_circle(&surface, c, PEL_PX(40), &flat.paint);
}

static void circle_outline(void)
{
    pel_circle_outline(&surface, c, PEL_PX(40), &flat.paint);
}

static void ellipse(void)
{
    pel_ellipse(&surface, &(struct pel_ellipse_shape){c, PEL_AT(40, 30)},
                &flat.paint);
}

static void ellipse_outline(void)
{
    pel_ellipse_outline(&surface, &(struct pel_ellipse_shape){c, PEL_AT(9, 7)},
                        &flat.paint);
}

static struct pel_rounded_shape rounded(void)
{
    return (struct pel_rounded_shape){at(-40, -20), at(40, 20), PEL_PX(9)};
}

static void rounded_rectangle(void)
{
    const struct pel_rounded_shape shape = rounded();
    pel_rounded_rectangle(&surface, &shape, &flat.paint);
}

static void rounded_rectangle_outline(void)
{
    const struct pel_rounded_shape shape = rounded();
    pel_rounded_rectangle_outline(&surface, &shape, &flat.paint);
}

static void ring(void)
{
    pel_ring(&surface, &(struct pel_ring_shape){c, PEL_PX(20), PEL_PX(40)},
             &flat.paint);
}

static void sector(void)
{
    pel_sector(&surface, &(struct pel_sector_shape){c, PEL_PX(40), 1000, 50000},
               &flat.paint);
}

static void arc(void)
{
    pel_arc(&surface,
            &(struct pel_arc_shape){c, PEL_PX(20), PEL_PX(40), 1000, 50000},
            &flat.paint);
}

static void arc_outline(void)
{
    pel_arc_outline(&surface,
                    &(struct pel_sector_shape){c, PEL_PX(40), 1000, 50000},
                    &flat.paint);
}

static void line(void)
{
    pel_line(&surface, at(-40, -10), at(40, 20), &flat.paint);
}

static void thick_line(void)
{
    pel_thick_line(
        &surface,
        &(struct pel_thick_line_shape){at(-35, -10), at(35, 20), PEL_PX(3)},
        &flat.paint);
}

static void glyph(void)
{
    static const uint8_t bits[8] = {0x30, 0x78, 0xcc, 0xcc, 0xfc, 0xcc, 0xcc};
    static const struct pel_stencil stencil = {bits, 1, 8, 8};
    pel_glyph(&surface, &stencil, pel_pixel_of(c.x), pel_pixel_of(c.y),
              &flat.paint);
}

static const struct {
    const char *name;
    void (*draw)(void);
    int32_t vertices;
} shapes[] = {
    {"triangle", triangle, 3},
    {"triangle_or_line", triangle_or_line, 3},
    {"triangle_outline", triangle_outline, 3},
    {"rectangle", rectangle, 0},
    {"rectangle_outline", rectangle_outline, 0},
    {"polygon", polygon_fill, VERTICES},
    {"polygon_outline", polygon_outline, VERTICES},
    {"circle", circle, 0},
    {"circle_outline", circle_outline, 0},
    {"ellipse", ellipse, 0},
    {"ellipse_outline", ellipse_outline, 0},
    {"rounded_rectangle", rounded_rectangle, 0},
    {"rounded_rectangle_outline", rounded_rectangle_outline, 0},
    {"ring", ring, 0},
    {"sector", sector, 0},
    {"arc", arc, 0},
    {"arc_outline", arc_outline, 0},
    {"line", line, 0},
    {"thick_line", thick_line, 0},
    {"glyph", glyph, 0},
};

static int32_t time_of(void (*draw)(void))
{
    const uint32_t from = stopwatch_read();
    draw();
    return stopwatch_eighths(from, stopwatch_read());
}

/* The most that a shape takes above, below, left and right of a clip. */
static bool outside_report(int i)
{
    static const struct pel_point centers[4] = {
        PEL_AT(110, 30), PEL_AT(110, 190), PEL_AT(30, 110), PEL_AT(190, 110)};
    const int32_t limit = OUTSIDE + OUTSIDE_VERTEX * shapes[i].vertices;
    int32_t most = 0;
    for (int k = 0; k < 4; k++) {
        c = centers[k];
        octagon = polygon();
        const int32_t time = time_of(shapes[i].draw);
        most = time > most ? time : most;
    }
    char name[48];
    snprintf(name, sizeof name, "outside-%s", shapes[i].name);
    report(name, shapes[i].vertices, most, 1);
    if (most <= 8 * limit)
        return true;
    printf("%s takes more than %d instructions\n", name, (int)limit);
    return false;
}

/* Of a dial's ring, as needles and scales are. */
static void arcs_report(int32_t degrees)
{
    const int32_t from = 20000, to = from + degrees * 65536 / 360;
    const struct pel_point center = PEL_AT(110, 110);
    const struct pel_arc_shape shape = {center, PEL_PX(92), PEL_PX(108), from,
                                        to};
    const struct pel_sector_shape needle = {center, PEL_PX(108), from, to};
    struct pel_dirty dirty;
    pel_dirty_begin(&dirty, NULL);
    uint32_t start = stopwatch_read();
    pel_arc(&surface, &shape, &flat.paint);
    report("arc", degrees, stopwatch_eighths(start, stopwatch_read()), 1);
    start = stopwatch_read();
    pel_arc(&surface, &shape, &dirty.paint);
    report("arc-dirty", degrees, stopwatch_eighths(start, stopwatch_read()), 1);
    start = stopwatch_read();
    pel_sector(&surface, &needle, &flat.paint);
    report("sector", degrees, stopwatch_eighths(start, stopwatch_read()), 1);
}

bool shapes_report(void)
{
    const struct pel_rect bounds = {0, 0, SIDE, SIDE};
    bool within = true;
    pel_surface_init(&surface, &pel_rgb565_le, pixels, sizeof pixels, &bounds);
    arcs_report(1);
    arcs_report(90);
    arcs_report(270);
    pel_surface_clip(&surface, &(struct pel_rect){105, 105, 115, 115});
    for (int i = 0; i < (int)(sizeof shapes / sizeof *shapes); i++)
        within &= outside_report(i);
    return within;
}
