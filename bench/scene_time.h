/* Times pictures of the 3-D pipeline. */
#ifndef BENCH_SCENE_TIME_H
#define BENCH_SCENE_TIME_H

#include "core/scene/pipeline.h"
#include "scene_mesh.h"

/* A way to draw. */
struct scene_mode {
    const char *name;
    const struct pel_shading *shading;
    const struct pel_mapping *mapping; /* NULL: no texture */
    bool bilinear;
    int32_t span;
    int depth_bits; /* 0: painter's order; 32: beside OSMesa */
};

struct scene_result {
    double ns;      /* of a whole picture, prepared and drawn: the median */
    double pixels;  /* drawn in it, hidden ones too */
    double peer_ns; /* of OSMesa; 0: not timed */
};

/* In xrgb8888, side by side pixels, the camera before the mesh. */
void bench_scene_time(struct scene_result *out, const struct bench_mesh *m,
                      const struct scene_mode *mode, int32_t side);

#endif
