/* One light with highlights, for meshes. */
#ifndef BENCH_LIGHTING_H
#define BENCH_LIGHTING_H

#include "core/scene/light.h"

static const struct pel_light light = {
    .at = {PEL_UNITS(2), PEL_UNITS(3), PEL_UNITS(4)},
    .color = {65536, 65536, 65536}};
static const struct pel_lighting lighting = {
    .light = &light,
    .lights = 1,
    .ambient_color = {65536, 65536, 65536},
    .ambient = PEL_FACTOR(20),
    .diffuse = PEL_FACTOR(70),
    .specular = PEL_FACTOR(30),
    .shininess = 20};

#endif
