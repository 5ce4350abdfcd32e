#include "light.h"

static bool factor_legal(pel_factor f)
{
    return f >= 0 && f <= PEL_FACTOR_MAX;
}

static bool factors_legal(const pel_factor f[3])
{
    return factor_legal(f[0]) && factor_legal(f[1]) && factor_legal(f[2]);
}

static bool light_legal(const struct pel_light *l)
{
    for (int k = 0; k < 3; k++)
        if (l->at[k] > PEL_LENGTH_MAX || l->at[k] < -PEL_LENGTH_MAX)
            return false;
    return factors_legal(l->color) &&
           (!l->directional || l->at[0] || l->at[1] || l->at[2]);
}

static enum pel_status check(const struct pel_lighting *l)
{
    if (l->lights > 0 && !l->light)
        return PEL_ERROR_NULL;
    if (l->lights < 0 || l->lights > 256 || l->shininess < 1 ||
        l->shininess > 256 || !factors_legal(l->ambient_color) ||
        !factor_legal(l->ambient) || !factor_legal(l->diffuse) ||
        !factor_legal(l->specular))
        return PEL_ERROR_RANGE;
    for (int32_t i = 0; i < l->lights; i++)
        if (!light_legal(&l->light[i]))
            return PEL_ERROR_RANGE;
    return PEL_OK;
}

/* A place of the world, or a direction, in the axes of the mesh and 2^-30. */
static void to_mesh(const struct pel_pose *pose, const int32_t world[3],
                    bool directional, int64_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (int64_t)world[k] - (pose && !directional ? pose->at[k] : 0);
    const int64_t v[3] = {out[0], out[1], out[2]};
    if (pose)
        pel_matrix_apply_back(&pose->turn, v, 16, out);
    else
        for (int k = 0; k < 3; k++)
            out[k] = v[k] * 16384;
}

/* The farthest that the mesh, the eye and the lights are from the origin. */
static int64_t extent(const struct pel_mesh_lights *m,
                      const struct pel_lighting *lighting,
                      const struct pel_pose *pose, const pel_length eye[3])
{
    int64_t v[3], far = 0, distance;
    for (int32_t i = -1; i < lighting->lights; i++) {
        if (i >= 0 && lighting->light[i].directional)
            continue;
        to_mesh(pose, i < 0 ? eye : lighting->light[i].at, false, v);
        distance = pel_largest_of(v);
        far = distance > far ? distance : far;
    }
    for (int k = 0; k < 3; k++) {
        distance = pel_size_of(m->quantum.offset[k]) +
                   INT64_C(32768) * m->quantum.step;
        distance = pel_scale_down(distance, m->quantum.shift - 30);
        far = distance > far ? distance : far;
    }
    return far;
}

static void place(const int64_t world[3], int up, int32_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (int32_t)pel_scale_down(world[k], -up);
}

static void set_light(struct pel_mesh_light *m, const struct pel_light *light,
                      const struct pel_lighting *lighting,
                      const struct pel_pose *pose, int up)
{
    int64_t v[3];
    to_mesh(pose, light->at, light->directional, v);
    m->directional = light->directional;
    if (light->directional)
        pel_unit_exact(v, m->at);
    else
        place(v, up, m->at);
    for (int k = 0; k < 3; k++) {
        m->diffuse[k] = (pel_factor)pel_scale_down(
            (int64_t)light->color[k] * lighting->diffuse, 16);
        m->specular[k] = (pel_factor)pel_scale_down(
            (int64_t)light->color[k] * lighting->specular, 16);
    }
}

enum pel_status pel_mesh_lights_init(struct pel_mesh_lights *lights,
                                     const struct pel_lighting *lighting,
                                     const struct pel_mesh *mesh,
                                     const struct pel_pose *pose,
                                     const pel_length eye[3])
{
    const enum pel_status status = check(lighting);
    int64_t v[3];
    if (status != PEL_OK)
        return status;
    lights->quantum = mesh->position;
    /* Bits to the left of 2^-30 unit. */
    const int up =
        28 - pel_bits_of((uint64_t)extent(lights, lighting, pose, eye));
    lights->down = (int8_t)(mesh->position.shift - 30 - up);
    lights->lights = lighting->lights;
    lights->shininess = lighting->shininess;
    lights->plain_highlights = lighting->plain_highlights;
    lights->no_back_highlights = lighting->no_back_highlights;
    to_mesh(pose, eye, false, v);
    place(v, up, lights->eye);
    for (int k = 0; k < 3; k++)
        lights->ambient[k] = (pel_factor)pel_scale_down(
            (int64_t)lighting->ambient_color[k] * lighting->ambient, 16);
    for (int32_t i = 0; i < lighting->lights; i++)
        set_light(&lights->light[i], &lighting->light[i], lighting, pose, up);
    return PEL_OK;
}

void pel_mesh_lights_place(const struct pel_mesh_lights *lights,
                           const int16_t position[3], int32_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (int32_t)pel_scale_down(
            pel_mesh_quantum_value(&lights->quantum, k, position[k]),
            lights->down);
}
