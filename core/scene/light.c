#include "light.h"

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

/* sum += factor part, in 2^-46: 2^24 2^30, and room for 256 lights. */
static void add(int64_t sum[3], const pel_factor factor[3], pel_cosine part)
{
    for (int k = 0; k < 3; k++)
        sum[k] += (int64_t)factor[k] * part;
}

static void to_light(const struct pel_mesh_light *light, const int32_t place[3],
                     pel_cosine way[3])
{
    int32_t difference[3];
    for (int k = 0; k < 3; k++) {
        way[k] = light->at[k];
        difference[k] = light->at[k] - place[k];
    }
    if (!light->directional)
        pel_unit_near(difference, way);
}

static void factors(const int64_t sum[3], pel_factor out[3])
{
    for (int k = 0; k < 3; k++) {
        int64_t f = pel_scale_down(sum[k], 30);
        out[k] =
            f < INT32_C(128) * 65536 ? (pel_factor)f : INT32_C(128) * 65536;
    }
}

void pel_mesh_lights_shine(const struct pel_mesh_lights *lights,
                           const int32_t place[3], const int32_t normal[3],
                           struct pel_shine *shine)
{
    int64_t surface[3] = {0, 0, 0}, plain[3] = {0, 0, 0};
    int64_t *bright = lights->plain_highlights ? plain : surface;
    pel_cosine n[3], v[3], l[3];
    int32_t to_eye[3];
    for (int k = 0; k < 3; k++)
        to_eye[k] = lights->eye[k] - place[k];
    add(surface, lights->ambient, PEL_COSINE_ONE);
    pel_unit_near(to_eye, v);
    const bool directed = pel_unit_near(normal, n);
    for (int32_t i = 0; i < lights->lights && directed; i++) {
        const struct pel_mesh_light *light = &lights->light[i];
        to_light(light, place, l);
        const pel_cosine nl = cosine_of(n, l);
        if (nl > 0)
            add(surface, light->diffuse, nl);
        if (nl > 0 || !lights->no_back_highlights)
            add(bright, light->specular,
                power(reflected(l, n, v, nl), lights->shininess));
    }
    factors(surface, shine->surface);
    factors(plain, shine->plain);
}

/* 65,280 times 2^23 and 255 times 2^31 fit 40 bits. */
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
