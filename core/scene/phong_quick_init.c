#include "../base/sqrt.h"
#include "shading.h"

enum { ONE_BITS = PEL_QUICK_BITS };

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
    for (int32_t i = 0; i < lights->count; i++)
        gray = gray && equal(lights->light[i].diffuse) &&
               equal(lights->light[i].specular);
    return gray;
}

void pel_phong_quick_init(struct pel_phong_quick *paint,
                          struct pel_frame *frame,
                          const struct pel_lit_corners *corners,
                          const struct pel_color_paint *surface,
                          const pel_color color[3])
{
    static const int32_t one[2][3] = {{0, 1 << ONE_BITS, 0},
                                      {0, 0, 1 << ONE_BITS}};
    const struct pel_mesh_lights *lights = &frame->lights;
    field normal, eye;
    pel_color_paint_init(&paint->base, pel_phong_quick_colors, frame->opaque);
    paint->lights = lights;
    paint->surface = surface;
    paint->alpha = frame->alpha;
    paint->gray = is_gray(lights);
    for (int i = 0; i < 2; i++)
        pel_frame_plane(frame, one[i], &paint->weight[i]);
    set_normals(corners, normal);
    set_directions(corners, lights->eye, eye);
    multiply(normal, normal, &paint->d);
    paint->d.k[0] -= 1 << ONE_BITS;
    for (int k = 0; k < 6; k++)
        paint->d.k[k] = -paint->d.k[k];
    multiply(normal, eye, &paint->eye);
    for (int32_t i = 0; i < lights->count; i++)
        set_light(paint, i, corners, normal, eye);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            paint->color[i][k] = (int32_t)((color[i] >> 8 * k & 255) << 8);
    }
    paint->one_color = ((color[0] ^ color[1]) | (color[0] ^ color[2])) == 0;
    to_field(paint->color);
}
