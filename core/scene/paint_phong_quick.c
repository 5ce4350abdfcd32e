#include "paint_phong_quick.h"

#include "../base/sqrt.h"

/* Numbers are 2^-28, below 8 in size. */
enum { ONE_BITS = 28, ONE = 1 << ONE_BITS };

static inline int32_t times(int32_t a, int32_t b)
{
    return (int32_t)(pel_long_product(a, b) >> ONE_BITS);
}

static inline int32_t value_at(const struct pel_polynomial *p, int32_t a,
                               int32_t b)
{
    const int32_t *k = p->k;
    return k[0] + times(a, k[1] + times(a, k[3]) + times(b, k[4])) +
           times(b, k[2] + times(b, k[5]));
}

/* v^n, v from 0 to about 1. */
static inline int32_t power(int32_t v, int32_t n)
{
    int32_t result = ONE;
    for (;; v = times(v, v)) {
        if (n & 1)
            result = times(result, v);
        n >>= 1;
        if (n == 0)
            return result;
    }
}

/* The sum of all lights at a pixel, as pel_mesh_lights_sum has it. */
static inline void sum_at(const struct pel_phong_quick *p, int32_t a, int32_t b,
                          struct pel_light_sum *sum)
{
    const struct pel_mesh_lights *lights = p->lights;
    const struct pel_lighting *lighting = lights->lighting;
    const int32_t d = value_at(&p->d, a, b);
    const int32_t once = times(d, ONE / 2 + (d >> 2) + (d >> 3));
    const int32_t twice = 2 * (ONE + d + times(d, d));
    const int32_t eye = times(value_at(&p->eye, a, b), twice);
    for (int k = 0; k < 3; k++) {
        sum->surface[k] = lights->ambient[k];
        sum->plain[k] = 0;
    }
    for (int32_t i = 0; i < lighting->lights; i++) {
        const struct pel_mesh_light *light = &lights->light[i];
        const int32_t nl = value_at(&p->light[i].normal, a, b);
        const int32_t w = times(nl, eye) - value_at(&p->light[i].eye, a, b);
        pel_factor *highlight =
            lighting->plain_highlights ? sum->plain : sum->surface;
        if (nl > 0)
            for (int k = 0; k < 3; k++)
                sum->surface[k] +=
                    times(light->diffuse[k], nl + times(nl, once));
        else if (lighting->no_back_highlights)
            continue;
        if (w <= 0)
            continue;
        const int32_t bright = power(pel_min(w, ONE), lighting->shininess);
        for (int k = 0; k < 3; k++)
            highlight[k] += times(light->specular[k], bright);
    }
}

static PEL_NOINLINE void light(const struct pel_phong_quick *p, int32_t x,
                               int32_t y, int32_t n, pel_color *out)
{
    uint64_t at[2] = {pel_plane_at(&p->weight[0], x, y),
                      pel_plane_at(&p->weight[1], x, y)};
    for (; n > 0; n--, out++) {
        const int32_t a = pel_plane_whole(at[0]), b = pel_plane_whole(at[1]);
        struct pel_light_sum sum;
        pel_color lit = pel_round_div255(pel_alpha(*out) * p->alpha) << 24;
        sum_at(p, a, b, &sum);
        for (int k = 0; k < 3; k++) {
            const int32_t own =
                p->surface ? (int32_t)((*out >> 8 * k & 255) << 8)
                           : p->color[0][k] + times(a, p->color[1][k]) +
                                 times(b, p->color[2][k]);
            lit |= pel_lit_channel(&sum, 2 - k, (uint32_t)own) << 8 * k;
        }
        *out = lit;
        at[0] += p->weight[0].dx;
        at[1] += p->weight[1].dx;
    }
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_phong_quick *p = (const void *)paint;
    if (p->surface)
        p->surface->colors(p->surface, x, y, n, out);
    else
        for (int32_t i = 0; i < n; i++)
            out[i] = UINT32_C(0xFF000000);
    light(p, x, y, n, out);
}

/* A direction, or any vector, that is linear: at vertex 0, and what is added at
 * the others. */
typedef int32_t field[3][3];

static int32_t dot(const int32_t a[3], const int32_t b[3])
{
    return (int32_t)(pel_dot(a, b) >> ONE_BITS);
}

/* The product of two fields. */
static void multiply(field v, field w, struct pel_polynomial *p)
{
    p->k[0] = dot(v[0], w[0]);
    p->k[1] = dot(v[0], w[1]) + dot(v[1], w[0]);
    p->k[2] = dot(v[0], w[2]) + dot(v[2], w[0]);
    p->k[3] = dot(v[1], w[1]);
    p->k[4] = dot(v[1], w[2]) + dot(v[2], w[1]);
    p->k[5] = dot(v[2], w[2]);
}

static void to_field(field v)
{
    for (int i = 1; i < 3; i++)
        for (int k = 0; k < 3; k++)
            v[i][k] -= v[0][k];
}

/* Scaled so that the shortest normal has length 1. */
static void set_normals(const struct pel_lit_corners *corners, field normal)
{
    int shift;
    const uint32_t inverse = pel_inverse_root(corners->shortest, &shift);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            normal[i][k] =
                pel_scaled(corners->normal[i][k], (int32_t)(inverse >> 1),
                           61 - ONE_BITS - shift);
    to_field(normal);
}

/* The directions to a place. */
static void set_directions(const struct pel_lit_corners *corners,
                           const int32_t to[3], field v)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            v[i][k] = to[k] - corners->position[i][k];
        pel_normalize_fast(v[i], v[i]);
        for (int k = 0; k < 3; k++)
            v[i][k] >>= 30 - ONE_BITS;
    }
    to_field(v);
}

static void set_light(struct pel_phong_quick *p, int32_t i,
                      const struct pel_lit_corners *corners, field normal,
                      field eye)
{
    const struct pel_mesh_light *from = &p->lights->light[i];
    field way = {{0}, {0}, {0}};
    if (from->directional)
        for (int k = 0; k < 3; k++)
            way[0][k] = from->at[k] >> (30 - ONE_BITS);
    else
        set_directions(corners, from->at, way);
    multiply(normal, way, &p->light[i].normal);
    multiply(eye, way, &p->light[i].eye);
}

void pel_phong_quick_init(struct pel_phong_quick *paint,
                          const struct pel_mesh_lights *lights,
                          const struct pel_lit_corners *corners,
                          const struct pel_color_paint *surface,
                          const pel_color color[3])
{
    field normal, eye;
    paint->base.colors = colors;
    paint->lights = lights;
    paint->surface = surface;
    set_normals(corners, normal);
    set_directions(corners, lights->eye, eye);
    multiply(normal, normal, &paint->d);
    paint->d.k[0] -= ONE;
    for (int k = 0; k < 6; k++)
        paint->d.k[k] = -paint->d.k[k];
    multiply(normal, eye, &paint->eye);
    for (int32_t i = 0; i < lights->lighting->lights; i++)
        set_light(paint, i, corners, normal, eye);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            paint->color[i][k] = (int32_t)((color[i] >> 8 * k & 255) << 8);
    }
    to_field(paint->color);
}
