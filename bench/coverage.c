#include "coverage.h"

#include <stdlib.h>

/* Pixels that may be looked at in a comparison: it ends after them. */
enum { ENOUGH = 6000000 };

/* Peers may draw a little more than the shape's own box. */
enum { MARGIN = 3 };

static int clamp(int v, int high)
{
    return v < 0 ? 0 : v > high ? high : v;
}

struct box shape_box(const struct workload *w, const struct shape *s)
{
    const bool is_round = w->form == FORM_CIRCLE || w->form == FORM_GEAR ||
                          w->form == FORM_STROKE;
    const int around = MARGIN + (is_round ? w->size : 0);
    struct box b = {w->width, w->height, 0, 0};
    for (int k = 0; k < workload_vertices(w); k++) {
        b.x0 = s->x[k] < b.x0 ? s->x[k] : b.x0;
        b.y0 = s->y[k] < b.y0 ? s->y[k] : b.y0;
        b.x1 = s->x[k] > b.x1 ? s->x[k] : b.x1;
        b.y1 = s->y[k] > b.y1 ? s->y[k] : b.y1;
    }
    b.x0 = clamp(b.x0 - around, w->width);
    b.y0 = clamp(b.y0 - around, w->height);
    b.x1 = clamp(b.x1 + around + 1, w->width);
    b.y1 = clamp(b.y1 + around + 1, w->height);
    return b;
}

static long box_pixels(const struct box *b)
{
    return (long)(b->x1 - b->x0) * (b->y1 - b->y0);
}

struct drawing drawing_open(const struct method *m, const struct workload *w,
                            const struct canvas *c)
{
    struct drawing d = {m, w, c, m->open(w, c), NULL};
    d.mask = method_allocate(c->width, (size_t)c->height);
    return d;
}

void drawing_close(struct drawing *d)
{
    d->method->close(d->job);
    free(d->mask);
}

long drawing_draw(const struct drawing *d, const struct box *box, int i)
{
    canvas_clear(d->canvas, box);
    d->method->draw(d->job, i, 1);
    return canvas_mask(d->canvas, box, d->mask);
}

double coverage_mean(const struct workload *w, const struct canvas *c)
{
    struct drawing pel = drawing_open(methods[0], w, c);
    long pixels = 0;
    for (int i = 0; i < w->count; i++) {
        struct box box = shape_box(w, &w->shape[i]);
        pixels += drawing_draw(&pel, &box, i);
    }
    drawing_close(&pel);
    return (double)pixels / w->count;
}

static long differences(const uint8_t *a, const uint8_t *b, long n)
{
    long different = 0;
    for (; n > 0; n--)
        different += (*a++ != 0) != (*b++ != 0);
    return different;
}

/* Sums over the pixels at edges. */
struct edges {
    long pixels, sum;
    int worst;
};

static void add_levels(struct edges *e, const uint8_t *a, const uint8_t *b,
                       long n)
{
    for (long i = 0; i < n; i++) {
        const int far = abs(a[i] - b[i]);
        const bool is_edge = (a[i] > 0 && a[i] < 255) || far > 0;
        e->pixels += is_edge;
        e->sum += far;
        e->worst = far > e->worst ? far : e->worst;
    }
}

struct coverage coverage_of(const struct method *m, const struct workload *w,
                            const struct canvas *c)
{
    struct drawing pel = drawing_open(methods[0], w, c);
    struct drawing other = drawing_open(m, w, c);
    struct edges edges = {0, 0, 0};
    long expected = 0, got = 0, wrong = 0, seen = 0;
    for (int i = 0; i < w->count && seen < ENOUGH; i++) {
        struct box box = shape_box(w, &w->shape[i]);
        expected += drawing_draw(&pel, &box, i);
        got += drawing_draw(&other, &box, i);
        wrong += differences(pel.mask, other.mask, box_pixels(&box));
        if (w->paint == PAINT_SMOOTH)
            add_levels(&edges, pel.mask, other.mask, box_pixels(&box));
        seen += box_pixels(&box);
    }
    drawing_close(&pel);
    drawing_close(&other);
    return (struct coverage){
        true, 100.0 * (double)(got - expected) / (double)expected,
        100.0 * (double)wrong / (double)expected, edges.worst,
        edges.pixels ? (double)edges.sum / (double)edges.pixels : 0};
}
