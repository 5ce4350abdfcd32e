/* The peer of the 3-D pipeline: OSMesa with a depth buffer of 32 bits. */
#ifndef BENCH_SCENE_OSMESA_H
#define BENCH_SCENE_OSMESA_H

#include "core/scene/pipeline.h"

/* A scene of bench/scene_time.c: same mesh, camera and light. */
void *scene_osmesa_open(const struct pel_scene *scene);

/* A whole picture, complete on return. */
void scene_osmesa_draw(void *peer);

/* The picture, in xrgb8888 with 255 where something was drawn. */
const uint32_t *scene_osmesa_pixels(const void *peer);

void scene_osmesa_close(void *peer);

#endif
