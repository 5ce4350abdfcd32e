#include "light.h"

/* All factors at once: PEL_FACTOR_END is a power of two, and the highest bits
 * of a negative number are set. */
static uint32_t factors_of(const pel_factor f[3])
{
    return (uint32_t)f[0] | (uint32_t)f[1] | (uint32_t)f[2];
}

static bool light_legal(const struct pel_light *l)
{
    uint32_t any = 0;
    for (int k = 0; k < 3; k++) {
        any |= (uint32_t)l->at[k];
        if (l->at[k] > PEL_LENGTH_MAX || l->at[k] < -PEL_LENGTH_MAX)
            return false;
    }
    return factors_of(l->color) < PEL_FACTOR_END && (any || !l->directional);
}

static enum pel_status check(const struct pel_lighting *l)
{
    const pel_factor material[3] = {l->ambient, l->diffuse, l->specular};
    if (l->lights > 0 && !l->light)
        return PEL_ERROR_NULL;
    if ((uint32_t)l->lights > 32 || (uint32_t)l->shininess - 1 > 255 ||
        (factors_of(l->ambient_color) | factors_of(material)) >= PEL_FACTOR_END)
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

/* As many bits as the farthest of the mesh, the eye and the lights has. */
static int bits_of(const struct pel_mesh_lights *m,
                   const struct pel_lighting *lighting,
                   const struct pel_pose *pose, const pel_length eye[3])
{
    const struct pel_mesh_quantum *q = &m->quantum;
    uint64_t reach = 0;
    int64_t v[3];
    for (int k = 0; k < 3; k++)
        v[k] =
            pel_scale_down(pel_size_of(q->offset[k]) + INT64_C(32768) * q->step,
                           q->shift - 30);
    reach |= pel_reach_of(v);
    to_mesh(pose, eye, false, v);
    reach |= pel_reach_of(v);
    for (int32_t i = 0; i < lighting->lights; i++)
        if (!lighting->light[i].directional) {
            to_mesh(pose, lighting->light[i].at, false, v);
            reach |= pel_reach_of(v);
        }
    return pel_bits_of(reach);
}

static void place(const int64_t world[3], int up, int32_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (int32_t)pel_scale_down(world[k], -up);
}

/* Below 2^24. */
static pel_factor times(pel_factor a, pel_factor b)
{
    return (pel_factor)pel_scale_down((int64_t)a * b, 16);
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
        m->diffuse[k] = times(light->color[k], lighting->diffuse);
        m->specular[k] = times(light->color[k], lighting->specular);
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
    const int up = 28 - bits_of(lights, lighting, pose, eye);
    lights->down = (int8_t)(mesh->position.shift - 30 - up);
    lights->lights = lighting->lights;
    lights->shininess = lighting->shininess;
    lights->plain_highlights = lighting->plain_highlights;
    lights->no_back_highlights = lighting->no_back_highlights;
    to_mesh(pose, eye, false, v);
    place(v, up, lights->eye);
    for (int k = 0; k < 3; k++)
        lights->ambient[k] =
            times(lighting->ambient_color[k], lighting->ambient);
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
