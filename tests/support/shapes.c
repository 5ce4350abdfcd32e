#include "shapes.h"

#include <stdio.h>
#include <string.h>

struct points {
    int32_t n, radius; /* radius: -1 where there is none */
    struct pel_point v[12];
};

static void print_points(const void *value)
{
    const struct points *p = value;
    fprintf(stderr, p->radius < 0 ? "points" : "circle");
    for (int32_t i = 0; i < p->n; i++)
        fprintf(stderr, " (%.13g, %.13g)", p->v[i].x / 256., p->v[i].y / 256.);
    if (p->radius >= 0)
        fprintf(stderr, " radius %.13g", p->radius / 256.);
    fprintf(stderr, " px\n");
}

void shape_keep(const struct pel_point *v, int32_t n)
{
    struct points p = {pel_min(n, 12), -1, {{0, 0}}};
    memcpy(p.v, v, (size_t)p.n * sizeof *v);
    cases_keep(print_points, &p, sizeof p);
}

void shape_keep_circle(struct pel_point center, int32_t radius)
{
    const struct points p = {1, radius, {center}};
    cases_keep(print_points, &p, sizeof p);
}

static void print_rect(const void *value)
{
    const struct pel_rect *r = value;
    fprintf(stderr, "pixels %d, %d to %d, %d\n", r->x0, r->y0, r->x1, r->y1);
}

static void keep_rect(const struct pel_rect *r)
{
    cases_keep(print_rect, r, sizeof *r);
}

int32_t shape_legal(int64_t v)
{
    if (v < PEL_COORDINATE_MIN)
        return PEL_COORDINATE_MIN;
    return v > PEL_COORDINATE_MAX ? PEL_COORDINATE_MAX : (int32_t)v;
}

/* Half the edge of a box, in sub-pixels. */
static int32_t random_extent(struct random *r)
{
    static const int32_t px[] = {1, 2, 4, 8, 32, 150, 2000, 32767};
    return PEL_PX(px[random_word(r) % 8]);
}

static int32_t random_coordinate(struct random *r)
{
    return random_between(r, PEL_COORDINATE_MIN, PEL_COORDINATE_MAX);
}

static struct pel_point random_origin(struct random *r)
{
    struct pel_point o = {0, 0};
    if (random_word(r) % 4 == 0) {
        o.x = random_coordinate(r) / 256 * 256;
        o.y = random_coordinate(r) / 256 * 256;
    }
    return o;
}

static void anywhere(struct random *r, struct pel_point *v, int32_t n)
{
    const int32_t e = random_extent(r);
    const struct pel_point o = random_origin(r);
    for (; n > 0; n--, v++) {
        v->x = shape_legal((int64_t)o.x + random_between(r, -e, e));
        v->y = shape_legal((int64_t)o.y + random_between(r, -e, e));
    }
}

void shape_random(struct random *r, struct pel_point *v, int32_t n)
{
    anywhere(r, v, n);
    shape_keep(v, n);
}

/* The nearest lattice point of `step`, plus `offset`, plus -k..k. */
static void snap(struct random *r, struct pel_point *v, int32_t n,
                 const int32_t lattice[3])
{
    const int32_t step = lattice[0], offset = lattice[1], k = lattice[2];
    for (; n > 0; n--, v++) {
        v->x =
            shape_legal(v->x / step * step + offset + random_between(r, -k, k));
        v->y =
            shape_legal(v->y / step * step + offset + random_between(r, -k, k));
    }
}

/* Vertices share coordinates with others. */
static void align(struct random *r, struct pel_point *v, int32_t n)
{
    for (int32_t i = 1; i < n; i++)
        if (random_word(r) & 1)
            v[i].x = v[i - 1].x;
        else
            v[i].y = v[i - 1].y;
}

/* All on the line through the first two, and up to k sub-pixels off. */
static void flatten(struct random *r, struct pel_point *v, int32_t n, int32_t k)
{
    for (int32_t i = 2; i < n; i++) {
        int64_t t = random_between(r, -16, 80);
        v[i].x = shape_legal(v[0].x + (v[1].x - v[0].x) * t / 64 +
                             random_between(r, -k, k));
        v[i].y = shape_legal(v[0].y + (v[1].y - v[0].y) * t / 64 +
                             random_between(r, -k, k));
    }
}

static void to_limits(struct random *r, struct pel_point *v, int32_t n)
{
    static const int32_t limit[] = {
        PEL_COORDINATE_MIN,       PEL_COORDINATE_MIN + 1,
        PEL_COORDINATE_MIN + 128, PEL_COORDINATE_MIN + 129,
        PEL_COORDINATE_MAX,       PEL_COORDINATE_MAX - 1,
        PEL_COORDINATE_MAX - 127, PEL_COORDINATE_MAX - 128};
    for (; n > 0; n--, v++) {
        if (random_word(r) % 4)
            v->x = limit[random_word(r) % 8];
        if (random_word(r) % 4)
            v->y = limit[random_word(r) % 8];
    }
}

static void shrink(struct random *r, struct pel_point *v, int32_t n)
{
    const struct pel_point o = {v->x / 256 * 256 + 128, v->y / 256 * 256 + 128};
    for (; n > 0; n--, v++) {
        v->x = shape_legal(o.x + random_between(r, -3, 3));
        v->y = shape_legal(o.y + random_between(r, -3, 3));
    }
}

void shape_adversarial(struct random *r, struct pel_point *v, int32_t n)
{
    static const int32_t lattice[4][3] = {
        {256, 128, 0}, {256, 128, 1}, {128, 0, 0}, {128, 0, 1}};
    uint32_t kind = random_word(r) % 10;
    anywhere(r, v, n);
    if (kind < 4)
        snap(r, v, n, lattice[kind]);
    else if (kind < 6)
        flatten(r, v, n, (int32_t)(kind - 4) * 2);
    else if (kind == 6)
        align(r, v, n);
    else if (kind == 7)
        to_limits(r, v, n);
    else if (kind == 8)
        shrink(r, v, n);
    else {
        snap(r, v, n, lattice[random_word(r) % 4]);
        align(r, v, n);
    }
    shape_keep(v, n);
}

static int32_t within(int32_t v, int32_t lo, int32_t hi)
{
    return pel_max(lo, pel_min(v, hi));
}

struct pel_rect shape_window(struct random *r, const struct pel_point *v,
                             int32_t n, int32_t size)
{
    uint32_t kind = random_word(r) % 8;
    const struct pel_point *a = &v[random_word(r) % (uint32_t)n];
    const struct pel_point *b = &v[random_word(r) % (uint32_t)n];
    int64_t t = kind < 2 ? 0 : random_between(r, 0, 65536);
    int32_t x = (int32_t)(a->x + (b->x - a->x) * t / 65536) >> 8;
    int32_t y = (int32_t)(a->y + (b->y - a->y) * t / 65536) >> 8;
    struct pel_rect w;
    if (kind == 7) {
        x = random_coordinate(r) >> 8;
        y = random_coordinate(r) >> 8;
    }
    w.x0 = within(x - random_between(r, 0, size), -32768, 32768 - size) & ~7;
    w.y0 = within(y - random_between(r, 0, size), -32768, 32768 - size) & ~7;
    w.x1 = w.x0 + random_between(r, 1, size);
    w.y1 = w.y0 + random_between(r, 1, size);
    keep_rect(&w);
    return w;
}

struct pel_rect shape_bounds(struct random *r, int32_t width, int32_t height)
{
    const int32_t reach = random_word(r) % 2 ? 40 : 32600;
    struct pel_rect b;
    b.x0 = random_between(r, -reach, reach) & ~7;
    b.y0 = random_between(r, -reach, reach) & ~7;
    b.x1 = b.x0 + random_between(r, 1, width);
    b.y1 = b.y0 + random_between(r, 1, height);
    keep_rect(&b);
    return b;
}

struct pel_rect shape_clip(struct random *r, const struct pel_rect *window)
{
    struct pel_rect c = *window;
    if (random_word(r) & 1)
        return c;
    c.x0 = random_between(r, c.x0 - 2, c.x1);
    c.y0 = random_between(r, c.y0 - 2, c.y1);
    c.x1 = random_between(r, c.x0, c.x1 + 2);
    c.y1 = random_between(r, c.y0, c.y1 + 2);
    keep_rect(&c);
    return c;
}

void shape_in_box(struct random *r, struct pel_point *v, int32_t n,
                  const struct pel_rect *box)
{
    const uint32_t step = 1u << random_word(r) % 9;
    for (int32_t i = 0; i < n; i++) {
        v[i].x = random_between(r, PEL_PX(box->x0), PEL_PX(box->x1));
        v[i].y = random_between(r, PEL_PX(box->y0), PEL_PX(box->y1));
        v[i].x &= ~(int32_t)(step - 1);
        v[i].y &= ~(int32_t)(step - 1);
    }
    shape_keep(v, n);
}

struct pel_rect shape_box(const struct pel_surface *s)
{
    struct pel_rect box = {0, 0, 0, 0};
    for (int32_t y = s->clip.y0; y < s->clip.y1; y++)
        for (int32_t x = s->clip.x0; x < s->clip.x1; x++) {
            if (pel_surface_line(s, y)[x - s->bounds.x0] == 0)
                continue;
            if (pel_rect_empty(&box))
                box = (struct pel_rect){x, y, x + 1, y + 1};
            box.x0 = pel_min(box.x0, x);
            box.x1 = pel_max(box.x1, x + 1);
            box.y1 = y + 1;
        }
    return box;
}
