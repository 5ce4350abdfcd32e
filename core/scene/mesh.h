/* Meshes: views of const arrays, which may live in flash. */
#ifndef PEL_SCENE_MESH_H
#define PEL_SCENE_MESH_H

#include "../asset/mesh_asset.h"
#include "../base/inline.h"

PEL_BEGIN_DECLS

/* The shifts of a quantization that a scene takes. */
enum { PEL_MESH_SHIFT_MIN = -14, PEL_MESH_SHIFT_MAX = 46 };

/* The numerator that means 16,384 units, or the largest. */
int32_t pel_quantization_limit(const struct pel_quantization *quantization);

/* The arrays are those of struct pel_mesh_asset. */
struct pel_mesh {
    uint32_t vertices, triangles;
    struct pel_quantization position; /* of vertices inside +-16,384 units */
    struct pel_quantization texture;

    const int16_t (*positions)[3];
    const int8_t (*normals8)[3];   /* at most one of the two */
    const int16_t (*normals16)[3]; /* any length; 0: no direction */
    const uint16_t (*uv)[2];
    const uint8_t (*colors)[3]; /* red, green, blue */

    /* Counter-clockwise from outside: one of the three. */
    const uint8_t (*indices8)[3];
    const uint16_t (*indices16)[3];
    const uint32_t (*indices32)[3];

    const struct pel_mesh_part *part;
    uint32_t parts; /* 0: one material for all */
};

/* The view of an asset that pel_mesh_asset_check has found legal. */
void pel_mesh_of_asset(struct pel_mesh *mesh,
                       const struct pel_mesh_asset *asset);

/* A triangle whose index is not below the number of vertices, or a part. */
struct pel_mesh_fault {
    uint32_t triangle, index, part;
};

/* Checks that the mesh can be drawn, every index too. PEL_ERROR_NULL: no
 * positions or parts, or not exactly one array of indices; PEL_ERROR_SIZE: no
 * vertex, more than 2^26 vertices or triangles, two arrays of normals, a
 * quantization out of range, a vertex beyond +-16,384 units, or a part that
 * ends before it begins or, as the last, not where the mesh does;
 * PEL_ERROR_RANGE: an index. `fault`, which may be NULL, is set to it, or to
 * the part. */
enum pel_status pel_mesh_check(const struct pel_mesh *mesh,
                               struct pel_mesh_fault *fault);

inline void pel_mesh_corners(const struct pel_mesh *mesh, uint32_t triangle,
                             uint32_t corner[3])
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        corner[k] = mesh->indices16  ? mesh->indices16[triangle][k]
                    : mesh->indices8 ? mesh->indices8[triangle][k]
                                     : mesh->indices32[triangle][k];
}

/* A vertex's normal, of any length: each component is up to 2^29 in size. The
 * mesh has normals. */
inline void pel_mesh_normal(const struct pel_mesh *mesh, uint32_t vertex,
                            int32_t normal[3])
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        normal[k] = mesh->normals16
                        ? mesh->normals16[vertex][k] * INT32_C(16384)
                        : mesh->normals8[vertex][k] * INT32_C(4194304);
}

/* The normal of a triangle, as long as twice its area: below 2^35 in each
 * component. */
void pel_mesh_facet(const struct pel_mesh *mesh, const uint32_t corner[3],
                    int64_t normal[3]);

/* Bytes of scratch memory that pel_mesh_normals needs, for constant expressions
 * and as a function. */
#define PEL_MESH_NORMALS_SCRATCH_SIZE(vertices) \
    (PEL_CAST(size_t, vertices) * 24)
size_t pel_mesh_normals_scratch_size(const struct pel_mesh *mesh);

/* Per vertex the mean of its faces' normals, weighted by their areas, scaled to
 * the length 32,767 and rounded: a component is off by less than 0.6. 0 where a
 * vertex has no face, none with an area, or faces that cancel out. Vertices are
 * those of the indices: two at one position are two, which keeps an edge sharp.
 * `scratch` is aligned to 8 bytes. Errors of pel_mesh_check,
 * PEL_ERROR_NULL (`normals` or `scratch` too), PEL_ERROR_SCRATCH. */
enum pel_status pel_mesh_normals(const struct pel_mesh *mesh,
                                 int16_t (*normals)[3], void *scratch,
                                 size_t scratch_size);
PEL_END_DECLS
#endif
