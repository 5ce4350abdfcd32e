/* Polygons of 8 to 2,000 vertices against winding numbers: random ones, stars,
 * spirals and combs, outlines that run over themselves, and sides of which many
 * begin, end or cross in one row. */
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

enum { VERTICES_MAX = 2000, WINDOW = 14, LARGE_WINDOW = 64 };

static struct hits hits;
static struct pel_point vertex[VERTICES_MAX];
static uint32_t scratch[PEL_POLYGON_SCRATCH_SIZE(VERTICES_MAX) / 4];

static bool in_polygon(const void *outline, int32_t x, int32_t y)
{
    return reference_polygon_at(outline, x, y);
}

typedef void generator(struct random *r, struct pel_point *v, int32_t n);

/* From one side of the picture to the other and back, the teeth as high as it
 * or a row more or less. */
static void comb(struct random *r, struct pel_point *v, int32_t n)
{
    const int32_t pitch = random_between(r, 1, 700);
    const int32_t low = random_between(r, 0, 512),
                  shake = random_between(r, 0, 600);
    for (int32_t i = 0; i < n; i++) {
        v[i].x = (i - n / 2) * pitch;
        v[i].y = (i % 2 ? PEL_PX(9) : low) + random_between(r, -shake, shake);
    }
}

/* On a ring, joined over `skip` neighbours. One step after the other is a shear
 * in x and one in y, which keeps the points on an ellipse; 10,431 / 65,536 is
 * the length of a turn's radius. */
static void star(struct random *r, struct pel_point *v, int32_t n)
{
    const int32_t skip = random_between(r, 1, n / 2);
    const int64_t turn = 65536 / n + 1;
    int64_t x = random_between(r, 300, 2000000), y = 0;
    for (int32_t i = 0; i < n; i++)
        v[i] = (struct pel_point){0, 0}; /* those that are never reached */
    for (int32_t i = 0; i < n; i++) {
        v[(int64_t)i * skip % n] = (struct pel_point){(int32_t)x, (int32_t)y};
        x -= y * turn / 10431;
        y += x * turn / 10431;
    }
}

/* Boxes within boxes, by right angles. */
static void spiral(struct random *r, struct pel_point *v, int32_t n)
{
    const int32_t step = random_between(r, 16, 400);
    for (int32_t i = 0; i < n; i++) {
        const int32_t reach = (i + 2) / 2 * step;
        v[i].x = i / 2 % 2 ? reach : -reach;
        v[i].y = (i + 1) / 2 % 2 ? reach : -reach;
    }
}

/* There and back again over few points. */
static void repeat(struct random *r, struct pel_point *v, int32_t n)
{
    struct pel_point few[7];
    shape_adversarial(r, few, 7);
    for (int32_t i = 0; i < n; i++)
        v[i] = few[random_word(r) % 7];
}

static void pixels(struct random *r, struct pel_point *v, int32_t n)
{
    const struct pel_rect box = {-8, -8, 8, 8};
    shape_in_box(r, v, n, &box);
}

/* Few vertices more often than many, as slow as these are. */
static int32_t random_count(struct random *r)
{
    static const int32_t most[] = {20, 40, 60, 100, 200, 600, VERTICES_MAX};
    return random_between(r, 8, most[random_word(r) % 7]);
}

static void check_polygons(generator *generate, uint64_t count)
{
    uint64_t covered = 0;
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct random *r = &c.random;
        const int32_t n = random_count(r);
        const struct pel_polygon_shape outline = {
            vertex, n, random_word(r) & 1 ? PEL_EVEN_ODD : PEL_NON_ZERO};
        generate(r, vertex, n);
        const int32_t size = random_word(r) % 8 ? WINDOW : LARGE_WINDOW;
        const struct pel_rect w = shape_window(r, vertex, n, size);
        const struct pel_rect clip = shape_clip(r, &w);
        hits_open(&hits, &w);
        pel_surface_clip(&hits.surface, &clip);
        assert_int_equal(pel_polygon(&hits.surface, &outline, &hits.paint,
                                     scratch, pel_polygon_scratch_size(n)),
                         PEL_OK);
        hits_check(&hits, in_polygon, &outline, "polygon");
        covered += hits.pixels;
    }
    assert_true(cases_alone() || covered > 0);
}

TEST(polygons)
{
    static const struct {
        generator *generate;
        uint64_t count;
    } rows[] = {{shape_random, 10000}, {shape_adversarial, 10000},
                {pixels, 6000},        {star, 4500},
                {spiral, 4500},        {comb, 6000},
                {repeat, 4500}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        check_polygons(rows[i].generate, rows[i].count);
}
