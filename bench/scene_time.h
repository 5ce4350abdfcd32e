/* Times pictures of the 3-D pipeline. */
#ifndef BENCH_SCENE_TIME_H
#define BENCH_SCENE_TIME_H

#include "core/scene/pipeline.h"
#include "scene_mesh.h"
#include "timing.h"

/* A way to draw. */
struct scene_mode {
    const char *name;
    const struct pel_shading *shading;
    const struct pel_mapping *mapping; /* NULL: no texture */
    bool bilinear;
    int32_t span;
    int depth_bits; /* 0: painter's order; 32: beside OSMesa */
    int32_t steps;  /* the tolerance */
};

/* What is drawn of a mesh: side by side pixels, in so many bands, by as many
 * threads at a time, which have a frame each. */
struct scene_cut {
    int32_t side, bands, threads;
};

struct scene_result {
    struct quartiles ns; /* of a whole picture, prepared and drawn: CPU time,
                            of several threads that of the longest */
    double pixels;       /* drawn in it, hidden ones too */
    struct quartiles peer_ns; /* of OSMesa; 0: not timed */
    struct scene_difference {
        double mean; /* of channels where both have drawn, of 255 */
        int32_t most;
        int32_t pixels; /* drawn by one of the two alone */
    } difference;       /* from OSMesa's picture */
};

/* In xrgb8888, the camera before the mesh. Several bands or threads draw in
 * painter's order. */
void bench_scene_time(struct scene_result *out, const struct bench_mesh *m,
                      const struct scene_mode *mode,
                      const struct scene_cut *cut);

#endif
