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
    int16_t position[SCENE_TRIANGLES][3][3]; /* of the vertices in the world */
    struct pel_projector projector;
    int32_t n;
};

/* Positions, and who looks at them. */
extern const struct pel_quantization scene_unit;
extern const struct pel_camera scene_camera;
extern const struct pel_rect scene_screen;

struct scene_maker {
    const char *name;
    void (*make)(struct scene *s, struct random *r);
    int kinds; /* how many different scenes there are of it, at least */
};

/* Ends with a NULL name. */
extern const struct scene_maker scene_makers[];

/* Projects as core does, so that a frame of the positions has the same
 * vertices. */
void scene_make(struct scene *s, const struct scene_maker *maker,
                struct random *r);

#endif
