#define _GNU_SOURCE /* program_invocation_name */
#include "cases.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* cmocka's, where that is linked. */
void _fail(const char *file, int line) __attribute__((weak));

static uint64_t current;
static bool on; /* between two cases_next */
static struct part {
    void (*print)(const void *value);
    char value[CASES_PART] __attribute__((aligned(8)));
} parts[CASES_PARTS];
static int count;

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

bool cases_alone(void)
{
    return environment("PEL_CASE", UINT64_MAX) != UINT64_MAX;
}

struct cases cases_of(uint64_t n)
{
    struct cases c = {0, cases_scaled(n), {0}};
    if (cases_alone()) {
        c.next = environment("PEL_CASE", 0);
        c.end = c.next + 1;
    }
    return c;
}

bool cases_next(struct cases *c)
{
    if (on && getenv("PEL_FAIL") && _fail)
        _fail(__FILE__, __LINE__);
    if (cases_alone())
        cases_report();
    count = 0;
    on = c->next < c->end;
    if (!on)
        return false;
    current = c->next++;
    c->random.state = mixed(mixed(seed()) + current);
    return true;
}

void cases_keep(void (*print)(const void *value), const void *value,
                size_t size)
{
    if (count == CASES_PARTS)
        return;
    parts[count].print = print;
    memcpy(parts[count++].value, value, size < CASES_PART ? size : CASES_PART);
}

void cases_forget(void)
{
    count -= count > 0;
}

void cases_report(void)
{
    if (!on)
        return;
    on = false;
    for (int i = 0; i < count; i++)
        parts[i].print(parts[i].value);
    fprintf(stderr, "PEL_SEED=%" PRIu64 " PEL_CASE=%" PRIu64 " %s\n", seed(),
            current, program_invocation_name);
}

struct random cases_shared(uint64_t number)
{
    return (struct random){mixed(mixed(seed()) - 1 - number)};
}

const char *cases_replay(void)
{
    static char text[32];
    snprintf(text, sizeof text, "case %" PRIu64, current);
    return text;
}
