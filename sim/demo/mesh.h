/* The mesh that demos draw: the duck of assimp-testmodels, or the built-in vase
 * where that is not to be had. */
#ifndef SIM_DEMO_MESH_H
#define SIM_DEMO_MESH_H

#include "sim/demo/demo.h"
#include "sim/render/scene.h"

/* The mesh before it is quantised; `source` tells what was taken (its path is
 * good until the next call), and the result's note says so. False, with a
 * message, when it cannot be read. */
bool demo_mesh_load(struct mesh *mesh, struct model_source *source,
                    struct demo_result *result);

/* The same as a model, with its texture; the vase gets a generated one. */
bool demo_mesh_model(struct model *model, struct demo_result *result);

/* Adds a texture, a board of squares in two colours, when the model has none;
 * the note says so. False, with a message, when it has no uv, or there is no
 * memory. */
bool demo_mesh_add_texture(struct model *model, struct demo_result *result);

/* Draws the model: clears, prepares and draws, and takes the time of all. */
bool demo_mesh_draw(const struct model *model,
                    const struct scene_settings *settings,
                    struct demo_result *result);

#endif
