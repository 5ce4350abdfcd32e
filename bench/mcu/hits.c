/* What a hit test costs: a pixel in the shape, one outside near by, and one far
 * off; and the topmost of 16 targets, of which the last but 15 is hit. */
#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { CALLS = 16, TARGETS = 16 };

static const struct pel_point polygon_v[5] = {PEL_AT(100, 40), PEL_AT(160, 90),
                                              PEL_AT(140, 160), PEL_AT(60, 160),
                                              PEL_AT(40, 90)};
static const struct pel_polygon_shape polygon = {polygon_v, 5, PEL_NON_ZERO};
static const struct pel_ring_shape ring = {PEL_AT(100, 100), PEL_PX(30),
                                           PEL_PX(60)};
static const struct pel_sector_shape sector = {PEL_AT(100, 100), PEL_PX(60),
                                               60000, 20000};
static const struct pel_arc_shape arc = {PEL_AT(100, 100), PEL_PX(30),
                                         PEL_PX(60), 60000, 20000};
static const struct pel_ellipse_shape ellipse = {PEL_AT(100, 100),
                                                 PEL_AT(60, 50)};
static const struct pel_rounded_shape rounded = {PEL_AT(40, 50),
                                                 PEL_AT(160, 150), PEL_PX(20)};
static const struct pel_thick_line_shape thick = {PEL_AT(50, 60),
                                                  PEL_AT(150, 140), PEL_PX(20)};

typedef bool hit_function(const struct pel_target *target, int32_t x,
                          int32_t y);

static bool nothing(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && x == y;
}

static bool triangle_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_triangle(polygon_v, x, y);
}

static bool polygon_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_polygon(&polygon, x, y);
}

static bool rectangle_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_rectangle(rounded.from, rounded.to, x, y);
}

static bool circle_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_circle(ring.center, ring.outer, x, y);
}

static bool line_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_line(thick.from, thick.to, x, y);
}

static bool ring_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_ring(&ring, x, y);
}

static bool sector_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_sector(&sector, x, y);
}

static bool arc_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_arc(&arc, x, y);
}

static bool ellipse_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_ellipse(&ellipse, x, y);
}

static bool rounded_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_rounded_rectangle(&rounded, x, y);
}

static bool thick_line_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    return !t && pel_hit_thick_line(&thick, x, y);
}

/* Inside, near and far. */
static const struct hit_case {
    const char *name[3];
    hit_function *hit;
    int32_t x[3], y[3];
} hit_cases[] = {
#define NAMES(shape)                             \
    {                                            \
        "in-" shape, "near-" shape, "far-" shape \
    }
    {NAMES("triangle"), triangle_hit, {120, 150, 300}, {90, 150, 20}},
    {NAMES("rectangle"), rectangle_hit, {100, 161, 300}, {100, 100, 20}},
    {NAMES("circle"), circle_hit, {130, 150, 300}, {110, 145, 20}},
    {NAMES("line"), line_hit, {100, 101, 300}, {100, 120, 20}},
    {NAMES("polygon"), polygon_hit, {100, 155, 300}, {100, 140, 20}},
    {NAMES("ring"), ring_hit, {145, 110, 300}, {110, 105, 20}},
    {NAMES("sector"), sector_hit, {130, 130, 300}, {110, 74, 20}},
    {NAMES("arc"), arc_hit, {140, 130, 300}, {110, 74, 20}},
    {NAMES("ellipse"), ellipse_hit, {130, 150, 300}, {110, 140, 20}},
    {NAMES("rounded"), rounded_hit, {150, 42, 300}, {140, 148, 20}},
    {NAMES("thick-line"), thick_line_hit, {100, 120, 300}, {100, 90, 20}},
#undef NAMES
};

static int32_t hit_time(hit_function *volatile hit, int32_t x, int32_t y)
{
    uint32_t from = stopwatch_read();
    for (int i = 0; i < CALLS; i++)
        hit(NULL, x, y);
    return stopwatch_eighths(from, stopwatch_read());
}

struct disc_target {
    struct pel_target target;
    struct pel_point center;
    int32_t radius;
};

static bool disc_hit(const struct pel_target *t, int32_t x, int32_t y)
{
    const struct disc_target *d = (const void *)t;
    return pel_hit_circle(d->center, d->radius, x, y);
}

static void topmost_report(void)
{
    static struct disc_target discs[TARGETS];
    const struct pel_target *list[TARGETS];
    for (int i = 0; i < TARGETS; i++) {
        discs[i] =
            (struct disc_target){{disc_hit, {8 + 15 * i, 38, 32 + 15 * i, 62}},
                                 {PEL_PX(20 + 15 * i), PEL_PX(50)},
                                 PEL_PX(12)};
        list[i] = &discs[i].target;
    }
    uint32_t from = stopwatch_read();
    const int32_t top = pel_hit_topmost(list, TARGETS, 18, 50);
    report("topmost", TARGETS, stopwatch_eighths(from, stopwatch_read()),
           top == 0 ? 1 : 0);
}

void hits_report(void)
{
    for (unsigned i = 0; i < sizeof hit_cases / sizeof *hit_cases; i++)
        for (int k = 0; k < 3; k++) {
            const struct hit_case *c = &hit_cases[i];
            int32_t time = hit_time(c->hit, c->x[k], c->y[k]) -
                           hit_time(nothing, c->x[k], c->y[k]);
            report(c->name[k], 1, time, CALLS);
        }
    topmost_report();
}
