/* The meshes of scene scripts: what is set for them, and each one on its stage.
 * Only for scene*.c. */
#ifndef SIM_SCENE_MESHES_H
#define SIM_SCENE_MESHES_H

#include "scene_commands.h"
#include "stage.h"

/* What commands have set for the meshes that follow. */
struct scene_stage {
    struct stage_settings settings;
    int32_t texture; /* of scene_assets.texts: its file; -1: the mesh's own */
    bool smooth_normals;
};

/* As pel render begins, on all of the canvas. */
void scene_stage_init(struct scene_stage *stage, int32_t width, int32_t height);

/* Never moved: a stage points into itself. */
struct scene_mesh {
    struct model model;
    struct stage stage;
};

/* Loads a mesh and prepares it as place->stage says. False, with a message that
 * names the line, when it cannot. */
bool scene_add_mesh(const struct scene_place *place, const char *word,
                    int32_t *index);

void scene_mesh_free(struct scene_mesh *mesh);

#endif
