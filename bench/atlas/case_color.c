/* Color errors of gradients over triangles, in steps of an 8-bit channel,
 * against exact fractions. */
#include <math.h>

#include "../methods/gradient.h"
#include "cases.h"
#include "generate.h"
#include "sheet.h"
#include "tests/support/reference.h"

struct errors {
    double worst, sum, count;
};

static void errors_add(struct errors *e, double error)
{
    e->worst = error > e->worst ? error : e->worst;
    e->sum += error;
    e->count++;
}

/* A method's own rule for the value at a pixel. */
typedef int32_t value_at(const void *context, int32_t x, int32_t y);

struct planar {
    const struct gradient_method *method;
    struct gradient gradient;
};

static int32_t planar_at(const void *context, int32_t x, int32_t y)
{
    const struct planar *p = context;
    return gradient_at(&p->gradient, p->method, x, y);
}

static int32_t sheet_at(const void *context, int32_t x, int32_t y)
{
    const struct pel_surface *s = context;
    const uint32_t *line =
        (const uint32_t *)(const void *)pel_surface_line(s, y);
    return (int32_t)(line[x - s->bounds.x0] & 255);
}

struct sample {
    struct pel_point v[3];
    pel_color color[3];
    struct pel_rect box;
};

/* Adds the blue channel's error at every covered pixel of the box. */
static void judge(struct errors *e, const struct sample *s, value_at *at,
                  const void *context)
{
    for (int32_t y = s->box.y0; y < s->box.y1; y++) {
        const struct pel_span row = exact_row(s->v, y, 8);
        const int32_t x1 = pel_min(row.x1, s->box.x1);
        for (int32_t x = pel_max(row.x0, s->box.x0); x < x1; x++) {
            const struct fraction f =
                reference_channel_at(s->v, s->color, 0, x, y);
            errors_add(
                e, fabs((double)at(context, x, y) - (double)f.n / (double)f.d));
        }
    }
}

static void sample_set(struct gradient *g, const struct sample *s,
                       const struct gradient_method *m)
{
    const int32_t value[3] = {(int32_t)(s->color[0] & 255),
                              (int32_t)(s->color[1] & 255),
                              (int32_t)(s->color[2] & 255)};
    gradient_set(g, m, s->v, value);
}

static void judge_method(struct errors *e, const struct sample *s,
                         const struct gradient_method *m)
{
    struct planar p = {.method = m};
    sample_set(&p.gradient, s, m);
    judge(e, s, planar_at, &p);
}

static bool overflows(const struct sample *s)
{
    struct gradient g;
    sample_set(&g, s, &gradient_methods[1]);
    return g.dx != (int32_t)g.dx || g.dy != (int32_t)g.dy;
}

static void judge_pel(struct errors *e, const struct sample *s,
                      const struct pel_surface *surface)
{
    pel_triangle_gouraud(surface, s->v, s->color);
    judge(e, s, sheet_at, surface);
}

static void put_errors(struct atlas *a, const struct errors *e, struct figure f,
                       double bound)
{
    f.unit = "step";
    f.metric = "error_mean";
    f.value = e->count > 0 ? e->sum / e->count : 0;
    atlas_put(a, f);
    f.metric = "error_max";
    f.value = e->worst;
    if (bound > 0)
        atlas_put_bound(a, f, bound);
    else
        atlas_put(a, f);
}

/* What rounding to F bits may do over `distance` px in x and y together, and
 * the half step of the result. */
static double bound_of(const struct gradient_method *m, double distance)
{
    return m->bits && !m->saturates ? (distance + 1) / (2 << m->bits) + .5 : 0;
}

/* gouraud.h: 2^-17 a pixel, at most 1/16. */
static double bound_of_pel(double distance)
{
    return fmin((distance + 1) / 131072, 1 / 16.) + .5;
}

/* Makes triangles for a sheet: of an edge, or of a thickness. */
struct regime {
    void (*make)(struct random *r, int32_t size, struct sample *s);
    int32_t size;
    int triangles;
    struct sheet sheet;
};

static void any_sample(struct random *r, int32_t edge, struct sample *s)
{
    const struct square p = {0, 0, edge};
    any_triangle(r, &p, s->v);
    s->box = (struct pel_rect){0, 0, edge, edge};
}

static void thin_sample(struct random *r, int32_t thickness, struct sample *s)
{
    enum { EDGE = 128 };
    const struct square p = {0, 0, EDGE};
    const struct thin thin = {EDGE - 4, 0};
    thin_triangle(r, &p, &thin, s->v);
    s->v[2].x += random_between(r, -thickness, thickness);
    s->v[2].y += random_between(r, -thickness, thickness);
    s->box = (struct pel_rect){0, 0, EDGE, EDGE};
}

enum { KINDS = 4 };

struct result {
    struct errors pel, kind[KINDS];
    double triangles, broken[KINDS + 1]; /* more than a step off; Pel last */
    double overflow; /* gradients that leave 32 bits in 16.16 */
};

static void measure(struct result *out, struct random *r,
                    const struct regime *regime)
{
    for (int n = regime->triangles; n > 0; n--) {
        struct sample s;
        regime->make(r, regime->size, &s);
        for (int i = 0; i < 3; i++)
            s.color[i] = PEL_RGB(0, 0, random_next(r));
        if (pel_triangle_area(s.v) == 0)
            continue;
        out->triangles++;
        out->overflow += overflows(&s);
        for (int k = 0; k <= KINDS; k++) {
            struct errors one = {0};
            struct errors *all = k < KINDS ? &out->kind[k] : &out->pel;
            if (k < KINDS)
                judge_method(&one, &s, &gradient_methods[k]);
            else
                judge_pel(&one, &s, &regime->sheet.surface);
            out->broken[k] += one.worst > 1;
            all->worst = fmax(all->worst, one.worst);
            all->sum += one.sum;
            all->count += one.count;
        }
    }
}

void atlas_color(struct atlas *a)
{
    for (int32_t edge = 4; edge <= 1024; edge *= 2) {
        struct random r = atlas_random(a, (uint32_t)edge);
        struct result out = {0};
        const int n = atlas_samples(a, 10000000, 200000) / (edge * edge);
        struct regime regime = {.make = any_sample, .size = edge};
        regime.triangles = n < 5 ? 5 : n;
        sheet_open(&regime.sheet, a, (struct pel_rect){0, 0, edge, edge});
        measure(&out, &r, &regime);
        put_errors(a, &out.pel, (struct figure){.method = "pel", .x = edge},
                   bound_of_pel(2 * edge));
        for (int k = 0; k < KINDS; k++)
            put_errors(
                a, &out.kind[k],
                (struct figure){.method = gradient_methods[k].name, .x = edge},
                bound_of(&gradient_methods[k], 2 * edge));
        sheet_close(&regime.sheet);
    }
}

/* Triangles whose third vertex lies within some sub-pixels of a long edge: how
 * many show a color that is off by more than a step. */
void atlas_color_sliver(struct atlas *a)
{
    for (int32_t thickness = 1; thickness <= 256; thickness *= 2) {
        struct random r = atlas_random(a, (uint32_t)thickness);
        struct result out = {0};
        struct regime regime = {.make = thin_sample, .size = thickness};
        regime.triangles = atlas_samples(a, 15000, 1500);
        sheet_open(&regime.sheet, a, (struct pel_rect){0, 0, 128, 128});
        measure(&out, &r, &regime);
        atlas_put(a, figure_of("16.16", thickness / 256.0, "overflow_percent",
                               100 * out.overflow / out.triangles, "%"));
        for (int k = 0; k <= KINDS; k++) {
            const char *name = k < KINDS ? gradient_methods[k].name : "pel";
            const struct figure f =
                figure_of(name, thickness / 256.0, "broken_percent",
                          100 * out.broken[k] / out.triangles, "%");
            atlas_put(a, f);
            if (k == KINDS)
                atlas_promise(a, f.value == 0, &f);
        }
        sheet_close(&regime.sheet);
    }
}

/* A gradient from black to blue over `length` px in a random direction, as a
 * triangle that holds it, seen in a strip. */
struct axis {
    struct pel_point from, to;
};

static struct axis any_axis(struct random *r, int32_t length, struct sample *s)
{
    const double turn = random_between(r, -500, 500) / 1000.0;
    const struct pel_point d = {(int32_t)lround(256 * length * cos(turn)),
                                (int32_t)lround(256 * length * sin(turn))};
    const struct pel_point from = {random_between(r, 0, 255),
                                   random_between(r, 0, 255)};
    const struct pel_point to = {from.x + d.x, from.y + d.y};
    const struct axis axis = {from, to};
    s->v[0] = from;
    s->v[1] = to;
    s->v[2] = (struct pel_point){from.x - d.y, from.y + d.x};
    s->color[0] = s->color[2] = PEL_RGB(0, 0, 0);
    s->color[1] = PEL_RGB(0, 0, 255);
    s->box = (struct pel_rect){0, 0, length, 16};
    return axis;
}

static void draw_linear(const struct pel_surface *s, const struct axis *axis,
                        const struct pel_ramp *ramp)
{
    struct pel_linear paint;
    const struct pel_point corner[2] = {
        {PEL_PX(s->bounds.x0), PEL_PX(s->bounds.y0)},
        {PEL_PX(s->bounds.x1), PEL_PX(s->bounds.y1)}};
    if (pel_linear_init(&paint, axis->from, axis->to, ramp))
        method_fail("a linear gradient is refused", "take legal points");
    pel_rectangle(s, corner[0], corner[1], &paint.base.paint);
}

/* paint/gradient.h: slope / (2 n) + 1/2, n cells. */
static const struct {
    const char *name;
    int32_t cells;
} ramps[] = {{"pel 2 colors", 256}, {"pel 1024 cells", 1024}};

static void ramp_of(struct pel_ramp *ramp, pel_color colors[1024], int32_t n)
{
    const struct pel_stop stops[2] = {{0, PEL_RGB(0, 0, 0)},
                                      {65536, PEL_RGB(0, 0, 255)}};
    const int32_t count = n == 256 ? 2 : n;
    if (n == 256) {
        colors[0] = stops[0].color;
        colors[1] = stops[1].color;
    } else if (pel_ramp_fill(colors, n, stops, 2)) {
        method_fail("a ramp is refused", "take legal stops");
    }
    *ramp = (struct pel_ramp){colors, count, PEL_PAD};
}

static void put_ways(struct atlas *a, int32_t length)
{
    struct random r = atlas_random(a, (uint32_t)length);
    struct errors e[KINDS + 2] = {{0, 0, 0}};
    struct sheet sheet;
    struct sample s;
    pel_color colors[1024];
    struct pel_ramp ramp;
    sheet_open(&sheet, a, (struct pel_rect){0, 0, length, 16});
    for (int n = atlas_samples(a, 60, 4); n > 0; n--) {
        const struct axis axis = any_axis(&r, length, &s);
        for (int k = 0; k < KINDS; k++)
            judge_method(&e[k], &s, &gradient_methods[k]);
        for (int k = 0; k < 2; k++) {
            ramp_of(&ramp, colors, ramps[k].cells);
            draw_linear(&sheet.surface, &axis, &ramp);
            judge(&e[KINDS + k], &s, sheet_at, &sheet.surface);
        }
    }
    for (int k = 0; k < KINDS + 2; k++) {
        const bool is_pel = k >= KINDS;
        const char *name =
            is_pel ? ramps[k - KINDS].name : gradient_methods[k].name;
        const double bound = is_pel
                                 ? 255. / 2 / ramps[k - KINDS].cells + .5
                                 : bound_of(&gradient_methods[k], length + 16);
        put_errors(a, &e[k], (struct figure){.method = name, .x = length},
                   bound);
    }
    sheet_close(&sheet);
}

void atlas_gradient(struct atlas *a)
{
    for (int32_t length = 16; length <= 8192; length *= 2)
        put_ways(a, length);
}
