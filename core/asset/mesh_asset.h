/* Meshes in flash, as `pel import` writes them: const arrays of small integers.
 */
#ifndef PEL_ASSET_MESH_ASSET_H
#define PEL_ASSET_MESH_ASSET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../base/color.h"
#include "../base/status.h"

/* "PELM", and the version of the struct. */
#define PEL_MESH_MAGIC UINT32_C(0x4D4C4550)
enum { PEL_MESH_VERSION = 2 };

/* A quantized number q of axis k means
 *     (offset[k] + q * step) / 2^shift
 * with 1 <= step <= 16,384 and |offset[k]| <= 2^30. |q| < 2^16, so the
 * numerator stays below 2^31. Rounding to q is off by half a step at most. */
struct pel_quantization {
    int32_t offset[3];
    int32_t step;
    int32_t shift; /* -64..64; a negative one multiplies */
};

static inline bool pel_quantization_legal(const struct pel_quantization *p)
{
    const int32_t limit = INT32_C(1) << 30;
    for (int k = 0; k < 3; k++)
        if (p->offset[k] < -limit || p->offset[k] > limit)
            return false;
    return p->step >= 1 && p->step <= 16384 && p->shift >= -64 &&
           p->shift <= 64;
}

/* A run of vertices and triangles that have one material. Parts follow one
 * another and make up the mesh. Its triangles use its own vertices: that is not
 * checked, and one with a vertex of another part may take its colors. */
struct pel_mesh_part {
    uint32_t vertices, triangles; /* where it ends: one more than its last */
    pel_color color;  /* of vertices without colors; its alpha is that of all */
    uint32_t texture; /* 0: none; else that of its scene with this number,
                         counted from 1 */
};

/* The first part that ends before it begins, or, if it is the last, elsewhere
 * than the mesh; `parts` when there is none. */
static inline uint32_t pel_mesh_wrong_part(const struct pel_mesh_part *part,
                                           uint32_t parts, uint32_t vertices,
                                           uint32_t triangles)
{
    struct pel_mesh_part before = {0, 0, 0, 0};
    uint32_t i = 0;
    for (; i < parts; before = part[i++])
        if (part[i].vertices < before.vertices ||
            part[i].triangles < before.triangles ||
            (i + 1 == parts &&
             (part[i].vertices != vertices || part[i].triangles != triangles)))
            break;
    return i;
}

struct pel_image_asset;

/* A texture of parts of a mesh. */
struct pel_mesh_image {
    const struct pel_image_asset *image;
    uint8_t wrap_u, wrap_v; /* enum pel_wrap */
    bool cut_out;           /* pel_texture_cut_out */
};

struct pel_mesh_asset {
    uint32_t magic;     /* PEL_MESH_MAGIC */
    uint32_t version;   /* PEL_MESH_VERSION */
    uint32_t vertices;  /* at least 1; 16-bit indices: at most 65,536 */
    uint32_t triangles; /* at least 1 */
    struct pel_quantization position; /* world units, y up, right-handed */
    struct pel_quantization texture;  /* u, v; v = 0 is the first row */

    /* Per vertex. All but positions may be NULL, and one kind of normals must
     * be. Their length is 127 or 32,767; 0: no direction. */
    const int16_t (*positions)[3];
    const int8_t (*normals8)[3];
    const int16_t (*normals16)[3];
    const uint16_t (*uv)[2];
    const uint8_t (*colors)[3]; /* red, green, blue */

    /* Per triangle, counter-clockwise from outside: one of the two. */
    const uint16_t (*indices16)[3];
    const uint32_t (*indices32)[3];

    const struct pel_mesh_part *part;
    const struct pel_mesh_image *image; /* textures, by their number */
    uint32_t parts; /* 0: one material, and image[0] if there is one, for all */
    uint32_t images; /* 0: they are for the program to find */
};

/* Checks that the program can read this asset. PEL_ERROR_NULL: no asset, no
 * positions, not exactly one array of indices, no parts or images where there
 * is a number of them; PEL_ERROR_RANGE: no mesh asset, or one of another
 * version; PEL_ERROR_SIZE: counts out of range, two arrays of normals, a
 * quantization out of range, wrong ends of parts or numbers of textures.
 * Indices and the images themselves are not checked, nor whether a scene takes
 * so large a mesh: pel_mesh_check. */
static inline enum pel_status pel_mesh_asset_check(
    const struct pel_mesh_asset *mesh)
{
    if (!mesh || !mesh->positions || !mesh->indices16 == !mesh->indices32 ||
        (mesh->parts && !mesh->part) || (mesh->images && !mesh->image))
        return PEL_ERROR_NULL;
    if (mesh->magic != PEL_MESH_MAGIC || mesh->version != PEL_MESH_VERSION)
        return PEL_ERROR_RANGE;
    if (mesh->vertices < 1 || mesh->triangles < 1 ||
        (mesh->indices16 && mesh->vertices > 65536) ||
        (mesh->normals8 && mesh->normals16) ||
        !pel_quantization_legal(&mesh->position) ||
        (mesh->uv && !pel_quantization_legal(&mesh->texture)) ||
        pel_mesh_wrong_part(mesh->part, mesh->parts, mesh->vertices,
                            mesh->triangles) < mesh->parts)
        return PEL_ERROR_SIZE;
    for (uint32_t i = 0; i < mesh->images; i++)
        if (!mesh->image[i].image)
            return PEL_ERROR_NULL;
    for (uint32_t i = 0; mesh->images && i < mesh->parts; i++)
        if (mesh->part[i].texture > mesh->images)
            return PEL_ERROR_SIZE;
    return PEL_OK;
}

/* The numerator of the number q: divided by 2^shift it is the coordinate. */
static inline int32_t pel_quantization_value(const struct pel_quantization *p,
                                             int axis, int32_t q)
{
    return p->offset[axis] + q * p->step;
}

#endif
