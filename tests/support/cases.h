/* Random cases that can be replayed. Every case has a generator of its own, so
 * that one case alone can be run again: the environment's PEL_SEED chooses the
 * set (default 1), PEL_CASE runs that one case and shows what it is made of,
 * PEL_SCALE is a percentage of the number of cases (default 100). Where a test
 * fails in a case, what it is made of is printed, and the command that runs it
 * again. With PEL_FAIL each test fails after its first case, as if by itself.
 */
#ifndef TESTS_SUPPORT_CASES_H
#define TESTS_SUPPORT_CASES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct random {
    uint64_t state;
};

uint32_t random_word(struct random *r);

/* lo <= result <= hi. */
int32_t random_between(struct random *r, int32_t lo, int32_t hi);

struct cases {
    uint64_t next, end;
    struct random random;
};

/* `count` cases, scaled. */
struct cases cases_of(uint64_t count);

/* Begins the next case; false after the last. */
bool cases_next(struct cases *c);

/* A generator for what several cases share, by a number that each of them knows
 * (as case / 16): another than that of any case. */
struct random cases_shared(uint64_t number);

/* The present case, for messages. */
const char *cases_replay(void);

/* Is one case run alone? Then nothing can be said of what is true for some of
 * the set. */
bool cases_alone(void);

/* Keeps a copy of what the case is made of, up to CASES_PART bytes, for `print`
 * to print as a line; cases_forget drops the last. */
enum { CASES_PARTS = 8, CASES_PART = 256 };
void cases_keep(void (*print)(const void *value), const void *value,
                size_t size);
void cases_forget(void);

/* Prints that and the command, when a case is on. Tests call it when they end:
 * no case is then, unless it has failed. */
void cases_report(void);

/* n scaled by PEL_SCALE, at least 1: for loops that are not cases. */
uint64_t cases_scaled(uint64_t n);

#endif
