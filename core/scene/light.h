/* Light: what a surface shows of it at a place. */
#ifndef PEL_SCENE_LIGHT_H
#define PEL_SCENE_LIGHT_H

#include "../base/color.h"
#include "camera.h"

PEL_BEGIN_DECLS

/* A light without fall-off. Colours are red, green, blue. */
struct pel_light {
    int32_t at[3]; /* a place in the world, pel_length; of a directional one
                      the way towards it, in any scale up to 2^30, not 0 */
    bool directional;
    pel_factor color[3];
};

/* At a place P with the normal N and V the way to the eye, all of length 1,
 *
 *     ambient ambient_color + sum over lights of
 *         color (diffuse max(N.L, 0) + specular max(R.V, 0)^shininess)
 *
 * where L leads to the light and R = 2 (N.L) N - L; the surface's colour
 * multiplies every term, and the result is held in 0..255. The specular term
 * is kept where N.L <= 0, as the formula stands. Where N is 0 there is ambient
 * light alone. A single term is had by setting the other factors to 0, a single
 * light by the list. */
struct pel_lighting {
    const struct pel_light *light;
    int32_t lights; /* 0..32 */
    pel_factor ambient_color[3];
    pel_factor ambient, diffuse, specular;
    int32_t shininess;       /* 1..256 */
    bool plain_highlights;   /* the surface does not colour the specular term */
    bool no_back_highlights; /* none where N.L <= 0 */
};

/* A light as the mesh sees it, in its own axes; products with the material. */
struct pel_mesh_light {
    int32_t at[3]; /* lighting units; a directional one's: pel_cosine */
    bool directional;
    pel_factor diffuse[3], specular[3];
};

/* Places are in lighting units: 2^-unit_bits of the world's, along the axes of
 * the mesh, below 2^29 for the mesh, the lights and the eye. */
struct pel_mesh_lights {
    struct pel_mesh_light *light; /* lighting->lights of them */
    const struct pel_lighting *lighting;
    const struct pel_mesh *mesh;
    int32_t eye[3];
    pel_factor ambient[3];
    int32_t down; /* bits from the numbers of a place to lighting units */
};

/* lights->light is set before, to memory for lighting->lights entries; lighting
 * and mesh stay. PEL_ERROR_RANGE: a factor, the shininess or a place out of
 * range, a directional light with no direction, a negative number of lights;
 * PEL_ERROR_NULL: no list. */
enum pel_status pel_mesh_lights_init(struct pel_mesh_lights *lights,
                                     const struct pel_lighting *lighting,
                                     const struct pel_mesh *mesh,
                                     const struct pel_pose *pose,
                                     const pel_length eye[3]);

/* A vertex's place in lighting units. */
void pel_mesh_lights_position(const struct pel_mesh_lights *lights,
                              const int16_t position[3], int32_t place[3]);

/* The light at a place: red, green and blue factors, below 2^31. */
struct pel_light_sum {
    pel_factor surface[3]; /* what the surface's colour multiplies */
    pel_factor plain[3];   /* what it does not */
};

/* normal: a vector of any length up to 2^30; it is brought to length 1 without
 * a division. */
void pel_mesh_lights_sum(const struct pel_mesh_lights *lights,
                         const int32_t place[3], const int32_t normal[3],
                         struct pel_light_sum *shine);

/* A channel of the colour, 0 red to 2 blue, 0..255; surface in 1/256 steps,
 * 0..65,280. Rounded to the nearest. */
uint32_t pel_lit_channel(const struct pel_light_sum *shine, int channel,
                         uint32_t surface);

/* All three, with the alpha of `surface`. */
pel_color pel_lit_color(const struct pel_light_sum *shine, pel_color surface);
PEL_END_DECLS
#endif
