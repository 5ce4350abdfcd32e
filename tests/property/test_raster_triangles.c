/* Coverage of triangles, random and adversarial, through clip windows anywhere,
 * against 128-bit arithmetic. */
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

static struct hits hits;

static bool in_triangle(const void *v, int32_t x, int32_t y)
{
    return reference_triangle_at(v, x, y);
}

typedef void generator(struct random *r, struct pel_point *v, int32_t n);

static void check_triangles(generator *generate)
{
    uint64_t covered = 0;
    for (struct cases c = cases_of(1000000); cases_next(&c);) {
        struct pel_point v[3];
        generate(&c.random, v, 3);
        const struct pel_rect window = shape_window(&c.random, v, 3, 20);
        const struct pel_rect clip = shape_clip(&c.random, &window);
        hits_open(&hits, &window);
        pel_surface_clip(&hits.surface, &clip);
        pel_triangle(&hits.surface, v, &hits.paint);
        hits_check(&hits, in_triangle, v, "triangle");
        covered += hits.pixels;
    }
    print_message("%llu pixels covered\n", (unsigned long long)covered);
}

static void test_random_triangles(void)
{
    check_triangles(shape_random);
}

static void test_adversarial_triangles(void)
{
    check_triangles(shape_adversarial);
}

int main(void)
{
    return RUN_TESTS(test_random_triangles, test_adversarial_triangles);
}
