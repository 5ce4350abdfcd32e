/* The atlas: figures of every method against an exact reference, as CSV. */
#ifndef BENCH_ATLAS_ATLAS_H
#define BENCH_ATLAS_ATLAS_H

#include <stdbool.h>
#include <stdint.h>

#include <pel/pel.h>

#include "../method.h"
#include "../timing.h"

/* The smallest triangle that a method draws wrong. */
struct wrong {
    struct pel_point v[3];
    int32_t size;           /* 1/256 px; 0: there is none */
    int32_t x, y;           /* its first wrong pixel */
    struct pel_rect bounds; /* where it was drawn */
};

/* A run of one case. */
struct atlas {
    const char *name; /* of the case */
    uint32_t seed;
    bool quick;           /* fewer samples */
    const char *smallest; /* the method whose smallest wrong triangle is
                             printed instead of figures; NULL: figures */
    bool judged;          /* that method draws triangles of the case */
    struct wrong wrong;
    int broken; /* promises of Pel that did not hold */
};

struct figure {
    const char *method;
    double x;
    const char *metric;
    double value;
    const char *unit;
    double low, high; /* the spread */
    bool has_spread;
    double y; /* the second parameter */
    bool has_y;
};

static inline struct figure figure_of(const char *method, double x,
                                      const char *metric, double value,
                                      const char *unit)
{
    struct figure f = {.method = method, .x = x, .metric = metric};
    f.value = value;
    f.unit = unit;
    return f;
}

/* Of several measurements. */
static inline struct figure figure_spread(const char *method, double x,
                                          const char *metric,
                                          struct quartiles value,
                                          const char *unit)
{
    struct figure f = figure_of(method, x, metric, value.median, unit);
    f.low = value.q1;
    f.high = value.q3;
    f.has_spread = true;
    return f;
}

void atlas_put(const struct atlas *a, struct figure f);

/* A promise of Pel: when it does not hold the run fails. */
void atlas_promise(struct atlas *a, bool holds, const struct figure *f);

/* Puts the figure with its bound, as metric `bound`, and promises that the
 * value does not exceed it. */
void atlas_put_bound(struct atlas *a, struct figure f, double bound);

/* How many samples: those of a full run, or of a quick one. */
static inline int atlas_samples(const struct atlas *a, int full, int quick)
{
    return a->quick ? quick : full;
}

/* The generator of sample series `number` of the case. */
struct random atlas_random(const struct atlas *a, uint32_t number);

#endif
