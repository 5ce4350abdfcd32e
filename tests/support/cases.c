#include "cases.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static uint64_t current;

static uint64_t environment(const char *name, uint64_t otherwise)
{
    const char *text = getenv(name);
    return text && *text ? strtoull(text, NULL, 10) : otherwise;
}

static uint64_t seed(void)
{
    return environment("PEL_SEED", 1);
}

/* splitmix64 (Steele, Lea, Flood 2014). */
static uint64_t mixed(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

uint32_t random_word(struct random *r)
{
    r->state += UINT64_C(0x9E3779B97F4A7C15);
    return (uint32_t)(mixed(r->state) >> 32);
}

int32_t random_between(struct random *r, int32_t lo, int32_t hi)
{
    uint64_t range = (uint64_t)((int64_t)hi - lo) + 1;
    return (int32_t)(lo + (int64_t)(random_word(r) * range >> 32));
}

uint64_t cases_scaled(uint64_t n)
{
    uint64_t scaled = n * environment("PEL_SCALE", 100) / 100;
    return scaled ? scaled : 1;
}

struct cases cases_of(uint64_t count)
{
    struct cases c = {0, cases_scaled(count), {0}};
    uint64_t only = environment("PEL_CASE", UINT64_MAX);
    if (only != UINT64_MAX) {
        c.next = only;
        c.end = only + 1;
    }
    return c;
}

bool cases_next(struct cases *c)
{
    if (c->next >= c->end)
        return false;
    current = c->next++;
    c->random.state = mixed(mixed(seed()) + current);
    return true;
}

struct random cases_shared(uint64_t number)
{
    return (struct random){mixed(mixed(seed()) - 1 - number)};
}

const char *cases_replay(void)
{
    static char text[80];
    snprintf(text, sizeof text,
             "replay: PEL_SEED=%" PRIu64 " PEL_CASE=%" PRIu64, seed(), current);
    return text;
}
