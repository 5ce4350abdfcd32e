/* What pel_shade_chosen has chosen, counted. */
#ifndef PEL_SCENE_STATS_H
#define PEL_SCENE_STATS_H

#include "select.h"

PEL_BEGIN_DECLS

/* Set to 0 by the caller; counts grow from frame to frame. Pixels are those
 * that are drawn, so with a depth buffer not those that it hides; each is
 * counted as often as it is drawn. Triangles count once for each band, and for
 * each of the two passes through a depth buffer that translucent ones need. */
struct pel_stats {
    struct pel_color_paint paint; /* stands before the triangle's own */
    const struct pel_paint *inner;
    uint8_t at; /* the triangle's method */

    struct {
        uint32_t triangles; /* cut ones count as often as they have parts */
        uint64_t pixels;
    } method[PEL_METHODS];
    uint32_t bound;          /* the largest of all frames, 1/256 step */
    int32_t lights_left_out; /* of the last frame */
};

/* pel_shade_chosen, counted in scene->stats, which is not NULL; slower. One
 * thread at a time draws such a scene. */
extern const struct pel_shading pel_shade_counted;
PEL_END_DECLS
#endif
