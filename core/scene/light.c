#include "light.h"

/* v^n in 2^-30, 0 <= v <= 2^30. A product is cut by less than 2^-30, and the
 * n - 1 products that n makes of it leave less than n 2^-30. */
static pel_cosine power(pel_cosine v, int32_t n)
{
    uint32_t base = (uint32_t)v, result = (uint32_t)PEL_COSINE_ONE;
    for (; n > 0 && result; n >>= 1) {
        if (n & 1)
            result = (uint32_t)(pel_multiply(result, base) >> 30);
        base = (uint32_t)(pel_multiply(base, base) >> 30);
    }
    return (pel_cosine)result;
}

static pel_cosine cosine_of(const pel_cosine a[3], const pel_cosine b[3])
{
    return (pel_cosine)pel_scale_down(pel_dot(a, b), 30);
}

/* R.V = 2 (N.L) (N.V) - L.V, above 0 and at most 1; in halves, which fit. */
static pel_cosine reflected(const pel_cosine l[3], const pel_cosine n[3],
                            const pel_cosine v[3], pel_cosine nl)
{
    const int32_t half =
        pel_scaled(nl, cosine_of(n, v), 30) - (cosine_of(l, v) >> 1);
    return 2 * pel_max(pel_min(half, PEL_COSINE_ONE / 2), 0);
}

/* sum += factor part. Factors are below 2^24, so 32 lights fit with both of
 * their terms. */
static void add(pel_factor sum[3], const pel_factor factor[3], pel_cosine part)
{
    for (int k = 0; k < 3; k++)
        sum[k] += pel_scaled(factor[k], part, 30);
}

/* The direction from one place to another. */
static void lead(const int32_t from[3], const int32_t to[3], pel_cosine unit[3])
{
    for (int k = 0; k < 3; k++)
        unit[k] = to[k] - from[k];
    pel_normalize_fast(unit, unit);
}

/* way: the normal, to the eye, to the light. */
static void add_light(const struct pel_mesh_lights *lights,
                      const struct pel_mesh_light *light, pel_cosine way[3][3],
                      struct pel_light_sum *shine)
{
    const pel_cosine nl = cosine_of(way[0], way[2]);
    if (nl > 0)
        add(shine->surface, light->diffuse, nl);
    else if (lights->lighting->no_back_highlights)
        return;
    add(lights->lighting->plain_highlights ? shine->plain : shine->surface,
        light->specular,
        power(reflected(way[2], way[0], way[1], nl),
              lights->lighting->shininess));
}

void pel_mesh_lights_sum(const struct pel_mesh_lights *lights,
                         const int32_t place[3], const int32_t normal[3],
                         struct pel_light_sum *shine)
{
    pel_cosine way[3][3];
    for (int k = 0; k < 3; k++) {
        shine->surface[k] = lights->ambient[k];
        shine->plain[k] = 0;
    }
    if (!pel_normalize_fast(normal, way[0]))
        return;
    lead(place, lights->eye, way[1]);
    for (int32_t i = 0; i < lights->lighting->lights; i++) {
        const struct pel_mesh_light *light = &lights->light[i];
        for (int k = 0; k < 3; k++)
            way[2][k] = light->at[k];
        if (!light->directional)
            lead(place, light->at, way[2]);
        add_light(lights, light, way, shine);
    }
}

/* Both products stay below 65,280 2^15, and their sum below 2^32. */
uint32_t pel_lit_channel(const struct pel_light_sum *shine, int channel,
                         uint32_t surface)
{
    const uint32_t v =
        (uint32_t)pel_scaled((int32_t)surface, shine->surface[channel], 16) +
        (uint32_t)pel_scaled(65280, shine->plain[channel], 16) + 128;
    return v >> 8 < 255 ? v >> 8 : 255;
}

pel_color pel_lit_color(const struct pel_light_sum *shine, pel_color surface)
{
    pel_color out = surface & UINT32_C(0xFF000000);
    for (int k = 0; k < 3; k++)
        out |= pel_lit_channel(shine, k, (surface >> (16 - 8 * k) & 255) << 8)
               << (16 - 8 * k);
    return out;
}
