/* The meshes of scripts: what is set for them, and each one on its scene.
 * Only for script*.c. */
#ifndef SIM_SCRIPT_MESHES_H
#define SIM_SCRIPT_MESHES_H

#include "sim/script/commands.h"
#include "sim/render/scene.h"

/* What commands have set for the meshes that follow. */
struct script_scene {
    struct scene_settings settings;
    int32_t texture; /* of script_assets.texts: its file; -1: the mesh's own */
    bool smooth_normals;
};

/* As pel render begins, on all of the canvas. */
void script_scene_init(struct script_scene *scene, int32_t width,
                       int32_t height);

/* Never moved: a scene points into itself. */
struct script_mesh {
    struct model model;
    struct scene scene;
};

/* Loads a mesh and prepares it as place->scene says. False, with a message that
 * names the line, when it cannot. */
bool script_add_mesh(const struct script_place *place, const char *word,
                     int32_t *index);

void script_mesh_free(struct script_mesh *mesh);

#endif
