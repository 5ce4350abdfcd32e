#include "light.h"

/* All factors at once: PEL_FACTOR_END is a power of two, and the highest bits
 * of a negative number are set. */
static uint32_t factors_of(const pel_factor f[3])
{
    return (uint32_t)f[0] | (uint32_t)f[1] | (uint32_t)f[2];
}

static bool light_legal(const struct pel_light *l)
{
    int32_t any = 0;
    for (int k = 0; k < 3; k++) {
        any |= l->at[k];
        if (!pel_length_legal(l->at[k]))
            return false;
    }
    return factors_of(l->color) < PEL_FACTOR_END && (any || !l->directional);
}

static bool material_legal(const struct pel_lighting *l)
{
    const pel_factor material[3] = {l->ambient, l->diffuse, l->specular};
    return (uint32_t)l->lights <= 32 && (uint32_t)l->shininess - 1 <= 255 &&
           (factors_of(l->ambient_color) | factors_of(material)) <
               PEL_FACTOR_END;
}

/* A position of the world, or a direction, in the axes of the mesh, 2^-30. */
static PEL_NOINLINE void to_mesh(const struct pel_pose *pose,
                                 const int32_t world[3], bool directional,
                                 int64_t out[3])
{
    for (int k = 0; k < 3; k++) {
        const pel_cosine column[3] = {
            pose->turn.row[0][k], pose->turn.row[1][k], pose->turn.row[2][k]};
        const int64_t at = directional ? 0 : pel_dot(column, pose->at);
        out[k] = pel_scale_down(pel_dot(column, world) - at, 16);
    }
}

/* A position of the world in lighting units, which are 2^up parts of 2^-30, or
 * a direction. */
static void set_position(const struct pel_pose *pose, const int32_t world[3],
                         bool directional, int up, int32_t out[3])
{
    int64_t v[3];
    to_mesh(pose, world, directional, v);
    if (directional)
        pel_normalize(v, out);
    else
        for (int k = 0; k < 3; k++)
            out[k] = (int32_t)pel_scale_down(v[k], -up);
}

/* Factors times another: below 2^24. */
static void times(const pel_factor a[3], pel_factor b, pel_factor out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = pel_scaled(a[k], b, 16);
}

/* An upper bound, with as many bits as the largest, of the coordinates of the
 * mesh, the eye and the lights. All bits when a light is not legal. */
static uint64_t bound_of(const struct pel_quantization *quantization,
                         const struct pel_lighting *lighting,
                         const struct pel_pose *pose, const pel_length eye[3])
{
    uint64_t bound = (uint64_t)pel_scale_down(
        pel_quantization_extent(quantization), quantization->shift - 30);
    int64_t v[3];
    to_mesh(pose, eye, false, v);
    for (int32_t i = 0; i < lighting->lights; i++) {
        const struct pel_light *light = &lighting->light[i];
        bound |= pel_vector_bound(v);
        if (!light_legal(light))
            return UINT64_MAX;
        if (!light->directional)
            to_mesh(pose, light->at, false, v);
    }
    return bound | pel_vector_bound(v);
}

enum pel_status pel_mesh_lights_init(struct pel_mesh_lights *lights,
                                     const struct pel_lighting *lighting,
                                     const struct pel_mesh *mesh,
                                     const struct pel_pose *pose,
                                     const pel_length eye[3])
{
    if (lighting->lights > 0 && !lighting->light)
        return PEL_ERROR_NULL;
    if (!material_legal(lighting))
        return PEL_ERROR_RANGE;
    /* Bits to the left of 2^-30 unit. */
    const int up =
        28 - pel_bits_of(bound_of(&mesh->position, lighting, pose, eye));
    if (up < -34)
        return PEL_ERROR_RANGE;
    lights->lighting = lighting;
    lights->count = lighting->lights;
    lights->mesh = mesh;
    lights->down = mesh->position.shift - 30 - up;
    set_position(pose, eye, false, up, lights->eye);
    times(lighting->ambient_color, lighting->ambient, lights->ambient);
    for (int32_t i = 0; i < lighting->lights; i++) {
        const struct pel_light *light = &lighting->light[i];
        struct pel_mesh_light *m = &lights->light[i];
        m->directional = light->directional;
        set_position(pose, light->at, light->directional, up, m->at);
        times(light->color, lighting->diffuse, m->diffuse);
        times(light->color, lighting->specular, m->specular);
    }
    return PEL_OK;
}

void pel_mesh_lights_position(const struct pel_mesh_lights *lights,
                              const int16_t position[3], int32_t out[3])
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        out[k] = (int32_t)pel_scale_down(
            pel_quantization_value(&lights->mesh->position, k, position[k]),
            lights->down);
}

/* A product is cut by less than 2^-30, and the n - 1 products that n makes of
 * it leave less than n 2^-30. */
pel_cosine pel_cosine_power(pel_cosine v, int32_t n)
{
    uint32_t base = (uint32_t)v, result = (uint32_t)PEL_COSINE_ONE;
    for (; n > 0 && result; n >>= 1) {
        if (n & 1)
            result = (uint32_t)(pel_multiply(result, base) >> 30);
        base = (uint32_t)(pel_multiply(base, base) >> 30);
    }
    return (pel_cosine)result;
}

/* pel_weighted, inlined where pixels need it and code may be long. */
static inline int32_t cosine_of(const pel_cosine a[3], const pel_cosine b[3])
{
#if PEL_LONG_MULTIPLY && !defined(__OPTIMIZE_SIZE__)
    return (int32_t)((pel_dot(a, b) + (1 << 29)) >> 30);
#else
    return pel_weighted(a, b);
#endif
}

/* R.V = 2 (N.L) (N.V) - L.V, in halves, which fit. */
pel_cosine pel_light_reflected(pel_cosine towards[3][3], pel_cosine nl)
{
    const int32_t half = pel_scaled(nl, cosine_of(towards[0], towards[1]), 30) -
                         (cosine_of(towards[2], towards[1]) >> 1);
    return 2 * pel_max(pel_min(half, PEL_COSINE_ONE / 2), 0);
}

/* sum += factor part. Factors are below 2^24, so 32 lights fit with both of
 * their terms. Most pixels are out of the highlight. */
static void add(pel_factor sum[3], const pel_factor factor[3], pel_cosine part)
{
    if (part == 0)
        return;
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        sum[k] += (pel_factor)pel_share((uint32_t)factor[k], part, 30);
}

/* The direction from one position to another. */
static void direction(const int32_t from[3], const int32_t to[3],
                      pel_cosine unit[3])
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        unit[k] = to[k] - from[k];
    pel_normalize_fast(unit, unit);
}

void pel_light_add(const struct pel_mesh_lights *lights,
                   const struct pel_mesh_light *light, pel_cosine towards[3][3],
                   struct pel_light_sum *sum)
{
    const pel_cosine nl = cosine_of(towards[0], towards[2]);
    if (nl > 0)
        add(sum->surface, light->diffuse, nl);
    else if (lights->lighting->no_back_highlights)
        return;
    add(lights->lighting->plain_highlights ? sum->plain : sum->surface,
        light->specular,
        pel_cosine_power(pel_light_reflected(towards, nl),
                         lights->lighting->shininess));
}

bool pel_light_start(const struct pel_mesh_lights *lights,
                     const int32_t value[PEL_LIGHT_VALUES],
                     pel_cosine towards[3][3], struct pel_light_sum *sum)
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        sum->surface[k] = lights->ambient[k];
        sum->plain[k] = 0;
    }
    if (!pel_normalize_fast(value + PEL_AT_NORMAL, towards[0]))
        return false;
    direction(value + PEL_AT_POSITION, lights->eye, towards[1]);
    if (lights->lighting->both_sides &&
        pel_weighted(towards[0], towards[1]) < 0)
        for (int k = 0; k < 3; k++)
            towards[0][k] = -towards[0][k];
    return true;
}

void pel_light_towards(const struct pel_mesh_light *light,
                       const int32_t position[3], pel_cosine towards[3][3])
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        towards[2][k] = light->at[k];
    if (!light->directional)
        direction(position, light->at, towards[2]);
}

static void sum_of(const struct pel_mesh_lights *lights,
                   const int32_t value[PEL_LIGHT_VALUES],
                   struct pel_light_sum *sum)
{
    pel_cosine towards[3][3];
    if (!pel_light_start(lights, value, towards, sum))
        return;
    for (int32_t i = 0; i < lights->count; i++) {
        pel_light_towards(&lights->light[i], value + PEL_AT_POSITION, towards);
        pel_light_add(lights, &lights->light[i], towards, sum);
    }
}

void pel_color_values(pel_color color, int32_t value[PEL_VALUES])
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        value[PEL_AT_COLOR + k] = (int32_t)((color >> 8 * k & 255) << 16);
}

pel_color pel_lit_color(const struct pel_mesh_lights *lights,
                        const int32_t value[PEL_VALUES])
{
    struct pel_light_sum sum;
    sum_of(lights, value, &sum);
    return pel_light_color(&sum, value);
}
