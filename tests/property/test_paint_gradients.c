/* The colours of gradients with stops: within 1 of the exactly rounded colour,
 * but for 1/256 px around a jump. */
#include "core/paint/paint_conic.h"
#include "core/paint/paint_linear.h"
#include "core/paint/paint_radial.h"
#include "tests/support/check.h"
#include "tests/support/paint_cells.h"

static struct histogram errors[3] = {
    {.name = "linear_color", .step = 1.0L / 32},
    {.name = "radial_color", .step = 1.0L / 32},
    {.name = "conic_color", .step = 1.0L / 32}};

struct gradient {
    int kind; /* 0 linear, 1 radial, 2 conic */
    struct pel_point at, to;
    int32_t radius;
    struct pel_stop stops[6];
    int32_t count;
    pel_color colors[2048];
    struct pel_ramp ramp;
    union {
        struct pel_linear linear;
        struct pel_radial radial;
        struct pel_conic conic;
    } paint;
};

/* Stops without hard edges, as many cells as the steepest channel asks for. */
static void random_ramp(struct random *r, struct gradient *g)
{
    real slope = 0;
    int32_t at = 0;
    g->count = random_between(r, 2, 6);
    for (int32_t i = 0; i < g->count; i++) {
        g->stops[i] = (struct pel_stop){at, random_word(r)};
        at = i == g->count - 2 ? 65536 : at + 65536 / (g->count - 1);
        for (int k = 0; i && k < 32; k += 8) {
            real a = g->stops[i - 1].color >> k & 255;
            real b = g->stops[i].color >> k & 255;
            real s =
                real_abs(b - a) * 65536 / (g->stops[i].at - g->stops[i - 1].at);
            slope = s > slope ? s : slope;
        }
    }
    int32_t n = pel_max(3, (int32_t)slope + 1);
    if (g->count == 2 && random_word(r) % 2) {
        n = 2;
        g->colors[0] = g->stops[0].color;
        g->colors[1] = g->stops[1].color;
    } else {
        assert_int_equal(pel_ramp_fill(g->colors, n, g->stops, g->count),
                         PEL_OK);
    }
    g->ramp =
        (struct pel_ramp){g->colors, n, (enum pel_spread)(random_word(r) % 3)};
}

static struct pel_color_paint *init(struct gradient *g)
{
    const struct pel_rings rings = {g->at, g->radius, 0};
    if (g->kind == 0) {
        assert_int_equal(
            pel_linear_init(&g->paint.linear, g->at, g->to, &g->ramp), PEL_OK);
        return &g->paint.linear.base;
    }
    if (g->kind == 1) {
        assert_int_equal(pel_radial_init(&g->paint.radial, &rings, &g->ramp),
                         PEL_OK);
        return &g->paint.radial.base;
    }
    assert_int_equal(pel_conic_init(&g->paint.conic, g->at, 0, &g->ramp),
                     PEL_OK);
    if (g->ramp.spread == PEL_PAD)
        g->ramp.spread = PEL_REPEAT;
    return &g->paint.conic.base;
}

/* t at a pixel, and how much of it is 1/256 px (of a conic, or 1e-5 turns). */
static real position(const struct gradient *g, int32_t x, int32_t y,
                     real *reach)
{
    real px = (real)pel_pixel_center(x) - g->at.x;
    real py = (real)pel_pixel_center(y) - g->at.y;
    real dx = (real)g->to.x - g->at.x, dy = (real)g->to.y - g->at.y;
    real square = dx * dx + dy * dy, way;
    if (g->kind == 0) {
        *reach = 1 / real_root(square);
        return (px * dx + py * dy) / square;
    }
    if (g->kind == 1) {
        *reach = 1.0L / g->radius;
        return real_root(px * px + py * py) / g->radius;
    }
    way = g->ramp.spread == PEL_REFLECT ? 2 : 1;
    *reach = 1e-5L * way;
    return real_turn(px, py) * way;
}

static real difference(const struct gradient *g, real t, int k, pel_color got)
{
    real want = stops_channel(g->stops, g->count, g->ramp.spread, t, k);
    return (real)(got >> 8 * k & 255) - want;
}

static void check_channel(const struct gradient *g, const int32_t at[2], int k,
                          pel_color got)
{
    real reach, t = position(g, at[0], at[1], &reach);
    real jump = t - real_round(t), error = difference(g, t, k, got);
    real rounded = (real)(got >> 8 * k & 255) -
                   real_round((real)(got >> 8 * k & 255) - error);
    if (real_abs(jump) > reach)
        histogram_add(&errors[g->kind], error);
    if (real_abs(rounded) <= 1)
        return;
    if (real_abs(jump) <= reach &&
        (real_abs(difference(g, t - 2 * jump, k, got)) < 1.5L ||
         real_abs(difference(g, t + reach, k, got)) < 1.5L ||
         real_abs(difference(g, t - reach, k, got)) < 1.5L))
        return;
    fail_msg("kind %d at %d,%d to %d,%d radius %d, n %d, spread %d, pixel "
             "%d,%d channel %d: got %08x, %Lg off at t %Lg; %s",
             g->kind, g->at.x, g->at.y, g->to.x, g->to.y, g->radius, g->ramp.n,
             (int)g->ramp.spread, at[0], at[1], k, got, error, t,
             cases_replay());
}

static void test_colors(void **state)
{
    (void)state;
    static struct gradient g;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        g.kind = (int)(c.next % 3);
        g.at = (struct pel_point){random_between(r, -200000, 200000),
                                  random_between(r, -200000, 200000)};
        g.radius = 256 << random_between(r, 0, 11);
        g.to = (struct pel_point){
            g.at.x + random_between(r, -g.radius, g.radius),
            g.at.y + (random_word(r) % 2 ? g.radius : -g.radius)};
        random_ramp(r, &g);
        struct pel_color_paint *p = init(&g);
        int32_t at[2] = {random_between(r, -1200, 1200),
                         random_between(r, -1200, 1200)};
        pel_color got[32];
        p->colors(p, at[0], at[1], 32, got);
        for (int32_t i = 0; i < 32; i++, at[0]++)
            for (int k = 0; k < 4; k++)
                check_channel(&g, at, k, got[i]);
    }
    for (int i = 0; i < 3; i++)
        histogram_end(&errors[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_colors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
