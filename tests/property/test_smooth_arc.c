/* Smooth arcs where a place on a ray is hard to find: near the axes, large
 * ones, and whole turns. */
#include <stdio.h>
#include <string.h>

#include "core/smooth/smooth_arc.h"
#include "core/smooth/smooth_ring.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/round_area.h"

static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

static void print_arc(const void *arc)
{
    const struct pel_arc_shape *const a = arc;
    fprintf(stderr, "center %d %d radius %d inner %d angles %d to %d\n",
            a->center.x, a->center.y, a->outer, a->inner, a->from, a->to);
}

/* Pixels around the place of an arc at a direction and a distance. */
static void check_end(const struct round *s, int32_t angle, int32_t distance)
{
    enum { SIDE = 8 };
    const struct pel_point d = pel_direction((uint16_t)angle);
    const int32_t x = (int32_t)((int64_t)distance * d.x >> 23) - SIDE / 2;
    const int32_t y = (int32_t)((int64_t)distance * d.y >> 23) - SIDE / 2;
    const int32_t x0 = pel_max(-32767, pel_min(x, 32766 - SIDE));
    const int32_t y0 = pel_max(-32767, pel_min(y, 32766 - SIDE));
    const struct pel_rect b = {x0, y0, x0 + SIDE, y0 + SIDE};
    const struct pel_arc_shape arc = {s->center, s->inner, s->radius, s->from,
                                      s->from + s->turn};
    uint8_t pixels[SIDE * SIDE] = {0};
    struct pel_surface surface;
    pel_surface_init(&surface, &pel_gray8, pixels, sizeof pixels, &b);
    if (s->kind == ARC_ROUND)
        pel_smooth_arc_round(&surface, &arc, &white.paint);
    else
        pel_smooth_arc(&surface, &arc, &white.paint);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const real area = 255 * round_area_at(s, x0 + i % SIDE, y0 + i / SIDE);
        if (real_abs(pixels[i] - area) > 1)
            fail_msg("pixel %d: %d, not %.3Lf; center %d, radius %d, inner %d, "
                     "angles %d + %d",
                     i, pixels[i], area, s->center.y, s->radius, s->inner,
                     s->from, s->turn);
    }
}

/* Corners of arcs so large that a first guess is a pixel off, near the axes:
 * most so by what a radius has beyond whole pixels. */
TEST(ends_of_large_arcs)
{
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct round s = {
            ARC,
            {0, random_between(r, 0, 255)},
            {0, 0},
            PEL_PX(32766) + (random_between(r, -20, 20) & 255),
            random_between(r, 0, PEL_PX(32766)),
            random_between(r, 0, 3) * 16384 + random_between(r, -3000, 3000),
            random_between(r, 20000, 40000)};
        const struct pel_arc_shape arc = {s.center, s.inner, s.radius, s.from,
                                          s.from + s.turn};
        cases_keep(print_arc, &arc, sizeof arc);
        check_end(&s, s.from, s.radius);
    }
}

/* Half discs that begin beside an axis: hardly any of a quarter, or nothing. */
TEST(round_ends_beside_axes)
{
    for (int i = 0; i < 36; i++) {
        const struct round s = {ARC_ROUND,
                                {0, 0},
                                {0, 0},
                                PEL_PX(3000),
                                PEL_PX(1000),
                                i / 9 * 16384 + i % 3 - 1,
                                16384 + i / 3 % 3 - 1};
        for (int k = 0; k < 4; k++) {
            const int32_t angle = s.from + (k & 1 ? s.turn : 0);
            if (!round_between_places(&s, angle))
                check_end(&s, angle, k & 2 ? s.inner : s.radius);
        }
    }
}

/* And nothing, where the inner radius is the larger one. */
TEST(arcs_of_a_turn_are_rings)
{
    enum { SIDE = 24 };
    static const struct pel_rect bounds = {0, 0, SIDE, SIDE};
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *const r = &c.random;
        const int32_t from = random_between(r, -70000, 70000);
        const int32_t radius = random_between(r, 1, 4000);
        const struct pel_arc_shape arc = {
            {random_between(r, 0, 6000), random_between(r, 0, 6000)},
            random_between(r, 0, radius * 5 / 4),
            radius,
            from,
            from + 65536};
        const struct pel_ring_shape ring = {arc.center, arc.inner, radius};
        cases_keep(print_arc, &arc, sizeof arc);
        uint8_t pixels[2][SIDE * SIDE] = {{0}};
        struct pel_surface surface;
        pel_surface_init(&surface, &pel_gray8, pixels[0], sizeof pixels[0],
                         &bounds);
        if (random_word(r) % 2)
            pel_smooth_arc(&surface, &arc, &white.paint);
        else
            pel_smooth_arc_round(&surface, &arc, &white.paint);
        surface.pixels = pixels[1];
        pel_smooth_ring(&surface, &ring, &white.paint);
        if (memcmp(pixels[0], pixels[1], sizeof pixels[0]) != 0)
            fail_msg("%s", cases_replay());
    }
}
