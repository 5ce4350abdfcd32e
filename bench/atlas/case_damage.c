/* Wrong pixels, damaged triangles, pixels of a mesh that are hit twice or not
 * at all, and time, by the size of triangles. */
#include <stdlib.h>
#include <string.h>

#include "../timing.h"
#include "cases.h"
#include "generate.h"
#include "sheet.h"

/* Floats are measured where a picture has them: away from the origin. */
enum { ORIGIN = 1000, MARGIN = 4 };

enum { PASS = 64, REPEATS = 5 };

static void open_around(struct sheet *s, struct atlas *a,
                        const struct square *p)
{
    const struct pel_rect bounds = {p->x - MARGIN, p->y - MARGIN,
                                    p->x + p->edge + MARGIN,
                                    p->y + p->edge + MARGIN};
    sheet_open(s, a, bounds);
}

static int samples(const struct atlas *a, const struct square *p)
{
    const int pixels = atlas_samples(a, 100000000, 1500000);
    const int n = pixels / (p->edge * p->edge + 40);
    return n < 60 ? 60 : n;
}

static void put_damage(struct atlas *a, const struct fill_method *m,
                       const struct square *p)
{
    struct sheet s;
    struct tally any = {0}, tied = {0};
    struct random r = atlas_random(a, (uint32_t)p->edge);
    struct pel_point v[3];
    open_around(&s, a, p);
    for (int n = samples(a, p); n > 0; n--) {
        any_triangle(&r, p, v);
        sheet_judge(&s, m, v, &any);
    }
    tally_put(a, m, &any, (struct figure){.x = p->edge, .metric = "wrong_ppm"});
    atlas_put(a, figure_of(m->name, p->edge, "damaged_percent",
                           100 * any.damaged / any.triangles, "%"));
    /* Some of these are clipped. */
    const int32_t beyond = p->edge < 16 ? 0 : MARGIN + 1;
    const struct square around = {p->x - beyond, p->y - beyond,
                                  p->edge + 2 * beyond};
    for (int n = samples(a, p) / 2; n > 0; n--) {
        tied_triangle(&r, &around, v);
        sheet_judge(&s, m, v, &tied);
    }
    tally_put(a, m, &tied, (struct figure){.x = p->edge, .metric = "ties_ppm"});
    sheet_close(&s);
}

/* Adds what is drawn to the hits of each pixel, and clears it. */
static void count_hits(struct sheet *s, uint8_t *hits)
{
    const struct pel_rect *b = &s->surface.bounds;
    const int32_t n = (b->x1 - b->x0) * (b->y1 - b->y0);
    for (int32_t i = 0; i < n; i++)
        hits[i] = (uint8_t)(hits[i] + (s->pixels[i] != 0));
    memset(s->pixels, 0, (size_t)n * 4);
}

static void put_mesh_figures(struct atlas *a, const struct fill_method *m,
                             const struct grid *g, const uint8_t *hits)
{
    const int32_t edge = g->square.edge, width = edge + 2 * MARGIN;
    const double cell = edge / g->n, all = (double)edge * edge;
    double twice = 0, gaps = 0;
    for (int32_t i = 0; i < edge * edge; i++) {
        const uint8_t n = hits[(i / edge + MARGIN) * width + i % edge + MARGIN];
        twice += n > 1;
        gaps += n == 0;
    }
    const struct figure doubles =
        figure_of(m->name, cell, "double_ppm", 1e6 * twice / all, "ppm");
    const struct figure gap =
        figure_of(m->name, cell, "gap_ppm", 1e6 * gaps / all, "ppm");
    atlas_put(a, doubles);
    atlas_put(a, gap);
    if (fill_is_pel(m)) {
        atlas_promise(a, twice == 0, &doubles);
        atlas_promise(a, gaps == 0, &gap);
    }
}

/* A mesh of cells that are `cell` px wide. */
static void put_mesh(struct atlas *a, const struct fill_method *m, int32_t cell)
{
    struct sheet s;
    struct random r = atlas_random(a, (uint32_t)cell);
    const int32_t n = cell <= 32 ? 64 / cell + 4 : 2;
    struct grid g = {{ORIGIN, ORIGIN, n * cell}, n, NULL};
    struct pel_point v[3];
    open_around(&s, a, &g.square);
    g.vertex = method_allocate((n + 1) * (n + 1), sizeof *g.vertex);
    const int32_t width = g.square.edge + 2 * MARGIN;
    uint8_t *hits = method_allocate(width, (size_t)width);
    grid_make(&r, &g);
    for (int32_t i = 0; i < 2 * n * n; i++) {
        grid_triangle(&g, i / 2, i % 2, v);
        m->draw(&s.surface, v, UINT32_MAX);
        count_hits(&s, hits);
    }
    put_mesh_figures(a, m, &g, hits);
    free(hits);
    free(g.vertex);
    sheet_close(&s);
}

static double time_pass(const struct fill_method *m,
                        const struct pel_surface *s, struct pel_point (*v)[3])
{
    const double start = timing_now();
    for (int i = 0; i < PASS; i++)
        m->draw(s, v[i], UINT32_MAX - (unsigned)i);
    return (timing_now() - start) / PASS;
}

static void put_time(struct atlas *a, const struct fill_method *m,
                     const struct square *p)
{
    struct sheet s;
    struct random r = atlas_random(a, (uint32_t)p->edge);
    struct pel_point v[PASS][3];
    double ns[REPEATS];
    open_around(&s, a, p);
    for (int i = 0; i < PASS; i++)
        any_triangle(&r, p, v[i]);
    time_pass(m, &s.surface, v);
    const int passes = p->edge < 256 ? 256 / p->edge * 4 : 1;
    for (int i = 0; i < REPEATS; i++) {
        ns[i] = 0;
        for (int k = 0; k < passes; k++)
            ns[i] += time_pass(m, &s.surface, v) / passes;
    }
    atlas_put(a, figure_spread(m->name, p->edge, "ns_per_triangle",
                               timing_quartiles(ns, REPEATS), "ns"));
    sheet_close(&s);
}

void atlas_damage_time(struct atlas *a)
{
    for (const struct fill_method *const *m = fill_methods; *m; m++)
        for (int32_t edge = 4; edge <= 1024; edge *= 2)
            put_time(a, *m, &(struct square){ORIGIN, ORIGIN, edge});
}

void atlas_damage(struct atlas *a)
{
    for (const struct fill_method *const *m = fill_methods; *m; m++) {
        for (int32_t edge = 4; edge <= 1024; edge *= 2) {
            put_damage(a, *m, &(struct square){ORIGIN, ORIGIN, edge});
            if (!a->smallest)
                put_mesh(a, *m, edge);
        }
        if (!a->smallest)
            put_mesh(a, *m, 3);
    }
}
