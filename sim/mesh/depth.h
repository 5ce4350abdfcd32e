/* Depths as exact decimals: a triangle's mean depth is compared as the exact
 * sum of three. */
#ifndef SIM_MESH_DEPTH_H
#define SIM_MESH_DEPTH_H

#include <stdbool.h>
#include <stdint.h>

/* The sum of the limbs, in 1, 10^-18 and 10^-36. In a single depth all have one
 * sign and are below 10^18 in size, so that a sum of three fits. */
struct mesh_depth {
    int64_t limb[3];
};

/* A decimal, [+-]DIGITS[.DIGITS][e[+-]DIGITS], below 10^18 in size and without
 * digits below 10^-36. False when it is anything else. */
bool mesh_depth_parse(const char *text, struct mesh_depth *depth);

enum { MESH_DEPTH_TEXT = 64 };

/* Writes a single depth so that it is parsed as the same. */
void mesh_depth_format(const struct mesh_depth *depth,
                       char text[MESH_DEPTH_TEXT]);

/* The sum of three single depths; only mesh_depth_compare may take it. */
struct mesh_depth mesh_depth_sum(const struct mesh_depth *a,
                                 const struct mesh_depth *b,
                                 const struct mesh_depth *c);

/* < 0, 0, > 0 as sum a is smaller than, equal to, larger than sum b. */
int mesh_depth_compare(const struct mesh_depth *a, const struct mesh_depth *b);

#endif
