/* The cheapest shading of each part of a mesh, and the cheapest mapping of each
 * of its textures, found by measuring: pictures of many views are drawn in
 * every way, and compared with the one in perspective that is exact at every
 * pixel. */
#ifndef SIM_ASSET_MEASURE_H
#define SIM_ASSET_MEASURE_H

#include "sim/render/scene.h"

/* From the cheapest on; of meshes without light the first three. */
enum { MEASURE_SHADINGS = 5, MEASURE_MAPPINGS = 9 };

struct measure {
    const char *views; /* a number, or a file; NULL: nothing is measured */
    double tolerance;  /* steps of 255 */

    /* What was found. Errors are the largest of all channels, pixels and views,
     * steps of 255; a part or texture that no view shows has -1 everywhere, and
     * the last way. */
    bool lit;
    int count;         /* of views */
    int width, height; /* px of each */
    size_t parts, textures;
    uint8_t *shading;                       /* of each part */
    uint8_t *mapping;                       /* of each texture */
    int (*shading_error)[MEASURE_SHADINGS]; /* with the mapping that is taken */
    int (*mapping_error)[MEASURE_MAPPINGS];
};

/* A view is a turn of the mesh, or a line of the file: X,Y,Z of --turn and, if
 * they move, of the eye, and of the target, with blanks between; # begins a
 * comment. A number of views turns the mesh to be seen from all sides. All
 * else is the settings'. False, with a message; free it in any case. */
bool measure_model(struct measure *measure, const struct model *model,
                   const struct scene_settings *settings);
void measure_free(struct measure *measure);

/* The object of core, without its &. */
const char *measure_shading_name(const struct measure *measure, int shading);
bool measure_in_world(int shading);
const char *measure_mapping_name(int mapping);
int measure_mapping_span(int mapping);

#endif
