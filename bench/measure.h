/* Measures every method on one workload. */
#ifndef BENCH_MEASURE_H
#define BENCH_MEASURE_H

#include "coverage.h"
#include "timing.h"

enum { METHODS_MAX = 16, REPEATS_MAX = 101 };

struct result {
    const struct method *method; /* NULL: this one does not draw the workload */
    struct quartiles ns;         /* for one shape */
    struct coverage coverage;    /* of limits it is not known */
};

struct measurement {
    const struct workload *workload;
    double pixels;                     /* of the mean shape */
    struct result result[METHODS_MAX]; /* as in methods[] */
    int results;
};

struct measure_options {
    int repeats;
    bool no_coverage; /* do not compare the pixels */
};

/* In a repeat every method draws whole passes, one method after the other, so
 * that a disturbance hits all alike; each first draws untimed, to fill the
 * caches. */
void measure(struct measurement *out, const struct workload *w,
             const struct measure_options *options);

/* The result of a method; NULL when it has none. */
const struct result *measurement_find(const struct measurement *m,
                                      const char *name);

/* The fastest peer; NULL without any. */
const struct result *measurement_best_peer(const struct measurement *m);

#endif
