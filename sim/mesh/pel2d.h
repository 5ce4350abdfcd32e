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

#include "core/base/color.h"
#include "core/base/point.h"
#include "sim/mesh/depth.h"

struct pel2d_vertex {
    struct pel_point at;
    pel_color color; /* opaque */
    struct mesh_depth depth;
    double u, v;
};

/* Owns its arrays; {0} is an empty one. */
struct pel2d {
    struct pel2d_vertex *vertex;
    uint32_t (*triangle)[3];
    uint32_t vertices, triangles;
};

/* Append one. False, with a message on standard error, when memory is short or
 * there are 2^28 already. */
bool pel2d_add_vertex(struct pel2d *flat, const struct pel2d_vertex *vertex);
bool pel2d_add_triangle(struct pel2d *flat, const uint32_t index[3]);

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
