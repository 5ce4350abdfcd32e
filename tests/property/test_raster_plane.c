/* Planes of values over triangles, slivers above all, at every pixel that is
 * covered; and what affine textures are off by. */
#include "core/pel.h"
#include "core/raster/plane.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"
#include "tests/support/reference.h"
#include "tests/support/reference_scene.h"

static int32_t lowest(const struct pel_point v[3], bool x)
{
    return x ? pel_min(pel_min(v[0].x, v[1].x), v[2].x) >> 8
             : pel_min(pel_min(v[0].y, v[1].y), v[2].y) >> 8;
}

static int32_t highest(const struct pel_point v[3], bool x)
{
    return x ? pel_max(pel_max(v[0].x, v[1].x), v[2].x) >> 8
             : pel_max(pel_max(v[0].y, v[1].y), v[2].y) >> 8;
}

/* A triangle whose third vertex is `thickness` sub-pixels beside an edge, or
 * anywhere. */
static void any_triangle(struct random *r, struct pel_point v[3],
                         int32_t thickness)
{
    const int32_t side = random_between(r, 300, 40000);
    const int32_t x = random_between(r, -8000000, 8000000);
    const int32_t y = random_between(r, -8000000, 8000000);
    const int32_t part = random_between(r, 0, 256);
    for (int i = 0; i < 3; i++) {
        v[i].x = x + random_between(r, -side, side);
        v[i].y = y + random_between(r, -side, side);
    }
    if (thickness) {
        v[2].x = v[0].x + (v[1].x - v[0].x) / 256 * part +
                 random_between(r, -thickness, thickness);
        v[2].y = v[0].y + (v[1].y - v[0].y) / 256 * part +
                 random_between(r, -thickness, thickness);
    }
}

/* The largest error of a plane at the covered pixels. */
static real worst_error(const struct pel_point v[3], const int32_t value[3],
                        uint64_t *pixels)
{
    struct pel_plane_setup setup;
    struct pel_plane plane;
    real worst = 0, w[3];
    if (!pel_plane_start(&setup, v))
        return 0;
    pel_plane_set(&plane, &setup, value);
    for (int32_t y = lowest(v, false); y <= highest(v, false); y++)
        for (int32_t x = lowest(v, true); x <= highest(v, true); x++) {
            if (!reference_triangle_at(v, x, y))
                continue;
            reference_weights(v, x, y, w);
            const real want =
                w[0] * value[0] + w[1] * value[1] + w[2] * value[2];
            const real got =
                (real)(int64_t)pel_plane_at(&plane, x, y) / (1 << 24);
            worst = real_abs(got - want) > worst ? real_abs(got - want) : worst;
            (*pixels)++;
        }
    return worst;
}

static void check_planes(uint64_t count, int32_t thickness, real allowed)
{
    uint64_t pixels = 0;
    real worst = 0;
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct pel_point v[3];
        int32_t value[3];
        any_triangle(&c.random, v, thickness);
        shape_keep(v, 3);
        for (int i = 0; i < 3; i++)
            value[i] = random_between(&c.random, -(1 << 30), (1 << 30) - 1);
        const real error = worst_error(v, value, &pixels);
        worst = error > worst ? error : worst;
        if (error > allowed)
            fail_msg("off by %.6f; %s", (double)error, cases_replay());
    }
    print_message("%llu pixels, off by 2^30 times %.2g at most\n",
                  (unsigned long long)pixels, (double)worst / (1 << 30));
    assert_true(cases_alone() || pixels > 0);
}

TEST(triangles)
{
    check_planes(200, 0, 1.0L / 64);
}

TEST(slivers)
{
    check_planes(500, 40, 1.0L / 64);
    check_planes(1500, 1, 1.0L * (1 << 13));
}

/* u over a triangle whose 1 / z is w. */
TEST(affine_is_off_by_its_bound)
{
    real tightest = 0;
    for (struct cases c = cases_of(400); cases_next(&c);) {
        const real r = 1 + random_between(&c.random, 1, 3000) / 1000.0L;
        const struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(400, 0),
                                       PEL_AT(0, 9)};
        const int32_t u[3] = {0, 1 << 28,
                              random_between(&c.random, 0, 1 << 28)};
        const real w[3] = {
            r, 1, 1 + (r - 1) * random_between(&c.random, 0, 100) / 100};
        struct pel_plane_setup setup;
        struct pel_plane plane;
        real at[3], root = real_root(r);
        const real bound = (root - 1) / (root + 1);
        shape_keep(v, 3);
        pel_plane_start(&setup, v);
        pel_plane_set(&plane, &setup, u);
        for (int32_t x = 0; x < 400; x++) {
            reference_weights(v, x, 0, at);
            const real sum = at[0] * w[0] + at[1] * w[1] + at[2] * w[2];
            const real exact =
                (at[1] * w[1] * u[1] + at[2] * w[2] * u[2]) / sum;
            const real off =
                real_abs((real)(int64_t)pel_plane_at(&plane, x, 0) / (1 << 24) -
                         exact) /
                (1 << 28);
            tightest = off / bound > tightest ? off / bound : tightest;
            if (off > bound + 1e-6L)
                fail_msg("ratio %.3f, pixel %d: off by %.5f of the texels, "
                         "allowed %.5f; %s",
                         (double)r, x, (double)off, (double)bound,
                         cases_replay());
        }
    }
    print_message("at most %.4f of the bound\n", (double)tightest);
    assert_true(cases_alone() || tightest > 0.95L);
}
