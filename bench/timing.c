#define _GNU_SOURCE
#include "timing.h"

#include <sched.h>
#include <stdlib.h>
#include <time.h>

#include "method.h"

double timing_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

void timing_pin(void)
{
    cpu_set_t set;
    int cpu = sched_getcpu();
    CPU_ZERO(&set);
    CPU_SET((size_t)(cpu < 0 ? 0 : cpu), &set);
    if (sched_setaffinity(0, sizeof set, &set))
        method_fail("cannot stay on one CPU",
                    "run it where sched_setaffinity is allowed");
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Linear between the two values next to the index, which may be a fraction. */
static double quantile(const double *sorted, int n, double share)
{
    double index = share * (n - 1);
    int i = (int)index;
    if (i + 1 >= n)
        return sorted[n - 1];
    return sorted[i] + (index - i) * (sorted[i + 1] - sorted[i]);
}

struct quartiles timing_quartiles(double *values, int n)
{
    qsort(values, (size_t)n, sizeof *values, compare);
    return (struct quartiles){quantile(values, n, .25), quantile(values, n, .5),
                              quantile(values, n, .75)};
}
