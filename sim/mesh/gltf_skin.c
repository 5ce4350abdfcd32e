/* Skins (chapter 3.7.3): the joints as they stand. */
#include "sim/mesh/gltf.h"

#include <stdlib.h>
#include <string.h>

void *gltf_refuse_depth(struct gltf *g, json_int_t node)
{
    return gltf_refuse(g,
                       "nodes[%lld] has more than %d nodes above it, or is "
                       "below itself: expected no more",
                       (long long)node, GLTF_DEPTH);
}

/* From a node to the world. */
static bool world_of(struct gltf *g, json_int_t index, double to[16])
{
    const json_int_t joint = index;
    if (!gltf_node_matrix(g, gltf_at(g, "nodes", index), to))
        return false;
    for (int depth = 0; g->parent[index] >= 0; depth++) {
        double above[16], own[16];
        memcpy(own, to, sizeof(own));
        index = g->parent[index];
        if (depth >= GLTF_DEPTH)
            return gltf_refuse_depth(g, joint);
        if (!gltf_node_matrix(g, gltf_at(g, "nodes", index), above))
            return false;
        gltf_multiply(above, own, to);
    }
    return g->good;
}

bool gltf_skin(struct gltf *g, const json_t *skin, struct gltf_skin *to)
{
    const json_t *joints = gltf_list(g, skin, "joints");
    const json_int_t inverse = gltf_index(g, skin, "inverseBindMatrices");
    struct gltf_array bind = {NULL, 0, 16};
    to->count = json_array_size(joints);
    to->matrix = calloc(to->count + 1, sizeof(*to->matrix));
    if (!to->matrix)
        return gltf_refuse(g, "no memory for %zu joints", to->count);
    if (!g->good || (inverse >= 0 && !gltf_accessor(g, inverse, &bind)))
        return false;
    if (bind.number && (bind.components != 16 || bind.count < to->count))
        return gltf_refuse(g,
                           "a skin has %zu inverseBindMatrices of %d numbers: "
                           "expected %zu of 16",
                           bind.count, bind.components, to->count);
    for (size_t i = 0; i < to->count; i++) {
        const json_t *joint = json_array_get(joints, i);
        double world[16];
        if (!json_is_integer(joint) ||
            !world_of(g, json_integer_value(joint), world))
            return gltf_refuse(
                g, "a joint of a skin is no node: expected an index of "
                   "'nodes'");
        if (bind.number)
            gltf_multiply(world, bind.number + 16 * i, to->matrix[i]);
        else
            memcpy(to->matrix[i], world, sizeof(world));
    }
    free(bind.number);
    return true;
}
