/* Coverage of circles, lines, polygons, rectangles and of triangles without
 * area drawn as lines, against the references; through clip windows anywhere.
 * Every pixel at most once, whatever crosses itself. */
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

static struct hits hits;

struct shape {
    struct pel_point v[40];
    struct pel_polygon_shape outline;
    int32_t radius;
};

static bool in_disc(const void *shape, int32_t x, int32_t y)
{
    const struct shape *s = shape;
    return reference_disc_at(s->v[0], s->radius, x, y);
}

static bool in_line(const void *shape, int32_t x, int32_t y)
{
    const struct shape *s = shape;
    return reference_line_at(s->v[0], s->v[1], x, y);
}

static bool in_polygon(const void *shape, int32_t x, int32_t y)
{
    return reference_polygon_at(&((const struct shape *)shape)->outline, x, y);
}

static bool in_triangle(const void *shape, int32_t x, int32_t y)
{
    return reference_triangle_at(((const struct shape *)shape)->v, x, y);
}

static bool in_rectangle(const void *shape, int32_t x, int32_t y)
{
    const struct shape *s = shape;
    wide px = (wide)x * 256 + 128, py = (wide)y * 256 + 128;
    return s->v[0].x <= px && px < s->v[1].x && s->v[0].y <= py &&
           py < s->v[1].y;
}

static void open_window(struct random *r, const struct shape *s, int32_t n)
{
    const struct pel_rect window = shape_window(r, s->v, n, 24);
    const struct pel_rect clip = shape_clip(r, &window);
    hits_open(&hits, &window);
    pel_surface_clip(&hits.surface, &clip);
}

static void generate(struct random *r, struct shape *s, int32_t n)
{
    if (random_word(r) & 1)
        shape_random(r, s->v, n);
    else
        shape_adversarial(r, s->v, n);
}

/* v[1] is where the window looks: a point of the rim, or near the centre. */
static void test_circles(void)
{
    struct shape s;
    for (struct cases c = cases_of(400000); cases_next(&c);) {
        generate(&c.random, &s, 2);
        wide dx = (wide)s.v[1].x - s.v[0].x, dy = (wide)s.v[1].y - s.v[0].y;
        int32_t longer =
            pel_max((int32_t)(dx < 0 ? -dx : dx), (int32_t)(dy < 0 ? -dy : dy));
        s.radius = pel_min(longer + random_between(&c.random, -300, 300),
                           PEL_PX(32767));
        if (random_word(&c.random) % 4 == 0)
            s.radius = random_between(&c.random, 0, PEL_PX(32767));
        s.radius = pel_max(s.radius, 0);
        open_window(&c.random, &s, 2);
        pel_circle(&hits.surface, s.v[0], s.radius, &hits.paint);
        hits_check(&hits, in_disc, &s, "circle");
    }
}

static void test_lines(void)
{
    struct shape s;
    for (struct cases c = cases_of(400000); cases_next(&c);) {
        generate(&c.random, &s, 2);
        open_window(&c.random, &s, 2);
        pel_line(&hits.surface, s.v[0], s.v[1], &hits.paint);
        hits_check(&hits, in_line, &s, "line");
    }
}

static void test_rectangles(void)
{
    struct shape s;
    for (struct cases c = cases_of(200000); cases_next(&c);) {
        generate(&c.random, &s, 2);
        open_window(&c.random, &s, 2);
        pel_rectangle(&hits.surface, s.v[0], s.v[1], &hits.paint);
        hits_check(&hits, in_rectangle, &s, "rectangle");
    }
}

static void check_polygon(struct random *r, struct shape *s, int32_t n)
{
    static uint32_t scratch[1024];
    generate(r, s, n);
    s->outline = (struct pel_polygon_shape){
        s->v, n, random_word(r) & 1 ? PEL_EVEN_ODD : PEL_NON_ZERO};
    open_window(r, s, n);
    assert_true(pel_polygon_scratch_size(n) <= sizeof scratch);
    assert_int_equal(pel_polygon(&hits.surface, &s->outline, &hits.paint,
                                 scratch, pel_polygon_scratch_size(n)),
                     PEL_OK);
    hits_check(&hits, in_polygon, s, "polygon");
}

static void test_small_polygons(void)
{
    struct shape s;
    for (struct cases c = cases_of(200000); cases_next(&c);)
        check_polygon(&c.random, &s, random_between(&c.random, 1, 7));
}

static void test_large_polygons(void)
{
    struct shape s;
    for (struct cases c = cases_of(30000); cases_next(&c);)
        check_polygon(&c.random, &s, random_between(&c.random, 8, 28));
}

/* A triangle as a polygon is the triangle, by either rule. */
static void test_triangle_polygons(void)
{
    struct shape s;
    uint32_t scratch[64];
    for (struct cases c = cases_of(200000); cases_next(&c);) {
        generate(&c.random, &s, 3);
        s.outline = (struct pel_polygon_shape){
            s.v, 3, random_word(&c.random) & 1 ? PEL_EVEN_ODD : PEL_NON_ZERO};
        open_window(&c.random, &s, 3);
        assert_int_equal(pel_polygon(&hits.surface, &s.outline, &hits.paint,
                                     scratch, sizeof scratch),
                         PEL_OK);
        hits_check(&hits, in_triangle, &s, "triangle as polygon");
    }
}

static bool lower(const struct pel_point *a, const struct pel_point *b)
{
    return a->y > b->y || (a->y == b->y && a->x > b->x);
}

/* Without area: the line between the two extreme vertices. */
static void test_collinear_triangles(void)
{
    struct shape s, line;
    for (struct cases c = cases_of(200000); cases_next(&c);) {
        generate(&c.random, &s, 3);
        if (random_word(&c.random) & 1)
            s.v[2] = s.v[random_word(&c.random) % 2];
        open_window(&c.random, &s, 3);
        pel_triangle_or_line(&hits.surface, s.v, &hits.paint);
        line.v[0] = line.v[1] = s.v[0];
        for (int i = 1; i < 3; i++) {
            if (lower(&line.v[0], &s.v[i]))
                line.v[0] = s.v[i];
            if (lower(&s.v[i], &line.v[1]))
                line.v[1] = s.v[i];
        }
        bool flat = pel_triangle_area(s.v) == 0;
        hits_check(&hits, flat ? in_line : in_triangle, flat ? &line : &s,
                   "triangle or line");
    }
}

int main(void)
{
    return RUN_TESTS(test_circles, test_lines, test_rectangles,
                     test_small_polygons, test_large_polygons,
                     test_triangle_polygons, test_collinear_triangles);
}
