/* Smooth polygons against their exact area: within .5 + .02 k of 255 for k
 * edges in a pixel. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/smooth/smooth_polygon.h"
#include "core/smooth/smooth_rectangle.h"
#include "core/smooth/smooth_thick_line.h"
#include "drivers/crc.h"
#include "tests/support/check.h"
#include "tests/support/exact_area.h"
#include "tests/support/layouts.h"
#include "tests/support/shapes.h"

enum { SIZE = 24 };

static uint8_t pixels[SIZE * SIZE];
static struct pel_surface window;
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

static void open_window(const struct pel_rect *bounds)
{
    memset(pixels, 0, sizeof pixels);
    assert_int_equal(
        pel_surface_init(&window, &pel_gray8, pixels, sizeof pixels, bounds),
        PEL_OK);
}

static void check_coverage(const struct pel_point *v, int32_t n)
{
    const struct pel_rect *b = &window.bounds;
    for (int32_t y = b->y0; y < b->y1; y++)
        for (int32_t x = b->x0; x < b->x1; x++) {
            int edges;
            const long double area = exact_area(v, n, x, y, &edges);
            const int got = pel_surface_line(&window, y)[x - b->x0];
            const long double off = got - 255 * area;
            const long double error = off < 0 ? -off : off;
            if (error > .5L + .02L * edges + 1e-9L) {
                for (int32_t i = 0; i < n; i++)
                    print_error("%d %d\n", v[i].x, v[i].y);
                fail_msg("(%d, %d): %d, not %.3Lf, %d edges: %s", x, y, got,
                         255 * area, edges, cases_replay());
            }
        }
}

static void check_polygon(const struct pel_polygon_shape *p)
{
    const struct pel_rect *b = &window.bounds;
    for (int32_t y = b->y0; y < b->y1; y++)
        for (int32_t x = b->x0; x < b->x1; x++) {
            int pieces;
            const long double area = exact_polygon_area(p, x, y, &pieces);
            const int got = pel_surface_line(&window, y)[x - b->x0];
            const long double off = got - 255 * area;
            if ((off < 0 ? -off : off) > .5L + .02L * pieces + 1e-9L) {
                for (int32_t i = 0; i < p->n; i++)
                    print_error("%d %d\n", p->v[i].x, p->v[i].y);
                fail_msg("(%d, %d): %d, not %.3Lf, %d pieces: %s", x, y, got,
                         255 * area, pieces, cases_replay());
            }
        }
}

TEST(triangles)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct pel_point v[3];
        if (random_word(&c.random) % 2)
            shape_adversarial(&c.random, v, 3);
        else
            shape_random(&c.random, v, 3);
        const struct pel_rect bounds = shape_window(&c.random, v, 3, SIZE);
        open_window(&bounds);
        pel_smooth_triangle(&window, v, &white.paint);
        check_coverage(v, 3);
    }
}

/* Their convex hull, clockwise on screen: how many points it has. */
static int32_t hull_of(struct pel_point *v, int32_t n, struct pel_point *hull)
{
    int32_t count = 0, at = 0;
    for (int32_t i = 1; i < n; i++)
        if (v[i].y < v[at].y || (v[i].y == v[at].y && v[i].x < v[at].x))
            at = i;
    const int32_t first = at;
    do {
        int32_t next = at == 0 ? n - 1 : 0;
        hull[count++] = v[at];
        for (int32_t i = 0; i < n; i++) {
            const int64_t bx = v[next].x - v[at].x, by = v[next].y - v[at].y;
            const int64_t cx = v[i].x - v[at].x, cy = v[i].y - v[at].y;
            const int64_t cross = bx * cy - by * cx;
            if (cross < 0 ||
                (cross == 0 && cx * cx + cy * cy > bx * bx + by * by))
                next = i;
        }
        at = next;
    } while ((v[at].x != v[first].x || v[at].y != v[first].y) && count < n);
    return count;
}

/* Points near an ellipse, from tiny ones with all edges in a pixel on. */
static void around(struct random *r, struct pel_point *v, int32_t n)
{
    const int32_t rx = random_between(r, 1, 1 << random_between(r, 1, 14));
    const int32_t ry = random_between(r, 1, 1 << random_between(r, 1, 14));
    const int32_t x = random_between(r, -999, 999),
                  y = random_between(r, 0, 99);
    for (int32_t i = 0; i < n; i++) {
        const struct pel_point d = pel_direction((uint16_t)(65536 * i / n));
        v[i].x = x + (int32_t)((int64_t)rx * d.x / PEL_DIRECTION_ONE);
        v[i].y = y + (int32_t)((int64_t)ry * d.y / PEL_DIRECTION_ONE);
    }
}

TEST(convex_polygons)
{
    enum { POINTS = 64 };
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_point v[POINTS], hull[POINTS];
        const int32_t points = random_between(r, 3, POINTS);
        const uint32_t kind = random_word(r) % 4;
        if (kind == 0)
            shape_adversarial(r, v, points);
        else if (kind == 1)
            shape_random(r, v, points);
        else
            around(r, v, points);
        const int32_t n = hull_of(v, points, hull);
        const struct pel_rect bounds = shape_window(r, v, points, SIZE);
        open_window(&bounds);
        pel_smooth_convex(&window, hull, n, &white.paint);
        check_coverage(hull, n);
    }
}

static struct pel_point point_near(struct random *r, struct pel_point at)
{
    const int32_t e = random_between(r, 0, 1 << random_between(r, 0, 12));
    return (struct pel_point){shape_legal(at.x + random_between(r, -e, e)),
                              shape_legal(at.y + random_between(r, -e, e))};
}

TEST(rectangles)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_point v[4];
        shape_adversarial(r, v, 2);
        v[2] = random_word(r) % 2 ? v[1] : point_near(r, v[0]);
        v[1] = (struct pel_point){v[2].x, v[0].y};
        v[3] = (struct pel_point){v[0].x, v[2].y};
        const struct pel_rect bounds = shape_window(r, v, 4, SIZE);
        open_window(&bounds);
        pel_smooth_rectangle(&window, v[0], v[2], &white.paint);
        if (v[0].x < v[2].x && v[0].y < v[2].y)
            check_coverage(v, 4);
        else
            check_coverage(v, 0);
    }
}

/* The corners of a line with square ends. */
static void lengthen(const struct pel_thick_line_shape *line,
                     struct pel_point v[4])
{
    const struct pel_point n = {v[0].x - line->from.x, v[0].y - line->from.y};
    for (int i = 0; i < 4; i++) {
        const int sign = i == 1 || i == 2 ? 1 : -1;
        v[i].x += sign * n.y;
        v[i].y -= sign * n.x;
    }
}

TEST(thick_lines)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_thick_line_shape line;
        struct pel_point v[4], ends[2];
        shape_adversarial(r, ends, 2);
        line.from = ends[0];
        line.to = random_word(r) % 4 ? point_near(r, ends[0]) : ends[1];
        line.width = random_between(r, 0, 1 << random_between(r, 0, 12));
        const bool square = random_word(r) % 2;
        if (!pel_thick_line_corners(&line, v))
            continue;
        if (square)
            lengthen(&line, v);
        if (!pel_points_legal(v, 4))
            continue;
        const struct pel_rect bounds = shape_window(r, v, 4, SIZE);
        open_window(&bounds);
        if (square)
            pel_smooth_thick_line_square(&window, &line, &white.paint);
        else
            pel_smooth_thick_line(&window, &line, &white.paint);
        check_coverage(v, 4);
    }
}

static void draw_round_line(struct pel_thick_line_shape line, int32_t x,
                            int32_t shift)
{
    const struct pel_rect bounds = {x + shift, 0, x + shift + SIZE, SIZE};
    line.from.x += PEL_PX(shift);
    line.to.x += PEL_PX(shift);
    open_window(&bounds);
    pel_smooth_thick_line_round(&window, &line, &white.paint);
}

static void print_line(const void *line)
{
    const struct pel_thick_line_shape *const l = line;
    printf("(%d, %d) (%d, %d) %d", l->from.x, l->from.y, l->to.x, l->to.y,
           l->width);
}

/* Sides of legal lines may lie beyond the range of their ends. */
TEST(round_lines_at_the_limits)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *const r = &c.random;
        const bool right = random_word(r) % 2;
        const int32_t x = right ? 32768 - SIZE : -32768;
        const int32_t from = right ? PEL_PX(32768) - 400 : -PEL_PX(32768);
        const struct pel_thick_line_shape line = {
            {random_between(r, from, from + 399),
             random_between(r, 0, PEL_PX(SIZE))},
            {random_between(r, from, from + 399),
             random_between(r, 0, PEL_PX(SIZE))},
            random_between(r, 1, 300)};
        uint8_t there[sizeof pixels];
        cases_keep(print_line, &line, sizeof line);
        draw_round_line(line, x, 0);
        memcpy(there, pixels, sizeof there);
        draw_round_line(line, x, right ? -40 : 40);
        assert_memory_equal(there, pixels, sizeof there);
    }
}

/* Flat edges, which cross many pixels in a row, and ends on the sides of rows,
 * too. */
static void draw_straight(struct random *r, uint32_t kind)
{
    struct pel_point v[3];
    for (int i = 0; i < 3; i++) {
        v[i].x = random_between(r, -PEL_PX(40), PEL_PX(40));
        v[i].y = random_between(r, -PEL_PX(9), PEL_PX(SIZE));
        v[i].y &= random_word(r) % 2 ? -1 : ~255;
    }
    const struct pel_thick_line_shape line = {v[0], v[1],
                                              random_between(r, 1, 700)};
    if (kind == 0)
        pel_smooth_thick_line(&window, &line, &white.paint);
    else if (kind == 1)
        pel_smooth_rectangle(&window, v[0], v[1], &white.paint);
    else
        pel_smooth_triangle(&window, v, &white.paint);
}

/* Core shows the same in every build, whatever its knobs. */
TEST(every_build_draws_the_same)
{
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    uint32_t crc = 0;
    for (uint64_t i = 0; i < 20000; i++) {
        struct random r = {i * i};
        open_window(&bounds);
        draw_straight(&r, i % 4);
        crc = pel_crc(crc, pixels, sizeof pixels);
    }
    assert_int_equal(crc, 0x750D912C);
}

TEST(polygons)
{
    enum { POINTS = 9 };
    static uint64_t
        scratch[PEL_SMOOTH_POLYGON_SCRATCH_SIZE(POINTS, SIZE) / 8 + 1];
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_point v[POINTS];
        const struct pel_polygon_shape p = {v, random_between(r, 3, POINTS),
                                            random_word(r) % 2 ? PEL_EVEN_ODD
                                                               : PEL_NON_ZERO};
        const uint32_t kind = random_word(r) % 4;
        if (kind == 0)
            shape_random(r, v, p.n);
        else if (kind == 1)
            shape_adversarial(r, v, p.n);
        for (int32_t i = 0; kind > 1 && i < p.n; i++)
            v[i] = point_near(r, (struct pel_point){0, 0});
        const struct pel_rect bounds = shape_window(r, v, p.n, SIZE);
        open_window(&bounds);
        memset(scratch, (int)random_word(r), sizeof scratch);
        assert_int_equal(pel_smooth_polygon(&window, &p, &white.paint, scratch,
                                            sizeof scratch),
                         PEL_OK);
        check_polygon(&p);
    }
}

static int sum[SIZE * SIZE], tiles[SIZE * SIZE];

static void add_tile(const struct pel_rect *bounds, const struct pel_point *v,
                     int32_t n)
{
    open_window(bounds);
    pel_smooth_convex(&window, v, n, &white.paint);
    for (int i = 0; i < SIZE * SIZE; i++) {
        sum[i] += pixels[i];
        tiles[i] += pixels[i] > 0;
    }
}

/* A box around the window, clockwise. */
static void box_around(struct random *r, const struct pel_rect *bounds,
                       struct pel_point c[4])
{
    const int32_t margin = PEL_PX(1 << random_between(r, 0, 10));
    const int32_t x0 = PEL_PX(bounds->x0) - random_between(r, 256, margin);
    const int32_t y0 = PEL_PX(bounds->y0) - random_between(r, 256, margin);
    const int32_t x1 = PEL_PX(bounds->x1) + random_between(r, 256, margin);
    const int32_t y1 = PEL_PX(bounds->y1) + random_between(r, 256, margin);
    c[0] = (struct pel_point){x0, y0};
    c[1] = (struct pel_point){x1, y0};
    c[2] = (struct pel_point){x1, y1};
    c[3] = (struct pel_point){x0, y1};
}

/* Both sides of a line: 255, or 256 where the halves of a step are rounded up;
 * four triangles around a point: within half a step for each in the pixel, one
 * of which may be rounded to 0. */
TEST(tiles_add_up)
{
    const struct pel_rect bounds = {-5, 3, SIZE - 5, SIZE + 3};
    for (struct cases cases = cases_of(20000); cases_next(&cases);) {
        struct random *r = &cases.random;
        const bool halves = random_word(r) % 2;
        struct pel_point c[4],
            p = {random_between(r, -1280, 4864), random_between(r, 768, 6912)};
        box_around(r, &bounds, c);
        const struct pel_point left = {c[0].x, random_between(r, 768, 6912)};
        const struct pel_point right = {c[1].x, random_between(r, 768, 6912)};
        memset(sum, 0, sizeof sum);
        memset(tiles, 0, sizeof tiles);
        if (halves) {
            add_tile(&bounds, (struct pel_point[]){c[0], c[1], right, left}, 4);
            add_tile(&bounds, (struct pel_point[]){right, c[2], c[3], left}, 4);
        }
        for (int i = 0; i < 4 && !halves; i++)
            add_tile(&bounds, (struct pel_point[]){p, c[i], c[(i + 1) % 4]}, 3);
        for (int i = 0; i < SIZE * SIZE; i++) {
            const int off = sum[i] - 255;
            if (halves ? off != 0 && off != 1 : 2 * abs(off) > tiles[i] + 1)
                fail_msg("pixel %d: %d of %d tiles: %s", i, sum[i], tiles[i],
                         cases_replay());
        }
    }
}

/* A broken promise covers something inside of its box, and is no undefined
 * behaviour: here neither side crosses some row. */
TEST(outlines_that_are_not_convex)
{
    static const struct pel_point v[] = {{1659, 8388352}, {5405603, -902},
                                         {8480, -623},    {23910, -3031589},
                                         {7198, 26725},   {-54081, 11283}};
    const struct pel_rect bounds = {13264, 24136, 13274, 24150};
    open_window(&bounds);
    pel_smooth_convex(&window, v, 6, &white.paint);
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct pel_point w[7];
        const int32_t n = random_between(&c.random, 3, 7);
        shape_random(&c.random, w, n);
        const struct pel_rect seen = shape_window(&c.random, w, n, SIZE);
        const struct pel_rect box = pel_points_box(w, n);
        open_window(&seen);
        pel_smooth_convex(&window, w, n, &white.paint);
        for (int32_t y = seen.y0; y < seen.y1; y++)
            for (int32_t x = seen.x0; x < seen.x1; x++)
                if (pel_surface_line(&window, y)[x - seen.x0] &&
                    (x < pel_pixel_of(box.x0) || x > pel_pixel_of(box.x1) ||
                     y < pel_pixel_of(box.y0) || y > pel_pixel_of(box.y1)))
                    fail_msg("(%d, %d): %s", x, y, cases_replay());
    }
}
