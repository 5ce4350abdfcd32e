/* Vertex normals from faces. */
#ifndef PEL_SCENE_NORMALS_H
#define PEL_SCENE_NORMALS_H

#include "mesh.h"

PEL_BEGIN_DECLS

/* Bytes of scratch memory that pel_mesh_normals needs, for constant expressions
 * and as a function. */
#define PEL_MESH_NORMALS_SCRATCH_SIZE(vertices) \
    (PEL_CAST(size_t, vertices) * 24)
size_t pel_mesh_normals_scratch_size(const struct pel_mesh *mesh);

/* Per vertex the mean of its faces' normals, weighted by their areas, scaled to
 * the length 32,767 and rounded: off by less than 0.6 in each part. 0 where a
 * vertex has no face, none with an area, or faces that cancel out. Vertices are
 * those of the indices: two at one place are two, which keeps an edge sharp.
 * `scratch` is aligned to 8 bytes. Errors of pel_mesh_check,
 * PEL_ERROR_NULL (`normals` or `scratch` too), PEL_ERROR_SCRATCH. */
enum pel_status pel_mesh_normals(const struct pel_mesh *mesh,
                                 int16_t (*normals)[3], void *scratch,
                                 size_t scratch_size);
PEL_END_DECLS
#endif
