/* Projected meshes: triangles on the screen with a depth, and their text file.
 *
 *     pel2d VERTICES TRIANGLES
 *     x y r g b depth u v        a line per vertex
 *     i j k                      a line per triangle
 *
 * x, y: decimal pixels, each a whole number of 1/256, inside the legal range of
 * core/base/point.h; r g b: 0..255; depth: decimal, larger is farther; u, v:
 * texture coordinates, v = 0 the first row of the texture; i j k: vertices,
 * counted from 0. Fields are separated by spaces or tabs. */
#ifndef SIM_MESH_PEL2D_H
#define SIM_MESH_PEL2D_H

#include <stdbool.h>
#include <stddef.h>

#include "core/base/color.h"
#include "core/base/point.h"

/* Depths are exact decimals: a triangle's mean depth is compared as the exact
 * sum of three. */

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

struct pel2d_vertex {
    struct pel_point at;
    pel_color color; /* opaque */
    struct mesh_depth depth;
    double u, v;
};

/* Owns its arrays, which list_add lengthens; {0} is an empty one. */
struct pel2d {
    struct pel2d_vertex *vertex;
    uint32_t (*triangle)[3];
    size_t vertices, triangles;
};

void pel2d_free(struct pel2d *flat);

/* Reads the file at `path`, "-" for standard input. Memory grows with the lines
 * that are really there. False, with a message that names file, line, field and
 * what is expected; `flat` is then empty. */
bool pel2d_load(struct pel2d *flat, const char *path);

/* Writes the file, whole or not at all; reading it back gives the same values.
 * False, with a message, when that failed. */
bool pel2d_save(const struct pel2d *flat, const char *path);

/* True when pel2d_load should read `path`: "-", a pipe, a name that ends in
 * .pel2d, or a file that begins as one. */
bool pel2d_is_file(const char *path);

#endif
