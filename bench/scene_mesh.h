/* Meshes for the benchmark of the 3-D pipeline. */
#ifndef BENCH_SCENE_MESH_H
#define BENCH_SCENE_MESH_H

#include "core/scene/mesh.h"

/* Owns the arrays of `mesh`, which has normals, uv and colours. */
struct scene_mesh {
    const char *name;
    struct pel_mesh mesh;
    double low[3], high[3]; /* the box around it, units */
};

/* Reads PEL_MESHES/file, or else `path`; tells what is missing, and which
 * package has it, and answers false. */
struct scene_mesh_file {
    const char *name, *file, *path, *package;
};
bool scene_mesh_load(struct scene_mesh *m, const struct scene_mesh_file *from);

/* A ring with waves, of about so many triangles. Exits when memory is short. */
void scene_mesh_make(struct scene_mesh *m, uint32_t triangles);

void scene_mesh_free(struct scene_mesh *m);

#endif
