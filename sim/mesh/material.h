/* The materials of mesh files, as assimp reads them. */
#ifndef SIM_MESH_MATERIAL_H
#define SIM_MESH_MATERIAL_H

#include "sim/mesh/mesh.h"

struct aiColor4D;
struct aiMaterial;
struct aiScene;

/* Colors of glTF are linear, those of other files as they are shown. */
pel_color material_byte_color(const struct aiColor4D *color, bool linear);
bool material_is_linear(const struct aiMaterial *from);

/* Sets the material, and adds its texture to the mesh unless it is there:
 * `path` is that of the mesh file. False, with a message, when memory is short.
 */
bool material_read(struct mesh_material *to, struct mesh *mesh,
                   const struct aiScene *scene, const struct aiMaterial *from,
                   const char *path);

#endif
