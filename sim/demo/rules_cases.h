/* System E: every case of the fill rule, each a few triangles on a small
 * canvas. Vertices lie on quarters of pixels, so that many centres are on
 * edges. Only for demo_rules*.c. */
#ifndef SIM_DEMO_RULES_CASES_H
#define SIM_DEMO_RULES_CASES_H

#include <stdbool.h>
#include <stdint.h>

enum {
    RULES_WIDTH = 12, /* px of the canvas of a case */
    RULES_HEIGHT = 10,
    RULES_TRIANGLES_MAX = 12
};

struct rules_case {
    const char *caption;
    bool line; /* draw triangles without area as lines */
    int count;
    uint8_t v[RULES_TRIANGLES_MAX][6]; /* x, y in 1/4 px */
};

/* All cases; the last has no caption. */
extern const struct rules_case rules_cases[];

#endif
