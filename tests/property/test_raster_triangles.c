/* Coverage of triangles, random and adversarial, through clip windows anywhere,
 * against 128-bit arithmetic; and without area as lines. */
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

static struct hits hits;

static bool in_line(const void *shape, int32_t x, int32_t y)
{
    const struct pel_point *v = shape;
    return reference_line_at(v[0], v[1], x, y);
}

static bool in_triangle(const void *v, int32_t x, int32_t y)
{
    return reference_triangle_at(v, x, y);
}

static void open_window(struct random *r, const struct pel_point v[3])
{
    const struct pel_rect window = shape_window(r, v, 3, 20);
    const struct pel_rect clip = shape_clip(r, &window);
    hits_open(&hits, &window);
    pel_surface_clip(&hits.surface, &clip);
}

/* Either random or adversarial. */
static void generate(struct random *r, struct pel_point v[3])
{
    if (random_word(r) & 1)
        shape_random(r, v, 3);
    else
        shape_adversarial(r, v, 3);
}

TEST(triangles)
{
    for (struct cases c = cases_of(2000000); cases_next(&c);) {
        struct pel_point v[3];
        generate(&c.random, v);
        open_window(&c.random, v);
        pel_triangle(&hits.surface, v, &hits.paint);
        hits_check(&hits, in_triangle, v, "triangle");
    }
}

static bool lower(const struct pel_point *a, const struct pel_point *b)
{
    return a->y > b->y || (a->y == b->y && a->x > b->x);
}

/* Without area: the line between the two extreme vertices. */
TEST(collinear_triangles)
{
    for (struct cases c = cases_of(200000); cases_next(&c);) {
        struct pel_point v[3], line[2];
        generate(&c.random, v);
        if (random_word(&c.random) & 1)
            v[2] = v[random_word(&c.random) % 2];
        open_window(&c.random, v);
        pel_triangle_or_line(&hits.surface, v, &hits.paint);
        line[0] = line[1] = v[0];
        for (int i = 1; i < 3; i++) {
            if (lower(&line[0], &v[i]))
                line[0] = v[i];
            if (lower(&v[i], &line[1]))
                line[1] = v[i];
        }
        const bool flat = pel_triangle_area(v) == 0;
        hits_check(&hits, flat ? in_line : in_triangle, flat ? line : v,
                   "triangle or line");
    }
}
