/* Arithmetic of the 3-D pipeline, of which there are two where products of 64
 * bits are long: both give these numbers. */
#include "core/raster/plane.h"
#include "core/scene/vector.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/reference.h"
#include "tests/support/reference_scene.h"

static int64_t any_number(struct random *r, int bits)
{
    const uint64_t word = (uint64_t)random_word(r) << 32 | random_word(r);
    const int64_t v = (int64_t)(word >> (64 - bits));
    return random_word(r) % 2 ? v : -v;
}

/* The quotient of gradients, cut towards zero. */
static uint64_t cut(wide n, wide area)
{
    const wide q = (n < 0 ? -n : n) / area;
    return (uint64_t)(n < 0 ? -q : q);
}

/* From area 1 to the largest; values up to the largest of all. */
TEST(gradients_are_exact)
{
    for (struct cases c = cases_of(200000); cases_next(&c);) {
        struct random *r = &c.random;
        const int bits = random_between(r, 1, 23);
        struct pel_plane_setup s;
        struct pel_plane plane;
        struct pel_point v[3];
        int32_t value[3];
        for (int i = 0; i < 3; i++) {
            v[i].x = (int32_t)any_number(r, bits);
            v[i].y = (int32_t)any_number(r, bits);
            value[i] = (int32_t)any_number(r, random_between(r, 1, 30));
        }
        if (random_word(r) % 2) { /* a sliver */
            v[2].x = v[0].x + (v[1].x - v[0].x) / 2;
            v[2].y = v[0].y + (v[1].y - v[0].y) / 2;
        }
        if (!pel_plane_start(&s, v))
            continue;
        pel_plane_set(&plane, &s, value);
        const int second = s.first == 2 ? 0 : s.first + 1;
        const int third = 3 - s.first - second;
        const wide b = value[second] - (wide)value[s.first];
        const wide d = value[third] - (wide)value[s.first];
        const wide bx = v[second].x - s.a.x, by = v[second].y - s.a.y;
        const wide dx = v[third].x - s.a.x, dy = v[third].y - s.a.y;
        const wide sign = bx * dy < dx * by ? -1 : 1;
        const wide nx = (b * dy - d * by) * sign;
        const wide ny = (d * bx - b * dx) * sign;
        const wide area = (bx * dy - dx * by) * sign;
        if (plane.dx != cut(nx * ((wide)1 << 32), area) ||
            plane.dy != cut(ny * ((wide)1 << 32), area))
            fail_msg("gradients of area %llu; %s", (unsigned long long)s.area,
                     cases_replay());
        if (pel_plane_at(&plane, v[s.first].x >> 8, v[s.first].y >> 8) !=
            ((uint64_t)(int64_t)value[s.first] << 24) +
                cut(nx * (1 << 24), area) *
                    (uint64_t)(int64_t)(128 - (v[s.first].x & 255)) +
                cut(ny * (1 << 24), area) *
                    (uint64_t)(int64_t)(128 - (v[s.first].y & 255)))
            fail_msg("anchor; %s", cases_replay());
    }
}

static real worst_part(const int64_t v[3], const pel_cosine unit[3])
{
    const real length =
        real_root((real)v[0] * v[0] + (real)v[1] * v[1] + (real)v[2] * v[2]);
    real worst = 0;
    for (int k = 0; k < 3; k++) {
        const real off = unit[k] / (real)PEL_COSINE_ONE - v[k] / length;
        worst = off > worst ? off : -off > worst ? -off : worst;
    }
    return worst;
}

TEST(directions)
{
    real exact = 0, near = 0;
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *r = &c.random;
        const int bits = random_between(r, 1, 62);
        int64_t v[3];
        pel_cosine unit[3];
        for (int k = 0; k < 3; k++)
            v[k] = any_number(r, random_word(r) % 4 ? bits : 1);
        if (bits > 31 && random_word(r) % 2) { /* what is rounded most */
            const int64_t half = INT64_C(1) << (bits - 31);
            for (int k = 0; k < 3; k++)
                v[k] =
                    any_number(r, random_between(r, 1, 28)) * 2 * half + half;
            v[random_word(r) % 3] = half << 30;
        }
        if (!pel_normalize(v, unit))
            continue;
        real off = worst_part(v, unit);
        exact = off > exact ? off : exact;
        if (bits > 30)
            continue;
        const int32_t small[3] = {(int32_t)v[0], (int32_t)v[1], (int32_t)v[2]};
        assert_true(pel_normalize_fast(small, unit));
        off = worst_part(v, unit);
        near = off > near ? off : near;
    }
    print_message("off by %.3f 2^-29 and %.3f 2^-21 at most\n",
                  (double)(exact * (1 << 29)), (double)(near * (1 << 21)));
    assert_true(exact < 1.0L / (1 << 28) && near < 1.0L / (1 << 21));
}
