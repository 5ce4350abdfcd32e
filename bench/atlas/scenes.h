/* Scenes for the order of triangles, as a camera sees them. */
#ifndef BENCH_ATLAS_SCENES_H
#define BENCH_ATLAS_SCENES_H

#include <pel/pel.h>

#include "../random.h"

enum { SCENE_SIDE = 256, SCENE_TRIANGLES = 4096 };

/* The near plane of all scenes; distances are larger. */
#define SCENE_NEAR .5

struct scene_triangle {
    struct pel_point v[3]; /* on the screen of SCENE_SIDE^2 pixels */
    double z[3];           /* distances */
};

struct scene {
    struct scene_triangle triangle[SCENE_TRIANGLES];
    int32_t n;
};

struct scene_maker {
    const char *name;
    void (*make)(struct scene *s, struct random *r);
};

/* Ends with a NULL name. */
extern const struct scene_maker scene_makers[];

#endif
