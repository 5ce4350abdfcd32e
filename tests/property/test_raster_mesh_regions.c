/* Polygons of many vertices that share their sides with others: meshes in which
 * one takes all cells below a skyline that follows the grid, and triangles take
 * the others; and the inside and the outside of an outline that crosses itself.
 * Every pixel is hit once. */
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/shapes.h"

enum { COLUMNS = 32, ROWS = 12, POINTS = (COLUMNS + 1) * (ROWS + 2) };

static struct hits hits;

/* Inner corners are moved by less than a quarter of a cell. */
struct mesh {
    struct pel_point v[ROWS + 1][COLUMNS + 1];
    int32_t height[COLUMNS]; /* cells below the skyline, 0 to ROWS */
    struct pel_rect outline;
};

static int32_t shaken(struct random *r, int32_t v, int32_t i, int32_t last,
                      int32_t shake)
{
    return i > 0 && i < last ? v + random_between(r, -shake, shake) : v;
}

static void mesh_random(struct random *r, struct mesh *m)
{
    static const int32_t cells[] = {128, 256, 384, 640, 1000};
    const int32_t cell = cells[random_word(r) % 5];
    const int32_t shake = random_word(r) % 3 ? cell / 4 - 1 : 0;
    const struct pel_point o = {random_between(r, -9000, 9000) & ~127,
                                random_between(r, -900, 900) & ~127};
    for (int32_t j = 0; j <= ROWS; j++)
        for (int32_t i = 0; i <= COLUMNS; i++)
            m->v[j][i] =
                (struct pel_point){shaken(r, o.x + i * cell, i, COLUMNS, shake),
                                   shaken(r, o.y + j * cell, j, ROWS, shake)};
    for (int32_t i = 0; i < COLUMNS; i++)
        m->height[i] = random_between(r, 0, ROWS);
    m->outline =
        (struct pel_rect){o.x, o.y, o.x + COLUMNS * cell, o.y + ROWS * cell};
}

/* Along the bottom to the left, then over the skyline to the right, by every
 * corner of the grid on the way. */
static int32_t region_of(const struct mesh *m, struct pel_point *v)
{
    int32_t n = 0, j = ROWS;
    for (int32_t i = COLUMNS; i >= 0; i--)
        v[n++] = m->v[ROWS][i];
    for (int32_t i = 0; i < COLUMNS; i++) {
        const int32_t top = ROWS - m->height[i];
        while (j != top) {
            j += j < top ? 1 : -1;
            v[n++] = m->v[j][i];
        }
        v[n++] = m->v[j][i + 1];
    }
    while (j < ROWS - 1)
        v[n++] = m->v[++j][COLUMNS];
    return n;
}

static void draw_cells_above(const struct mesh *m)
{
    for (int32_t i = 0; i < COLUMNS; i++)
        for (int32_t j = 0; j < ROWS - m->height[i]; j++) {
            const struct pel_point q[4] = {m->v[j][i], m->v[j][i + 1],
                                           m->v[j + 1][i + 1], m->v[j + 1][i]};
            const int32_t k = (i + j) % 2;
            const struct pel_point a[3] = {q[k], q[k + 1], q[k + 2]};
            const struct pel_point b[3] = {q[k + 2], q[(k + 3) % 4], q[k]};
            pel_triangle(&hits.surface, a, &hits.paint);
            pel_triangle(&hits.surface, b, &hits.paint);
        }
}

static void draw_polygon(const struct pel_point *v, int32_t n,
                         enum pel_fill_rule rule)
{
    static uint32_t scratch[9 * POINTS];
    const struct pel_polygon_shape p = {v, n, rule};
    assert_int_equal(
        pel_polygon(&hits.surface, &p, &hits.paint, scratch, sizeof scratch),
        PEL_OK);
}

static bool in_outline(const void *outline, int32_t x, int32_t y)
{
    const struct pel_rect *o = outline;
    const int32_t px = x * 256 + 128, py = y * 256 + 128;
    return o->x0 <= px && px < o->x1 && o->y0 <= py && py < o->y1;
}

static void open_around(const struct pel_rect *o)
{
    const struct pel_rect b = {pel_pixel_of(o->x0) - 2, pel_pixel_of(o->y0) - 2,
                               pel_pixel_of(o->x1) + 2,
                               pel_pixel_of(o->y1) + 2};
    hits_open(&hits, &b);
}

static void test_skylines(void)
{
    static struct pel_point region[POINTS];
    struct mesh m;
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        mesh_random(&c.random, &m);
        open_around(&m.outline);
        const int32_t n = region_of(&m, region);
        assert_in_range(n, 2 * COLUMNS + 2, POINTS);
        draw_polygon(region, n, c.next % 2 ? PEL_EVEN_ODD : PEL_NON_ZERO);
        draw_cells_above(&m);
        hits_check(&hits, in_outline, &m.outline, "skyline");
    }
}

/* The outline once more, then to a corner of the square, around it, and back
 * the same way. */
static int32_t add_square(struct pel_point *v, int32_t n,
                          const struct pel_rect *o)
{
    const struct pel_point corner[5] = {{o->x0, o->y0},
                                        {o->x1, o->y0},
                                        {o->x1, o->y1},
                                        {o->x0, o->y1},
                                        {o->x0, o->y0}};
    v[n++] = v[0];
    for (int i = 0; i < 5; i++)
        v[n++] = corner[i];
    return n;
}

/* By even-odd the outline and the outline with the square are each other's
 * complement in the square. */
static void test_inside_and_outside(void)
{
    enum { MOST = 300 };
    const struct pel_rect px = {-20, -20, 20, 20};
    const struct pel_rect square = {PEL_PX(-20), PEL_PX(-20), PEL_PX(20),
                                    PEL_PX(20)};
    struct pel_point v[MOST + 6];
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        const int32_t n = random_between(&c.random, 3, MOST);
        shape_in_box(&c.random, v, n, &px);
        open_around(&square);
        draw_polygon(v, n, PEL_EVEN_ODD);
        draw_polygon(v, add_square(v, n, &square), PEL_EVEN_ODD);
        hits_check(&hits, in_outline, &square, "inside and outside");
    }
}

int main(void)
{
    return RUN_TESTS(test_skylines, test_inside_and_outside);
}
