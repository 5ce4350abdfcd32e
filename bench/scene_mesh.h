/* Meshes for the benchmark of the 3-D pipeline. */
#ifndef BENCH_SCENE_MESH_H
#define BENCH_SCENE_MESH_H

#include "core/scene/mesh.h"

/* Owns the arrays of `mesh`, which has normals, uv and colors. */
struct bench_mesh {
    const char *name;
    struct pel_mesh mesh;
    double low[3], high[3]; /* the box around it, units */
};

/* Reads PEL_MESHES/file, or else `path`; tells what is missing, and which
 * package has it, and answers false. */
struct bench_mesh_file {
    const char *name, *file, *path, *package;
};
bool bench_mesh_load(struct bench_mesh *m, const struct bench_mesh_file *from);

/* A ring with waves, of about so many triangles. Exits when memory is short. */
void bench_mesh_make(struct bench_mesh *m, uint32_t triangles);

void bench_mesh_free(struct bench_mesh *m);

#endif
