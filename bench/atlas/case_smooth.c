/* Smooth edges against exact areas. */
#define _DEFAULT_SOURCE
#include <math.h>

#include "../methods/smooth.h"
#include "../timing.h"
#include "cases.h"
#include "tests/support/exact_area.h"

enum { SIDE = 80, PIXELS = SIDE * SIDE };

/* A shape, as Pel has it and as the others have it; the pixels at its edges and
 * their exact areas. */
struct target {
    struct smooth_shape shape;
    struct pel_point v[3]; /* or the centre */
    int32_t radius;
    int n, at[PIXELS];
    double exact[PIXELS];
};

/* The area under a circle's upper half around 0, from 0 to x <= r. */
static double under(double r, double x)
{
    return (x * sqrt(fmax(r * r - x * x, 0)) + r * r * asin(x / r)) / 2;
}

/* The disc's area from 0 to x across and from 0 to y down, of any signs. */
static double quarter(double r, double x, double y)
{
    const double w = fmin(fabs(x), r), h = fmin(fabs(y), r);
    const double flat = fmin(sqrt(r * r - h * h), w);
    const double area = flat * h + under(r, w) - under(r, flat);
    return (x < 0) == (y < 0) ? area : -area;
}

static double exact_of(const struct target *t, int x, int y)
{
    int edges;
    const double r = t->radius / 256.;
    const double left = x - t->v[0].x / 256., up = y - t->v[0].y / 256.;
    if (!t->shape.is_disc)
        return (double)exact_area(t->v, 3, x, y, &edges);
    return quarter(r, left + 1, up + 1) - quarter(r, left, up + 1) -
           quarter(r, left + 1, up) + quarter(r, left, up);
}

static void find_edges(struct target *t)
{
    t->n = 0;
    for (int i = 0; i < PIXELS; i++) {
        const double exact = exact_of(t, i % SIDE, i / SIDE);
        if (exact > 1e-9 && exact < 1 - 1e-9) {
            t->exact[t->n] = exact;
            t->at[t->n++] = i;
        }
    }
    for (int k = 0; k < 3; k++) {
        t->shape.x[k] = t->v[k].x / 256.;
        t->shape.y[k] = t->v[k].y / 256.;
    }
    t->shape.radius = t->radius / 256.;
}

static void make_disc(struct random *r, int32_t radius, struct target *t)
{
    t->shape.is_disc = true;
    t->radius = radius;
    for (int k = 0; k < 3; k++)
        t->v[k] =
            (struct pel_point){PEL_PX(SIDE / 2) + random_between(r, 0, 255),
                               PEL_PX(SIDE / 2) + random_between(r, 0, 255)};
    find_edges(t);
}

/* 60 px long, in any direction, a third vertex beside its first one. */
static void make_needle(struct random *r, int32_t base, struct target *t)
{
    const double turn = random_between(r, 0, 65535) * (2 * M_PI / 65536);
    const double c = cos(turn), s = sin(turn);
    const int32_t x = PEL_PX(SIDE / 2) + random_between(r, 0, 255);
    const int32_t y = PEL_PX(SIDE / 2) + random_between(r, 0, 255);
    t->shape.is_disc = false;
    t->v[0].x = x - (int32_t)lrint(c * PEL_PX(30));
    t->v[0].y = y - (int32_t)lrint(s * PEL_PX(30));
    t->v[1].x = x + (int32_t)lrint(c * PEL_PX(30));
    t->v[1].y = y + (int32_t)lrint(s * PEL_PX(30));
    t->v[2].x = t->v[0].x - (int32_t)lrint(s * base);
    t->v[2].y = t->v[0].y + (int32_t)lrint(c * base);
    find_edges(t);
}

static void draw_pel(const struct target *t, uint8_t *level)
{
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    struct pel_surface s;
    if (pel_surface_init(&s, &pel_gray8, level, PIXELS,
                         &(struct pel_rect){0, 0, SIDE, SIDE}))
        method_fail("Pel refuses the sheet", "check its size");
    if (t->shape.is_disc)
        pel_smooth_circle(&s, t->v[0], t->radius, &white.paint);
    else
        pel_smooth_triangle(&s, t->v, &white.paint);
}

/* Errors of 255 over many shapes. */
struct error {
    double worst, sum, pixels;
};

static void add(struct error *e, double level, double exact)
{
    const double far = fabs(level - 255 * exact);
    e->worst = fmax(e->worst, far);
    e->sum += far;
    e->pixels++;
}

static void judge(const struct target *t, const struct smooth_method *m,
                  struct error *e)
{
    uint8_t level[PIXELS] = {0};
    if (!m)
        draw_pel(t, level);
    for (int i = 0; i < t->n; i++) {
        const int at = t->at[i];
        add(e,
            m ? rint(255 * m->coverage(&t->shape, m->n, at % SIDE, at / SIDE))
              : level[at],
            t->exact[i]);
    }
}

typedef void make_target(struct random *r, int32_t size, struct target *t);

/* The size is in 1/256 px. */
static void put_size(struct atlas *a, make_target *make, int32_t size)
{
    enum { METHODS = 8 };
    const struct smooth_method *m = smooth_methods;
    struct error error[METHODS] = {{0, 0, 0}};
    struct random r = atlas_random(a, (uint32_t)size);
    static struct target t;
    for (int i = atlas_samples(a, 300, 6); i > 0; i--) {
        make(&r, size, &t);
        judge(&t, NULL, &error[0]);
        for (int k = 0; m[k].name; k++)
            judge(&t, &m[k], &error[k + 1]);
    }
    for (int k = 0; k == 0 || m[k - 1].name; k++) {
        const struct figure worst =
            figure_of(k ? m[k - 1].name : "pel", size / 256., "worst_level",
                      error[k].worst, "steps");
        atlas_put(a, worst);
        atlas_put(a, figure_of(worst.method, size / 256., "mean_level",
                               error[k].sum / error[k].pixels, "steps"));
        atlas_promise(a, k > 0 || error[k].worst <= 1, &worst);
    }
}

void atlas_smooth_discs(struct atlas *a)
{
    for (int32_t r = 32; r <= PEL_PX(32); r *= 2)
        put_size(a, make_disc, r);
}

void atlas_smooth_needles(struct atlas *a)
{
    for (int32_t base = 1; base <= PEL_PX(8); base *= 2)
        put_size(a, make_needle, base);
}

/* Pel draws the whole shape, with its set-up and its full runs; the others look
 * at the pixels of edges alone, which they would have to find. */
static double time_of(const struct target *t, const struct smooth_method *m)
{
    static uint8_t level[PIXELS];
    const double start = timing_now();
    if (m)
        for (int i = 0; i < t->n; i++)
            level[t->at[i]] = (uint8_t)rint(255 * m->coverage(&t->shape, m->n,
                                                              t->at[i] % SIDE,
                                                              t->at[i] / SIDE));
    else
        draw_pel(t, level);
    return (timing_now() - start) / t->n;
}

static void put_time(struct atlas *a, const struct target *t, double size,
                     const struct smooth_method *m)
{
    enum { REPEATS = 41 };
    double ns[REPEATS];
    for (int i = 0; i < REPEATS; i++)
        ns[i] = time_of(t, m);
    atlas_put(a, figure_spread(m ? m->name : "pel", size, "ns_per_edge_pixel",
                               timing_quartiles(ns, REPEATS), "ns"));
}

void atlas_smooth_time(struct atlas *a)
{
    static struct target t;
    for (int32_t base = 1; base <= PEL_PX(8); base *= 2) {
        struct random r = atlas_random(a, (uint32_t)base);
        make_needle(&r, base, &t);
        put_time(a, &t, base / 256., NULL);
        for (const struct smooth_method *m = smooth_methods; m->name; m++)
            put_time(a, &t, base / 256., m);
    }
}

/* White over black, of a pixel that two shapes share, or that one outline with
 * the same edge inside it holds. */
void atlas_smooth_seams(struct atlas *a)
{
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    for (int32_t at = 0; at <= 256; at += 16) {
        const struct pel_point from = {0, 0}, to = {PEL_PX(1), PEL_PX(1)};
        uint8_t level[2] = {0, 0};
        struct pel_surface s;
        if (pel_surface_init(&s, &pel_gray8, level, 2,
                             &(struct pel_rect){0, 0, 1, 1}))
            method_fail("Pel refuses a pixel", "check its size");
        pel_smooth_rectangle(&s, from, (struct pel_point){at, to.y},
                             &white.paint);
        pel_smooth_rectangle(&s, (struct pel_point){at, 0}, to, &white.paint);
        const double background = 100 - level[0] / 2.55;
        const double part = at / 256., law = 100 * part * (1 - part);
        const struct figure f = figure_of(
            "two shapes", part, "background_percent", background, "percent");
        atlas_put(a, f);
        atlas_put(a, figure_of("a (1 - a)", part, "background_percent", law,
                               "percent"));
        atlas_promise(a, fabs(background - law) < .5, &f);
    }
}
