#include "reference_scene.h"

static real power_of_two(int n)
{
    real v = 1;
    for (; n > 0; n--)
        v *= 2;
    for (; n < 0; n++)
        v /= 2;
    return v;
}

static real dot(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const real a[3], const real b[3], real out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static void normalize(real v[3])
{
    const real length = real_root(dot(v, v));
    for (int k = 0; k < 3; k++)
        v[k] = length > 0 ? v[k] / length : 0;
}

static void turn(const struct pel_scene *s, real v[3])
{
    const real in[3] = {v[0], v[1], v[2]};
    if (!s->pose)
        return;
    for (int i = 0; i < 3; i++) {
        real row[3];
        for (int k = 0; k < 3; k++)
            row[k] = (real)s->pose->turn.row[i][k] / PEL_COSINE_ONE;
        v[i] = dot(row, in);
    }
}

void reference_place(const struct pel_scene *scene, uint32_t vertex,
                     real place[3])
{
    const struct pel_quantization *q = &scene->mesh->position;
    for (int k = 0; k < 3; k++)
        place[k] = ((real)q->offset[k] +
                    (real)scene->mesh->positions[vertex][k] * q->step) /
                   power_of_two(q->shift);
    turn(scene, place);
    for (int k = 0; k < 3; k++)
        place[k] += scene->pose ? (real)scene->pose->at[k] / 65536 : 0;
}

void reference_normal(const struct pel_scene *scene, uint32_t vertex,
                      real normal[3])
{
    const struct pel_mesh *m = scene->mesh;
    for (int k = 0; k < 3; k++)
        normal[k] =
            m->normals16 ? m->normals16[vertex][k] : m->normals8[vertex][k];
    turn(scene, normal);
}

void reference_project(const struct pel_scene *scene, const real place[3],
                       real out[3])
{
    const struct pel_camera *c = &scene->camera;
    const struct pel_rect *r = &scene->viewport;
    const real middle[2] = {(real)(r->x0 + r->x1) / 2,
                            (real)(r->y0 + r->y1) / 2};
    const real size[2] = {r->x1 - r->x0, r->y1 - r->y0};
    real forward[3], up[3], axis[2][3], from_eye[3];
    for (int k = 0; k < 3; k++) {
        forward[k] = ((real)c->target[k] - c->eye[k]) / 65536;
        up[k] = c->up[k];
        from_eye[k] = place[k] - (real)c->eye[k] / 65536;
    }
    normalize(forward);
    cross(forward, up, axis[0]);
    normalize(axis[0]);
    cross(forward, axis[0], axis[1]);
    out[2] = dot(forward, from_eye);
    for (int k = 0; k < 2; k++) {
        const real along = dot(axis[k], from_eye);
        out[k] = middle[k];
        if (c->projection == PEL_ORTHOGRAPHIC)
            out[k] += size[k] / ((real)c->sensor[k] / 65536) * along;
        else
            out[k] += size[k] / c->sensor[k] * c->focal * along / out[2];
    }
}

static int32_t nearest(real v)
{
    int32_t n = (int32_t)v;
    for (; n > v - 0.5L; n--)
        ;
    for (; n < v - 0.5L; n++)
        ;
    return n;
}

struct pel_point reference_snap(const real projected[3])
{
    return (struct pel_point){nearest(projected[0] * 256),
                              nearest(projected[1] * 256)};
}

static real side(struct pel_point a, struct pel_point b, int32_t x, int32_t y)
{
    return ((real)b.x - a.x) * (y * 256 + 128 - a.y) -
           ((real)b.y - a.y) * (x * 256 + 128 - a.x);
}

void reference_weights(const struct pel_point v[3], int32_t x, int32_t y,
                       real weight[3])
{
    const real a = side(v[1], v[2], x, y), b = side(v[2], v[0], x, y);
    const real c = side(v[0], v[1], x, y);
    weight[0] = a / (a + b + c);
    weight[1] = b / (a + b + c);
    weight[2] = c / (a + b + c);
}

/* What one light adds to the factors of a channel. */
struct terms {
    real diffuse, specular;
};

static struct terms terms_of(const struct pel_scene *s,
                             const struct pel_light *light, const real place[3],
                             const real n[3])
{
    struct terms t = {0, 0};
    real l[3], v[3], r[3];
    for (int k = 0; k < 3; k++) {
        const real at = light->at[k];
        l[k] = light->directional ? at : at / 65536 - place[k];
        v[k] = (real)s->camera.eye[k] / 65536 - place[k];
    }
    normalize(l);
    normalize(v);
    if (s->lighting->both_sides && dot(n, v) < 0)
        for (int k = 0; k < 6; k++)
            (k < 3 ? l : v)[k % 3] *= -1;
    const real nl = dot(n, l);
    for (int k = 0; k < 3; k++)
        r[k] = 2 * nl * n[k] - l[k];
    t.diffuse = nl > 0 ? nl : 0;
    if (dot(r, v) > 0 && (nl > 0 || !s->lighting->no_back_highlights)) {
        t.specular = 1;
        for (int32_t i = 0; i < s->lighting->shininess; i++)
            t.specular *= dot(r, v);
    }
    return t;
}

void reference_light(const struct pel_scene *scene, const real place[3],
                     const real normal[3], const real surface[3], real out[3])
{
    const struct pel_lighting *l = scene->lighting;
    const bool directed = dot(normal, normal) > 0;
    real n[3] = {normal[0], normal[1], normal[2]};
    normalize(n);
    for (int k = 0; k < 3; k++)
        out[k] =
            (real)l->ambient / 65536 * l->ambient_color[k] / 65536 * surface[k];
    for (int32_t i = 0; directed && i < l->lights; i++) {
        const struct terms t = terms_of(scene, &l->light[i], place, n);
        for (int k = 0; k < 3; k++) {
            const real bright = l->plain_highlights ? 255 : surface[k];
            out[k] += (real)l->light[i].color[k] / 65536 *
                      ((real)l->diffuse / 65536 * t.diffuse * surface[k] +
                       (real)l->specular / 65536 * t.specular * bright);
        }
    }
    for (int k = 0; k < 3; k++)
        out[k] = out[k] < 255 ? out[k] : 255;
}

static int32_t floor_of(real v)
{
    int32_t n = (int32_t)v;
    return n > v ? n - 1 : n;
}

static int32_t wrapped(int32_t i, int32_t size, enum pel_wrap wrap)
{
    if (wrap == PEL_WRAP_CLAMP)
        return i < 0 ? 0 : i >= size ? size - 1 : i;
    const int32_t period = wrap == PEL_WRAP_MIRROR ? 2 * size : size;
    i = (i % period + period) % period;
    return i < size ? i : 2 * size - 1 - i;
}

static real texel(const struct pel_mesh_texture *t, int32_t i, int32_t j,
                  int channel)
{
    i = wrapped(i, t->texels.width, t->wrap_u);
    j = wrapped(j, t->texels.height, t->wrap_v);
    return t->texels.colors[j * t->texels.width + i] >> (16 - 8 * channel) &
           255;
}

void reference_texel(const struct pel_mesh_texture *texture, real u, real v,
                     bool bilinear, real out[3])
{
    const real back = bilinear ? 0.5L : 0;
    const int32_t i = floor_of(u - back), j = floor_of(v - back);
    const real fu = bilinear ? u - back - i : 0;
    const real fv = bilinear ? v - back - j : 0;
    for (int k = 0; k < 3; k++)
        out[k] = (1 - fv) * ((1 - fu) * texel(texture, i, j, k) +
                             fu * texel(texture, i + 1, j, k)) +
                 fv * ((1 - fu) * texel(texture, i, j + 1, k) +
                       fu * texel(texture, i + 1, j + 1, k));
}

void reference_uv(const struct pel_scene *scene, uint32_t vertex, real uv[2])
{
    const struct pel_quantization *q = &scene->mesh->texture;
    const struct pel_texels *t = &scene->texture->texels;
    for (int k = 0; k < 2; k++)
        uv[k] =
            ((real)q->offset[k] + (real)scene->mesh->uv[vertex][k] * q->step) /
            power_of_two(q->shift) * (k ? t->height : t->width);
}
