/* What an edge moves in a row, and its rise, against quotients of 64 bits. */
#include <stdio.h>

#include "core/smooth/smooth_edge.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

static void print_edge(const void *edge)
{
    const struct pel_point *const v = edge;
    fprintf(stderr, "from %d %d to %d %d\n", v[0].x, v[0].y, v[1].x, v[1].y);
}

/* 1/w as smooth_edge.h has it, rounded down. */
static uint64_t rise_of(uint64_t dx, uint64_t dy)
{
    if (dx <= dy >> 14 && dy > 0)
        return UINT64_C(16384) * 32640;
    return (dx < dy ? 32640 : PEL_SMOOTH_FULL) * dy / dx;
}

/* Up to 65,536 px, of many digits or of few. */
static int32_t random_way(struct random *r)
{
    return random_between(r, 0, (1 << random_between(r, 0, 24)) - 1);
}

/* A bit short is allowed, as in the bound of the header. */
static void check_edge(const struct pel_point v[2])
{
    struct pel_rise rise = {0xDEADBEEF, true};
    const uint64_t dx = (uint64_t)pel_magnitude(v[1].x - v[0].x);
    const uint64_t dy = (uint64_t)(v[1].y - v[0].y);
    const int64_t step = pel_smooth_slope(&v[0], &v[1], &rise);
    const uint64_t size = dy ? (dx << 32) / dy : 0, exact = rise_of(dx, dy);
    assert_int_equal(step, v[1].x < v[0].x ? -(int64_t)size : (int64_t)size);
    assert_int_equal(rise.steep, dx < dy);
    if (rise.value > exact || rise.value + 1 < exact)
        fail_msg("%u, not %llu; %s", rise.value, (unsigned long long)exact,
                 cases_replay());
}

TEST(edges)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        const int32_t dx = random_way(&c.random) + 1;
        const int32_t dy = random_way(&c.random);
        const int32_t turn = random_between(&c.random, 0, 3);
        const int32_t x = turn == 3 ? 0 : turn == 2 ? dy : dx;
        struct pel_point v[2] = {{-8388608, -8388608}, {0, 0}};
        v[0].x += turn == 0 ? x : 0;
        v[1].x = turn == 0 ? v[0].x - x : v[0].x + x;
        v[1].y = v[0].y + (turn == 3 ? dy + 1 : dy);
        cases_keep(print_edge, v, sizeof v);
        if (x > 0 || turn == 3)
            check_edge(v);
    }
}
