/* Lights, material, and the light that a surface reflects at a position. */
#ifndef PEL_SCENE_LIGHT_H
#define PEL_SCENE_LIGHT_H

#include "../base/color.h"
#include "camera.h"

PEL_BEGIN_DECLS

/* A light without fall-off. Colors are red, green, blue. */
struct pel_light {
    int32_t at[3]; /* position in the world, pel_length; of a directional light
                      the direction to it, of any length up to 2^30, not 0 */
    bool directional;
    pel_factor color[3];
};

/* At a position with the normal N and the direction V to the eye, of length 1,
 *
 *     ambient ambient_color + sum over lights of
 *         color (diffuse max(N.L, 0) + specular max(R.V, 0)^shininess)
 *
 * where L leads to the light and R = 2 (N.L) N - L; the surface's color
 * multiplies every term, and the result is clamped to 0..255. The specular term
 * counts where N.L <= 0 too. Where N is 0 there is ambient light alone. */
struct pel_lighting {
    const struct pel_light *light;
    int32_t lights; /* 0..32 */
    pel_factor ambient_color[3];
    pel_factor ambient, diffuse, specular;
    int32_t shininess;       /* 1..256 */
    bool plain_highlights;   /* the surface does not color the specular term */
    bool no_back_highlights; /* none where N.L <= 0 */
    bool both_sides;         /* -N instead of N where N.V < 0 */
};

/* A light in the axes of the mesh, multiplied by the material. */
struct pel_mesh_light {
    int32_t at[3]; /* lighting units; of a directional one pel_cosine */
    bool directional;
    pel_factor diffuse[3], specular[3];
};

/* Positions are in lighting units, a power of two of world units, along the
 * axes of the mesh: below 2^29 for the mesh, the lights and the eye. */
struct pel_mesh_lights {
    struct pel_mesh_light *light;
    int32_t count; /* of them: lighting->lights, or those that are not left out
                      (select.h) */
    const struct pel_lighting *lighting;
    const struct pel_mesh *mesh;
    int32_t eye[3];
    pel_factor ambient[3];
    int32_t down; /* bits from quantized positions to lighting units */
};

/* The caller sets lights->light to memory for lighting->lights entries and
 * keeps lighting and mesh. PEL_ERROR_RANGE: a factor, the shininess, a position
 * or the number of lights out of range, a directional light with no direction;
 * PEL_ERROR_NULL: no list. */
enum pel_status pel_mesh_lights_init(struct pel_mesh_lights *lights,
                                     const struct pel_lighting *lighting,
                                     const struct pel_mesh *mesh,
                                     const struct pel_pose *pose,
                                     const pel_length eye[3]);

/* A vertex's position in lighting units. */
void pel_mesh_lights_position(const struct pel_mesh_lights *lights,
                              const int16_t position[3], int32_t out[3]);

/* The light at a position: red, green and blue factors, below 2^31. */
struct pel_light_sum {
    pel_factor surface[3]; /* multiplied by the surface's color */
    pel_factor plain[3];   /* not multiplied */
};

/* The values that make a color: three of a normal, of any length up to 2^30,
 * which is scaled to length 1 without a division; three of a position, in
 * lighting units; and the blue, green and red of the surface, 2^-16 step. */
enum {
    PEL_AT_NORMAL = 0,
    PEL_AT_POSITION = 3,
    PEL_LIGHT_VALUES = 6,
    PEL_AT_COLOR = PEL_LIGHT_VALUES,
    PEL_VALUES = 9
};

/* The color of such values, rounded to the nearest, without alpha; a surface
 * below 0 counts as 0. */
pel_color pel_lit_color(const struct pel_mesh_lights *lights,
                        const int32_t value[PEL_VALUES]);

/* Sets the last three to those of a color. */
void pel_color_values(pel_color color, int32_t value[PEL_VALUES]);

/* The steps of pel_lit_color, for those who need the directions too: to the
 * normal, to the eye, to the light. start sets the first two and the ambient
 * light, and is false where the normal is 0; towards sets the third; add adds
 * the light. pel_light_reflected: R.V, above 0, from all three and N.L. */
bool pel_light_start(const struct pel_mesh_lights *lights,
                     const int32_t value[PEL_LIGHT_VALUES],
                     pel_cosine towards[3][3], struct pel_light_sum *sum);
void pel_light_towards(const struct pel_mesh_light *light,
                       const int32_t position[3], pel_cosine towards[3][3]);
void pel_light_add(const struct pel_mesh_lights *lights,
                   const struct pel_mesh_light *light, pel_cosine towards[3][3],
                   struct pel_light_sum *sum);
pel_cosine pel_light_reflected(pel_cosine towards[3][3], pel_cosine nl);

/* v^n, n from 0 on, 0 <= v <= 1: too low by less than n 2^-30. */
pel_cosine pel_cosine_power(pel_cosine v, int32_t n);

/* Both products stay below 65,280 2^15, and their sum below 2^32. */
static inline pel_color pel_light_color(const struct pel_light_sum *sum,
                                        const int32_t value[PEL_VALUES])
{
    pel_color out = 0;
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        const int32_t own = (value[PEL_AT_COLOR + k] + 128) >> 8;
        uint32_t v = pel_share(PEL_CAST(uint32_t, pel_max(own, 0)),
                               sum->surface[2 - k], 16) +
                     128;
        if (sum->plain[2 - k])
            v += pel_share(65280, sum->plain[2 - k], 16);
        out |= (v >> 8 < 255 ? v >> 8 : 255) << 8 * k;
    }
    return out;
}
PEL_END_DECLS
#endif
