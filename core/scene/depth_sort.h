/* Painter's order: triangles from the farthest to the nearest. */
#ifndef PEL_SCENE_DEPTH_SORT_H
#define PEL_SCENE_DEPTH_SORT_H

#include <stdint.h>

#include "../base/inline.h"

PEL_BEGIN_DECLS

struct pel_depth_entry {
    int32_t depth; /* any number that grows with the distance */
    uint32_t index;
};

/* Sorts by falling depth, equal depths by rising index: one order only, so the
 * result is the same on every CPU. In place, no recursion, at most about
 * 2 n log2(n) comparisons for any input. */
void pel_depth_sort(struct pel_depth_entry *entry, uint32_t n);
PEL_END_DECLS
#endif
