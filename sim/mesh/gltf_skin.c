/* Skins (chapter 3.7.3): the joints as they stand. */
#include "sim/mesh/gltf.h"

#ifdef HAVE_JANSSON
#include <stdlib.h>
#include <string.h>

/* The node that has this one as a child; -1: none. */
static json_int_t parent_of(const struct gltf *g, json_int_t index)
{
    const json_t *nodes = json_object_get(g->root, "nodes");
    for (size_t i = 0; i < json_array_size(nodes); i++) {
        const json_t *children =
            json_object_get(json_array_get(nodes, i), "children");
        for (size_t k = 0; k < json_array_size(children); k++)
            if (json_integer_value(json_array_get(children, k)) == index)
                return (json_int_t)i;
    }
    return -1;
}

/* From a node to the world. */
static bool world_of(struct gltf *g, json_int_t index, double to[16])
{
    size_t depth = json_array_size(json_object_get(g->root, "nodes"));
    if (!gltf_node_matrix(g, gltf_at(g, "nodes", index), to))
        return false;
    while ((index = parent_of(g, index)) >= 0) {
        double above[16], own[16];
        memcpy(own, to, sizeof(own));
        if (depth-- == 0 ||
            !gltf_node_matrix(g, gltf_at(g, "nodes", index), above))
            return gltf_refuse(g, "nodes[%lld] is below itself",
                               (long long)index);
        gltf_multiply(above, own, to);
    }
    return g->good;
}

bool gltf_skin(struct gltf *g, const json_t *skin, struct gltf_skin *to)
{
    const json_t *joints = json_object_get(skin, "joints");
    const json_int_t inverse = gltf_index(g, skin, "inverseBindMatrices");
    struct gltf_array bind = {NULL, 0, 16};
    to->count = json_array_size(joints);
    to->matrix = calloc(to->count + 1, sizeof(*to->matrix));
    if (!to->matrix || (inverse >= 0 && !gltf_accessor(g, inverse, &bind)))
        return false;
    if (bind.number && (bind.components != 16 || bind.count < to->count))
        return gltf_refuse(g, "a skin has too few inverse bind matrices");
    for (size_t i = 0; i < to->count; i++) {
        const json_t *joint = json_array_get(joints, i);
        double world[16];
        if (!json_is_integer(joint) ||
            !world_of(g, json_integer_value(joint), world))
            return gltf_refuse(g, "a joint of a skin is no node");
        if (bind.number)
            gltf_multiply(world, bind.number + 16 * i, to->matrix[i]);
        else
            memcpy(to->matrix[i], world, sizeof(world));
    }
    free(bind.number);
    return true;
}

#else
typedef int gltf_skin_needs_jansson;
#endif
