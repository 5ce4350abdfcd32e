/* Time, and what many measurements of it say. */
#ifndef BENCH_TIMING_H
#define BENCH_TIMING_H

/* CPU time of this process, ns: turns of other programs do not count. */
double timing_now(void);

/* Keeps the process on the CPU that it runs on; exits when that is refused. */
void timing_pin(void);

struct quartiles {
    double q1, median, q3;
};

/* Sorts the n values, n >= 1. */
struct quartiles timing_quartiles(double *values, int n);

#endif
