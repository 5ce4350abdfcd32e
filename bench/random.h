/* Repeatable random numbers: the same workloads on every machine. */
#ifndef BENCH_RANDOM_H
#define BENCH_RANDOM_H

#include <stdint.h>

/* Marsaglia's xorshift with shifts 13, 7, 17; the state is never 0. */
struct random {
    uint64_t state;
};

static inline uint32_t random_next(struct random *r)
{
    r->state ^= r->state << 13;
    r->state ^= r->state >> 7;
    r->state ^= r->state << 17;
    return (uint32_t)(r->state >> 16);
}

/* Uniform in [low, high]. */
static inline int random_between(struct random *r, int low, int high)
{
    return low + (int)(random_next(r) % (uint32_t)(high - low + 1));
}

#endif
