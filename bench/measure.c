#include "measure.h"

#include <string.h>

/* A sample lasts at least as long, ns. */
#define SAMPLE 1.5e6

/* What is drawn before a sample lasts about as long, ns. */
#define WARM_UP 1.0e6

struct contender {
    const struct method *method;
    void *job;
    int passes, warm_up; /* of a sample, and before it; 0: a part of one, */
    int shapes;          /* of so many shapes */
    double ns[REPEATS_MAX];
};

static double time_passes(const struct contender *c, int count, int passes)
{
    double start = timing_now();
    for (int i = 0; i < passes; i++)
        c->method->draw(c->job, 0, count);
    return timing_now() - start;
}

static void calibrate(struct contender *c, int count)
{
    double ns = time_passes(c, count, 1);
    const double part = WARM_UP / (ns + 1);
    c->passes = 1 + (int)(SAMPLE / (ns + 1));
    c->warm_up = (int)part;
    c->shapes = (int)(count * (part - c->warm_up)) + 1;
}

static void sample(struct contender *c, int count, int repeat)
{
    (void)time_passes(c, count, c->warm_up);
    c->method->draw(c->job, 0, c->shapes);
    c->ns[repeat] = time_passes(c, count, c->passes) / c->passes / count;
}

static int open_contenders(struct contender *c, const struct workload *w,
                           const struct canvas *canvas)
{
    int n = 0;
    for (; methods[n] && n < METHODS_MAX; n++) {
        c[n].method = methods[n];
        c[n].job = methods[n]->open(w, canvas);
        if (c[n].job)
            calibrate(&c[n], w->count);
    }
    return n;
}

/* Each repeat begins with another method. */
static void race(struct contender *c, int n, int count, int repeats)
{
    for (int r = 0; r < repeats; r++)
        for (int i = 0; i < n; i++)
            if (c[(i + r) % n].job)
                sample(&c[(i + r) % n], count, r);
}

static struct result finish(struct contender *c, int repeats)
{
    struct result result = {0};
    if (!c->job)
        return result;
    result.method = c->method;
    result.ns = timing_quartiles(c->ns, repeats);
    c->method->close(c->job);
    return result;
}

void measure(struct measurement *out, const struct workload *w,
             const struct measure_options *options)
{
    static struct contender contender[METHODS_MAX];
    struct canvas canvas;
    if (!canvas_open(&canvas, w->width, w->height, w->bits))
        method_fail("out of memory", "free some and start again");
    out->workload = w;
    out->pixels = coverage_mean(w, &canvas);
    out->results = open_contenders(contender, w, &canvas);
    race(contender, out->results, w->count, options->repeats);
    for (int i = 0; i < out->results; i++) {
        struct result *r = &out->result[i];
        *r = finish(&contender[i], options->repeats);
        if (r->method && !method_is_limit(r->method) &&
            !method_is_apart(r->method) && !options->no_coverage)
            r->coverage = coverage_of(r->method, w, &canvas);
    }
    canvas_close(&canvas);
}

const struct result *measurement_find(const struct measurement *m,
                                      const char *name)
{
    for (int i = 0; i < m->results; i++) {
        const struct result *r = &m->result[i];
        if (r->method && strcmp(r->method->name, name) == 0)
            return r;
    }
    return NULL;
}

const struct result *measurement_best_peer(const struct measurement *m)
{
    const struct result *best = NULL;
    for (int i = 0; i < m->results; i++) {
        const struct result *r = &m->result[i];
        if (r->method && method_is_peer(r->method) &&
            (!best || r->ns.median < best->ns.median))
            best = r;
    }
    return best;
}
