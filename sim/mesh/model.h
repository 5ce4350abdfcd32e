/* Meshes as core draws them: quantised as `pel import` does it, and with their
 * texture. */
#ifndef SIM_MESH_MODEL_H
#define SIM_MESH_MODEL_H

#include "core/asset/mesh_asset.h"
#include "core/scene/mesh.h"
#include "sim/mesh/mesh.h"
#include "sim/image/picture.h"

/* A picture as a material has it: texels of MESH_CUT_OUT are drawn where their
 * alpha is 128 or more. */
struct model_texture {
    struct mesh_material material;
    struct picture picture; /* straight alpha */
    struct picture glow;    /* as large, and empty but where colours of vertices
                               multiply the texels: this is added after that */
    bool opaque;
};

/* Owns what it points to; {0} is an empty one. */
struct model {
    struct pel_mesh mesh;   /* world units; normals of 16 bits and colors are
                               always there, uv where the file has them */
    double low[3], high[3]; /* the box around it, world units */
    struct pel_mesh_part *part; /* mesh.part */
    bool plain; /* its colors are those of materials: they show no shape */
    struct model_texture *texture; /* the numbers of mesh.part */
    size_t textures;
};

struct model_source {
    const char *path;     /* a mesh file or MESH_BUILTIN */
    const char *texture;  /* a picture file; NULL: the mesh's own */
    bool without_texture; /* none is read */
    bool smooth_normals;  /* made from the faces, whatever the file has */
    bool has_crease;      /* the same, with: */
    double crease;        /* of mesh_normals */
};

/* Reads a mesh and its textures; source->texture goes to all parts with uv. A
 * texture of the mesh's own that cannot be read is left out, with a message.
 * False, with a message on standard error, when the mesh or source->texture
 * cannot be read, or the mesh has no uv for it; `model` is then empty. */
bool model_load(struct model *model, const struct model_source *source);

/* The parts of it, for meshes that are changed in between. asset_bits: 0; or,
 * of an asset in flash, those of normals, 8 or 16, and a shift of
 * PEL_MESH_SHIFT_MAX at most. */
bool model_read(struct mesh *mesh, const struct model_source *source);
bool model_make(struct model *model, const struct mesh *mesh, int asset_bits);
bool model_add_textures(struct model *model, const struct mesh *mesh,
                        const struct model_source *source);

/* Lays a picture, which it takes, on the whole model. */
bool model_set_picture(struct model *model, const struct picture *picture);

/* The middle of its box, and how far the corners are from it. */
double model_middle(const struct model *model, double middle[3]);

/* Gives the vertices the texels at their uv: those that a program finds which
 * samples there. */
void model_paint(struct model *model);

/* For those who draw the picture alone: what shines in it, too. */
void model_add_glow(struct model_texture *texture);

/* A vertex's color as the mesh has it. */
void model_set_color(uint8_t to[3], pel_color color);

void model_free(struct model *model);

/* Coordinates as the 16-bit numbers of core/asset/mesh_asset.h. For the
 * positions of a mesh: signed numbers, around the middle of its box.
 * The shift is at most `shift_max`. */
struct pel_quantization quantize_positions(const struct mesh *mesh,
                                           int shift_max);

/* The nearest number of a coordinate. */
long quantize(const struct pel_quantization *quantum, int axis, double value);

#endif
