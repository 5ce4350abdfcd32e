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

/* Where k3 to k5 are 0. */
static inline int32_t linear_at(const struct pel_polynomial *p, int32_t a,
                                int32_t b)
{
    return p->k[0] + times(a, p->k[1]) + times(b, p->k[2]);
}

/* What all lights of a pixel share: 1 / |n| - 1, and 2 (n.V) / n.n. */
struct pixel {
    int32_t a, b, longer, eye;
};

static inline void set_pixel(const struct pel_phong_quick *p,
                             struct pixel *pixel)
{
    const int32_t d = value_at(&p->d, pixel->a, pixel->b);
    const int32_t twice = 2 * (ONE + d + times(d, d));
    pixel->longer = times(d, ONE / 2 + (d >> 2) + (d >> 3));
    pixel->eye = times(value_at(&p->eye, pixel->a, pixel->b), twice);
}

/* Adds a light to the first channels of the sum. */
static PEL_INLINE_KINDS void add(const struct pel_phong_quick *p, int32_t i,
                                 const struct pixel *at, int channels,
                                 struct pel_light_sum *sum)
{
    const struct pel_lighting *lighting = p->lights->lighting;
    const struct pel_mesh_light *light = &p->lights->light[i];
    const struct pel_polynomial *of = p->light[i].of;
    const bool flat = light->directional;
    const int32_t nl =
        flat ? linear_at(&of[0], at->a, at->b) : value_at(&of[0], at->a, at->b);
    const int32_t along =
        flat ? linear_at(&of[1], at->a, at->b) : value_at(&of[1], at->a, at->b);
    const int32_t w = pel_min(times(nl, at->eye) - along, ONE);
    if (nl > 0)
        for (int k = 0; k < channels; k++)
            sum->surface[k] +=
                times(light->diffuse[k], nl + times(nl, at->longer));
    if (w <= 0 || (nl <= 0 && lighting->no_back_highlights))
        return;
    const int32_t bright = power(w, lighting->shininess);
    pel_factor *highlight =
        lighting->plain_highlights ? sum->plain : sum->surface;
    for (int k = 0; k < channels; k++)
        highlight[k] += times(light->specular[k], bright);
}

/* Channel k of the surface, 1/256 step. */
static inline uint32_t surface_of(const struct pel_phong_quick *p, int k,
                                  const struct pixel *at, pel_color under)
{
    if (p->surface)
        return (under >> 8 * k & 255) << 8;
    int32_t own = p->color[0][k];
    if (!p->one_color)
        own += times(at->a, p->color[1][k]) + times(at->b, p->color[2][k]);
    return (uint32_t)own;
}

static PEL_INLINE_KINDS void light(const struct pel_phong_quick *p, int32_t x,
                                   int32_t y, int32_t n, pel_color *out,
                                   int channels)
{
    const struct pel_mesh_lights *lights = p->lights;
    uint64_t a = pel_plane_at(&p->weight[0], x, y);
    uint64_t b = pel_plane_at(&p->weight[1], x, y);
    for (; n > 0; n--, out++) {
        struct pixel at = {pel_plane_whole(a), pel_plane_whole(b), 0, 0};
        struct pel_light_sum sum = {{0, 0, 0}, {0, 0, 0}};
        pel_color lit = p->surface ? pel_alpha(*out) : 255;
        lit = pel_round_div255(lit * p->alpha) << 24;
        for (int k = 0; k < channels; k++)
            sum.surface[k] = lights->ambient[k];
        set_pixel(p, &at);
        for (int32_t i = 0; i < lights->lighting->lights; i++)
            add(p, i, &at, channels, &sum);
        for (int k = 0; k < 3; k++) {
            const int c = channels == 1 ? 0 : 2 - k;
            const uint64_t own = surface_of(p, k, &at, *out);
            const uint64_t v = (own * (uint32_t)sum.surface[c] +
                                UINT64_C(65280) * (uint32_t)sum.plain[c]) >>
                               16;
            lit |= (v < 65280 ? (uint32_t)(v + 128) >> 8 : 255) << 8 * k;
        }
        *out = lit;
        a += p->weight[0].dx;
        b += p->weight[1].dx;
    }
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_phong_quick *p = (const void *)paint;
    if (p->surface)
        p->surface->colors(p->surface, x, y, n, out);
    if (p->gray)
        light(p, x, y, n, out, 1);
    else
        light(p, x, y, n, out, 3);
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

/* Scaled so that `length` is 1. */
static void set_normals(const struct pel_lit_corners *corners, field normal)
{
    int shift;
    const uint32_t inverse = pel_inverse_root(corners->length, &shift);
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
    multiply(normal, way, &p->light[i].of[0]);
    multiply(eye, way, &p->light[i].of[1]);
}

static bool equal(const pel_factor v[3])
{
    return v[0] == v[1] && v[1] == v[2];
}

static bool is_gray(const struct pel_mesh_lights *lights)
{
    bool gray = equal(lights->ambient);
    for (int32_t i = 0; i < lights->lighting->lights; i++)
        gray = gray && equal(lights->light[i].diffuse) &&
               equal(lights->light[i].specular);
    return gray;
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
    paint->gray = is_gray(lights);
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
    paint->one_color = ((color[0] ^ color[1]) | (color[0] ^ color[2])) == 0;
    to_field(paint->color);
}
