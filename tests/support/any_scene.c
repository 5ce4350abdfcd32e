#include "any_scene.h"

#include <stdio.h>

#include "check.h"

static pel_color texels[ANY_TEXELS * ANY_TEXELS];

static void any_mesh(struct random *r, struct any_scene *s)
{
    const int32_t triangles = random_between(r, 1, ANY_TRIANGLES);
    const int32_t size = random_between(r, 0, 3) ? 32767 : 2000;
    s->mesh = (struct pel_mesh){
        .vertices = (uint32_t)triangles * 3,
        .triangles = (uint32_t)triangles,
        .position = {{0, 0, 0},
                     random_between(r, 0, 1) ? 1 : random_between(r, 1, 16384),
                     0},
        .texture = {{0, 0, 0}, 1, 16},
        .positions = (void *)s->positions,
        .colors = (void *)s->colors,
        .indices8 = (void *)s->indices};
    for (int32_t i = 0; i < triangles * 3; i++) {
        s->indices[i / 3][i % 3] = (uint8_t)i;
        for (int k = 0; k < 3; k++) {
            s->positions[i][k] = (int16_t)random_between(r, -size, size);
            s->colors[i][k] = (uint8_t)random_word(r);
        }
    }
}

/* The mesh becomes between 1/16 and 256 units large, its middle anywhere near
 * its origin. */
static void any_quantum(struct random *r, struct any_scene *s)
{
    struct pel_quantization *q = &s->mesh.position;
    const int32_t extent = 32768 * q->step;
    const int32_t units = random_between(r, -4, 8); /* log2 */
    q->shift = pel_bits_of((uint64_t)extent) - units;
    for (int k = 0; k < 3; k++)
        q->offset[k] = random_between(r, -extent, extent);
}

static void any_pose(struct random *r, struct any_scene *s)
{
    struct pel_matrix a, b;
    pel_matrix_turn(&a, 0, (uint16_t)random_word(r));
    pel_matrix_turn(&b, 1, (uint16_t)random_word(r));
    pel_matrix_multiply(&s->pose.turn, &a, &b);
    for (int k = 0; k < 3; k++)
        s->pose.at[k] = random_between(r, -PEL_UNITS(100), PEL_UNITS(100));
    s->scene.pose = random_between(r, 0, 3) ? &s->pose : NULL;
}

/* The middle of the mesh in the world, and how far it reaches from there. */
static pel_length middle_of(const struct any_scene *s, pel_length middle[3])
{
    const struct pel_quantization *q = &s->mesh.position;
    int64_t v[3];
    for (int k = 0; k < 3; k++)
        v[k] = q->offset[k];
    if (s->scene.pose)
        pel_matrix_apply(&s->pose.turn, v, 30, v);
    for (int k = 0; k < 3; k++)
        middle[k] = (pel_length)pel_scale_down(v[k], q->shift - 16) +
                    (s->scene.pose ? s->pose.at[k] : 0);
    return (pel_length)pel_scale_down(INT64_C(56756) * q->step, q->shift - 16);
}

static void any_camera(struct random *r, struct any_scene *s, int32_t pixels)
{
    struct pel_camera *c = &s->scene.camera;
    pel_length middle[3], reach = middle_of(s, middle), largest = 0;
    int32_t direction[3];
    for (int k = 0; k < 3; k++) {
        direction[k] = random_between(r, -1000, 1000);
        largest =
            pel_max(largest, direction[k] < 0 ? -direction[k] : direction[k]);
        c->up[k] = random_between(r, -100, 100);
    }
    const int32_t times = random_between(r, 20, 60); /* tenths */
    for (int k = 0; k < 3; k++) {
        c->eye[k] =
            middle[k] + (pel_length)((int64_t)reach * times * direction[k] /
                                     (10 * pel_max(largest, 1)));
        c->target[k] = middle[k] + random_between(r, -reach / 8, reach / 8);
    }
    c->up[random_between(r, 0, 2)] += 1000;
    c->near_plane = reach / 64 + 1;
    c->projection =
        random_between(r, 0, 7) ? PEL_PERSPECTIVE : PEL_ORTHOGRAPHIC;
    c->focal = random_between(r, 20000, 80000);
    for (int k = 0; k < 2; k++)
        c->sensor[k] = c->projection == PEL_ORTHOGRAPHIC
                           ? reach * 2
                           : random_between(r, 30000, 36000);
    struct pel_rect *v = &s->scene.viewport;
    v->x0 = random_between(r, -200, 200) & ~7;
    v->y0 = random_between(r, -200, 200) & ~7;
    v->x1 = v->x0 + random_between(r, 8, pixels);
    v->y1 = v->y0 + random_between(r, 8, pixels);
}

/* What can be told of it in a line: the command draws the rest again. */
struct told {
    uint32_t triangles;
    struct pel_quantization quantum;
    struct pel_camera camera;
    struct pel_rect view;
};

static void print(const void *value)
{
    const struct told *t = value;
    const struct pel_camera *c = &t->camera;
    fprintf(stderr,
            "scene of %u triangles, step %d 2^-%d, seen from (%.9g, %.9g, "
            "%.9g), to (%.9g, %.9g, %.9g), near %.9g, on pixels %d, %d to %d, "
            "%d\n",
            t->triangles, t->quantum.step, t->quantum.shift, c->eye[0] / 65536.,
            c->eye[1] / 65536., c->eye[2] / 65536., c->target[0] / 65536.,
            c->target[1] / 65536., c->target[2] / 65536.,
            c->near_plane / 65536., t->view.x0, t->view.y0, t->view.x1,
            t->view.y1);
}

void any_scene_keep(const struct pel_scene *scene)
{
    const struct told told = {scene->mesh->triangles, scene->mesh->position,
                              scene->camera, scene->viewport};
    cases_keep(print, &told, sizeof told);
}

void any_scene(struct random *r, struct any_scene *s, int32_t pixels)
{
    s->scene = (struct pel_scene){
        .mesh = &s->mesh, .shading = &pel_shade_flat, .sort = &pel_depth_sort};
    any_mesh(r, s);
    if (s->mesh.triangles % 2)
        s->scene.sort = &pel_depth_sort_radix;
    any_quantum(r, s);
    any_pose(r, s);
    any_camera(r, s, pixels);
    any_scene_keep(&s->scene);
}

static void any_lights(struct random *r, struct any_scene *s)
{
    pel_length middle[3];
    const pel_length reach = middle_of(s, middle);
    for (int i = 0; i < ANY_LIGHTS; i++) {
        struct pel_light *l = &s->light[i];
        l->directional = random_between(r, 0, 1);
        for (int k = 0; k < 3; k++) {
            const pel_length away = random_between(r, -reach, reach) * 4 + 1;
            l->at[k] = l->directional ? away : middle[k] + away;
            l->color[k] = random_between(r, 0, 65536);
        }
    }
}

void any_scene_light(struct random *r, struct any_scene *s)
{
    any_lights(r, s);
    s->lighting =
        (struct pel_lighting){.light = s->light,
                              .lights = random_between(r, 0, ANY_LIGHTS),
                              .ambient_color = {65536, 50000, 30000},
                              .ambient = random_between(r, 0, 20000),
                              .diffuse = random_between(r, 0, 65536),
                              .specular = random_between(r, 0, 65536),
                              .shininess = random_between(r, 1, 64),
                              .plain_highlights = random_between(r, 0, 1),
                              .no_back_highlights = random_between(r, 0, 1),
                              .both_sides = random_between(r, 0, 1)};
    for (uint32_t i = 0; i < s->mesh.vertices; i++)
        for (int k = 0; k < 3; k++) {
            const int32_t turned = i % 3 ? s->normals[i - i % 3][k] : 0;
            const int32_t by = i % 3 ? 4000 : 16000;
            s->normals[i][k] = (int16_t)(turned + random_between(r, -by, by));
        }
    s->mesh.normals16 = (void *)s->normals;
    s->scene.lighting = &s->lighting;
}

static void any_uv(struct random *r, struct any_scene *s, int32_t side)
{
    for (uint32_t i = 0; i < s->mesh.vertices; i++)
        for (int k = 0; k < 2; k++)
            s->uv[i][k] =
                (uint16_t)(i % 3 ? s->uv[i - i % 3][k] +
                                       random_between(r, -32767, 32767)
                                 : (int32_t)(random_word(r) % 65536));
    s->mesh.uv = (void *)s->uv;
    s->scene.texture = &s->texture;
    s->texture =
        (struct pel_mesh_texture){.texels = {NULL, texels, side, side, true},
                                  .mapping = &pel_map_perspective,
                                  .wrap_u = PEL_WRAP_CLAMP,
                                  .wrap_v = PEL_WRAP_CLAMP};
}

void any_scene_noise(struct random *r, struct any_scene *s, int bits)
{
    const int32_t side = (int32_t)(UINT32_C(1) << bits);
    for (int32_t i = 0; i < side * side; i++)
        texels[i] = random_word(r) | UINT32_C(0xFF000000);
    any_uv(r, s, side);
    s->texture.sampler = pel_texture_init_bilinear;
    s->texture.wrap_u = (enum pel_wrap)random_between(r, 0, 2);
    s->texture.wrap_v = (enum pel_wrap)random_between(r, 0, 2);
}

void any_scene_prepare(struct any_scene *s, struct pel_frame *frame)
{
    const enum pel_status status =
        pel_scene_prepare(frame, &s->scene, s->scratch, sizeof s->scratch);
    if (status != PEL_OK)
        fail_msg("pel_scene_prepare: %d; %s", status, cases_replay());
}

void any_scene_draw(struct any_scene *s, const struct pel_shading *shading,
                    struct pel_frame *frame, struct canvas *canvas)
{
    s->scene.shading = shading;
    canvas_open(canvas, &pel_xrgb8888, &s->scene.viewport, 0);
    any_scene_prepare(s, frame);
    pel_scene_draw(frame, &canvas->surface);
    canvas_check(canvas);
}

static const struct pel_paint *number_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    const struct pel_flat paint = PEL_FLAT(0);
    const uint32_t number = frame->work->triangle.vertex[0] / 3 + 1;
    (void)surface;
    (void)color;
    frame->work->paint.flat = paint;
    frame->work->paint.flat.color = UINT32_C(0xFF000000) | number;
    return &frame->work->paint.flat.paint;
}

const struct pel_shading any_scene_numbers = {NULL, NULL, number_paint, 0};
