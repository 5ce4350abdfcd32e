/* Shapes on a 4 x 4 screen whose points lie on, next to and far beyond its
 * borders, in every combination: once through a paint that counts, and once
 * into 16 bytes that end at a guard page or begin after one. */
#include <string.h>

#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"

enum { SIDE = 4, PIXELS = SIDE * SIDE };

/* Both ends of the range, pixel edges and centres beside the borders. */
static const int32_t places[] = {
    PEL_COORDINATE_MIN, -256, -128, 0, 128, 129, 640, 896, 1024, 1025, 1152,
    PEL_COORDINATE_MAX};
enum { PLACES = sizeof places / sizeof places[0] };

/* The few that polygons, of more points, take. */
static const int32_t few_places[] = {PEL_COORDINATE_MIN, 0, 384, 896,
                                     PEL_COORDINATE_MAX};
enum { FEW = sizeof few_places / sizeof few_places[0] };

static struct hits hits;
static struct canvas canvas[2];
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

struct shape {
    struct pel_point v[4];
    struct pel_polygon_shape outline;
    int32_t radius;
};

typedef void draw(const struct pel_surface *s, const struct shape *shape,
                  const struct pel_paint *paint);

static void setup(void)
{
    const struct pel_rect screen = {0, 0, SIDE, SIDE};
    hits_open(&hits, &screen);
    canvas_open(&canvas[0], &pel_gray8, &screen, CANVAS_AT_END);
    canvas_open(&canvas[1], &pel_gray8, &screen, CANVAS_UP);
}

static void fail_at(const struct shape *s, int i, const char *name)
{
    fail_msg("%s %d,%d %d,%d %d,%d %d,%d, radius %d: wrong at %d, %d", name,
             s->v[0].x, s->v[0].y, s->v[1].x, s->v[1].y, s->v[2].x, s->v[2].y,
             s->v[3].x, s->v[3].y, s->radius, i % SIDE, i / SIDE);
}

static void check_shape(const struct shape *s, draw *draw_it,
                        hits_expected *expected, const char *name)
{
    memset(hits.count, 0, PIXELS);
    draw_it(&hits.surface, s, &hits.paint);
    for (int k = 0; k < 2; k++) {
        memset(canvas[k].memory, 0, PIXELS);
        draw_it(&canvas[k].surface, s, &white.paint);
    }
    for (int32_t i = 0; i < PIXELS; i++) {
        const int32_t x = i % SIDE, y = i / SIDE;
        const uint32_t want = expected(s, x, y) ? 255 : 0;
        if (hits.count[i] * 255u != want ||
            canvas_pixel(&canvas[0], x, y) != want ||
            canvas_pixel(&canvas[1], x, y) != want)
            fail_at(s, i, name);
    }
}

static struct pel_point place(int32_t i)
{
    return (struct pel_point){places[i % PLACES], places[i / PLACES]};
}

static void draw_triangle(const struct pel_surface *s,
                          const struct shape *shape,
                          const struct pel_paint *paint)
{
    pel_triangle(s, shape->v, paint);
}

static bool in_triangle(const void *shape, int32_t x, int32_t y)
{
    return reference_triangle_at(((const struct shape *)shape)->v, x, y);
}

/* Triples that differ by more than the order of their points. */
static void test_triangles(void)
{
    struct shape s = {{{0, 0}}, {NULL, 0, PEL_EVEN_ODD}, 0};
    for (int32_t i = 0; i < PLACES * PLACES; i++)
        for (int32_t j = i; j < PLACES * PLACES; j++)
            for (int32_t k = j; k < PLACES * PLACES; k++) {
                s.v[(i + j) % 3] = place(i);
                s.v[(i + j + 1) % 3] = place(j);
                s.v[(i + j + 2) % 3] = place(k);
                check_shape(&s, draw_triangle, in_triangle, "triangle");
            }
}

static void draw_circle(const struct pel_surface *s, const struct shape *shape,
                        const struct pel_paint *paint)
{
    pel_circle(s, shape->v[0], shape->radius, paint);
}

static bool in_disc(const void *shape, int32_t x, int32_t y)
{
    const struct shape *s = shape;
    return reference_disc_at(s->v[0], s->radius, x, y);
}

/* Radii about which the disc reaches a border or the far side of the screen, or
 * takes in all of it. */
static void test_circles(void)
{
    static const int32_t radii[] = {0,   1,   127, 128,  129,  255,  256,
                                    257, 384, 512, 1024, 1280, 2048, 300000};
    struct shape s = {{{0, 0}}, {NULL, 0, PEL_EVEN_ODD}, 0};
    for (int32_t i = 0; i < PLACES * PLACES; i++) {
        s.v[0] = place(i);
        for (size_t k = 0; k < sizeof radii / sizeof radii[0]; k++) {
            s.radius = radii[k];
            check_shape(&s, draw_circle, in_disc, "circle");
        }
        for (int32_t k = 0; k <= 1024; k++) {
            s.radius = PEL_PX(32767) - k;
            check_shape(&s, draw_circle, in_disc, "circle");
        }
    }
}

static void draw_line(const struct pel_surface *s, const struct shape *shape,
                      const struct pel_paint *paint)
{
    pel_line(s, shape->v[0], shape->v[1], paint);
}

static bool in_line(const void *shape, int32_t x, int32_t y)
{
    const struct shape *s = shape;
    return reference_line_at(s->v[0], s->v[1], x, y);
}

static void draw_rectangle(const struct pel_surface *s,
                           const struct shape *shape,
                           const struct pel_paint *paint)
{
    pel_rectangle(s, shape->v[0], shape->v[1], paint);
}

static bool in_rectangle(const void *shape, int32_t x, int32_t y)
{
    const struct shape *s = shape;
    const int32_t px = x * 256 + 128, py = y * 256 + 128;
    return s->v[0].x <= px && px < s->v[1].x && s->v[0].y <= py &&
           py < s->v[1].y;
}

static void test_lines_and_rectangles(void)
{
    struct shape s = {{{0, 0}}, {NULL, 0, PEL_EVEN_ODD}, 0};
    for (int32_t i = 0; i < PLACES * PLACES; i++)
        for (int32_t j = 0; j < PLACES * PLACES; j++) {
            s.v[0] = place(i);
            s.v[1] = place(j);
            check_shape(&s, draw_line, in_line, "line");
            check_shape(&s, draw_rectangle, in_rectangle, "rectangle");
        }
}

static void draw_polygon(const struct pel_surface *s, const struct shape *shape,
                         const struct pel_paint *paint)
{
    uint32_t scratch[64];
    assert_int_equal(
        pel_polygon(s, &shape->outline, paint, scratch, sizeof scratch),
        PEL_OK);
}

static bool in_polygon(const void *shape, int32_t x, int32_t y)
{
    return reference_polygon_at(&((const struct shape *)shape)->outline, x, y);
}

static void test_quadrilaterals(void)
{
    struct shape s = {{{0, 0}}, {s.v, 4, PEL_EVEN_ODD}, 0};
    for (int32_t i = 0; i < FEW * FEW * FEW * FEW * FEW * FEW * FEW * FEW;
         i++) {
        for (int32_t k = 0, rest = i; k < 4; k++, rest /= FEW * FEW)
            s.v[k] = (struct pel_point){few_places[rest % FEW],
                                        few_places[rest / FEW % FEW]};
        for (int rule = 0; rule < 2; rule++) {
            s.outline.rule = (enum pel_fill_rule)rule;
            check_shape(&s, draw_polygon, in_polygon, "polygon");
        }
    }
}

int main(void)
{
    setup();
    return RUN_TESTS(test_triangles, test_circles, test_lines_and_rectangles,
                     test_quadrilaterals);
}
