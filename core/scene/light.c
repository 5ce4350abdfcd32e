#include "light.h"

#include <string.h>

/* v^n in 2^-30, 0 <= v <= 2^30. A product is cut by less than 2^-30, and the
 * n - 1 products that n makes of it leave less than n 2^-30. */
static pel_cosine power(pel_cosine v, int32_t n)
{
    uint32_t base = (uint32_t)v, result = (uint32_t)PEL_COSINE_ONE;
    for (; n > 0 && result; n >>= 1) {
        if (n & 1)
            result = (uint32_t)((uint64_t)result * base >> 30);
        base = (uint32_t)((uint64_t)base * base >> 30);
    }
    return (pel_cosine)result;
}

static pel_cosine cosine_of(const pel_cosine a[3], const pel_cosine b[3])
{
    return (pel_cosine)(pel_dot(a, b) >> 30);
}

/* R.V = 2 (N.L) (N.V) - L.V, above 0 and at most 1. */
static pel_cosine reflected(const pel_cosine l[3], const pel_cosine n[3],
                            const pel_cosine v[3], pel_cosine nl)
{
    int64_t r = ((int64_t)nl * cosine_of(n, v) >> 29) - cosine_of(l, v);
    r = r < PEL_COSINE_ONE ? r : PEL_COSINE_ONE;
    return r > 0 ? (pel_cosine)r : 0;
}

/* sum += factor part. Factors are below 2^24, so 32 lights fit with both of
 * their terms. */
static void add(pel_factor sum[3], const pel_factor factor[3], pel_cosine part)
{
    for (int k = 0; k < 3; k++)
        sum[k] += (pel_factor)(((int64_t)factor[k] * part + (1 << 29)) >> 30);
}

/* The direction from one place to another. */
static void lead(const int32_t from[3], const int32_t to[3], pel_cosine unit[3])
{
    for (int k = 0; k < 3; k++)
        unit[k] = to[k] - from[k];
    pel_unit_near(unit, unit);
}

/* way: the normal, to the eye, to the light. */
static void add_light(const struct pel_mesh_lights *lights,
                      const struct pel_mesh_light *light, pel_cosine way[3][3],
                      struct pel_shine *shine)
{
    const pel_cosine nl = cosine_of(way[0], way[2]);
    if (nl > 0)
        add(shine->surface, light->diffuse, nl);
    if (nl <= 0 && lights->no_back_highlights)
        return;
    const pel_cosine rv = reflected(way[2], way[0], way[1], nl);
    if (rv > 0)
        add(lights->plain_highlights ? shine->plain : shine->surface,
            light->specular, power(rv, lights->shininess));
}

void pel_mesh_lights_shine(const struct pel_mesh_lights *lights,
                           const int32_t place[3], const int32_t normal[3],
                           struct pel_shine *shine)
{
    pel_cosine way[3][3];
    for (int k = 0; k < 3; k++) {
        shine->surface[k] = lights->ambient[k];
        shine->plain[k] = 0;
    }
    if (!pel_unit_near(normal, way[0]))
        return;
    lead(place, lights->eye, way[1]);
    for (int32_t i = 0; i < lights->lights; i++) {
        const struct pel_mesh_light *light = &lights->light[i];
        for (int k = 0; k < 3; k++)
            way[2][k] = light->at[k];
        if (!light->directional)
            lead(place, light->at, way[2]);
        add_light(lights, light, way, shine);
    }
}

/* 65,280 times 2^31 fits 47 bits. */
uint32_t pel_shine_channel(const struct pel_shine *shine, int channel,
                           uint32_t surface)
{
    uint64_t v = (uint64_t)surface * (uint32_t)shine->surface[channel] +
                 (uint64_t)65280 * (uint32_t)shine->plain[channel];
    v = (v + (UINT32_C(1) << 23)) >> 24;
    return v < 255 ? (uint32_t)v : 255;
}

pel_color pel_shine_color(const struct pel_shine *shine, pel_color surface)
{
    pel_color out = surface & UINT32_C(0xFF000000);
    for (int k = 0; k < 3; k++)
        out |= pel_shine_channel(shine, k, (surface >> (16 - 8 * k) & 255) << 8)
               << (16 - 8 * k);
    return out;
}
