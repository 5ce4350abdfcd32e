/* Time, for measurements and limits. */
#ifndef SIM_CLI_MILLISECONDS_H
#define SIM_CLI_MILLISECONDS_H

#include <time.h>

/* The time of a clock that only runs forwards. */
static inline double milliseconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

#endif
