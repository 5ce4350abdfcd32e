#include <stdlib.h>
#include <string.h>

#include "api.h"

enum { VERTICES = 6, TRIANGLES = 4, PARTS = 3 };

struct place {
    struct pel_mesh mesh;
    struct pel_pose pose;
    struct pel_light light[2];
    struct pel_lighting lighting;
    struct pel_mesh_texture texture;
    struct pel_mesh_part part[PARTS];
    int16_t positions[VERTICES][3], normals[VERTICES][3];
    uint16_t uv[VERTICES][2];
    uint8_t colors[VERTICES][3], indices[TRIANGLES][3];
};

static void take_quantum(struct api *a, struct pel_quantization *q)
{
    for (int k = 0; k < 3; k++)
        q->offset[k] = input_number(&a->in);
    q->step = input_byte(&a->in) & 1 ? input_number(&a->in) : 1;
    q->shift = (int8_t)input_byte(&a->in) % 66;
}

static void take_mesh(struct api *a, struct place *p)
{
    const uint32_t kind = input_byte(&a->in);
    p->mesh = (struct pel_mesh){.vertices = VERTICES,
                                .triangles = TRIANGLES,
                                .position = {{0, 0, 0}, 1, 8},
                                .texture = {{0, 0, 0}, 1, 16},
                                .positions = (void *)p->positions,
                                .indices8 = (void *)p->indices};
    p->mesh.normals16 = kind & 1 ? (void *)p->normals : NULL;
    p->mesh.uv = kind & 2 ? (void *)p->uv : NULL;
    p->mesh.colors = kind & 4 ? (void *)p->colors : NULL;
    if (kind & 8)
        take_quantum(a, &p->mesh.position);
    if (kind & 16)
        take_quantum(a, &p->mesh.texture);
    uint8_t *bytes = (uint8_t *)p->positions;
    for (size_t i = 0; i < sizeof p->positions; i++)
        bytes[i] = input_byte(&a->in);
    memcpy(p->normals, p->positions, sizeof p->normals);
    memcpy(p->uv, p->positions, sizeof p->uv);
    memcpy(p->colors, p->positions, sizeof p->colors);
    for (int i = 0; i < 3 * TRIANGLES; i++)
        p->indices[i / 3][i % 3] =
            (uint8_t)(((uint32_t)i + input_below(&a->in, 4)) % VERTICES);
    if (kind == 128)
        p->indices[3][1] = 77;
}

static void take_lighting(struct api *a, struct place *p)
{
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++) {
            p->light[i].at[k] = input_number(&a->in);
            p->light[i].color[k] = input_byte(&a->in) * 300;
        }
        p->light[i].directional = input_byte(&a->in) & 1;
    }
    p->lighting = (struct pel_lighting){.light = p->light,
                                        .lights = 2,
                                        .both_sides = p->light[0].directional,
                                        .ambient_color = {65536, 30000, 0},
                                        .ambient = input_byte(&a->in) * 300,
                                        .diffuse = input_number(&a->in),
                                        .specular = input_byte(&a->in) * 900,
                                        .shininess = input_byte(&a->in) + 1};
}

static void take_camera(struct api *a, struct pel_camera *c)
{
    const uint32_t kind = input_byte(&a->in);
    *c = (struct pel_camera){.eye = {0, 0, PEL_UNITS(200)},
                             .up = {0, 1, 0},
                             .focal = 50,
                             .sensor = {100, 100},
                             .near_plane = PEL_UNITS(1) / 64};
    for (int k = 0; k < 3; k++) {
        if (kind & 1)
            c->eye[k] = input_number(&a->in);
        if (kind & 2)
            c->target[k] = input_number(&a->in);
        if (kind & 4)
            c->up[k] = input_number(&a->in);
    }
    if (kind & 8) {
        c->focal = input_number(&a->in);
        c->sensor[0] = input_number(&a->in);
        c->sensor[1] = input_number(&a->in);
    }
    if (kind & 16)
        c->near_plane = input_number(&a->in);
    if (kind & 32)
        c->projection = PEL_ORTHOGRAPHIC;
    if ((kind & 40) == 32)
        c->sensor[0] = c->sensor[1] = PEL_UNITS(100);
}

static void take_texture(struct api *a, struct place *p, struct pel_scene *s)
{
    const uint32_t kind = input_byte(&a->in);
    const struct pel_mapping *const mappings[] = {
        &pel_map_vertices, &pel_map_affine, &pel_map_perspective};
    p->texture = (struct pel_mesh_texture){
        .texels = {kind & 1 ? &a->surface[API_SURFACES] : NULL, a->ramp, 8, 8,
                   false},
        .mapping = mappings[kind / 2 % 3],
        .sampler =
            kind & 8 ? pel_texture_init_nearest : pel_texture_init_bilinear,
        .wrap_u = (enum pel_wrap)(kind / 16 % 3),
        .wrap_v = (enum pel_wrap)(kind / 64 % 3),
        .alpha = kind & 128 ? pel_texture_cut_out : NULL,
        .span = (int32_t)(UINT32_C(1) << input_below(&a->in, 8))};
    s->texture = &p->texture;
}

/* Few are wrong. */
static void take_parts(struct api *a, struct place *p)
{
    uint32_t vertices = 0, triangles = 0;
    p->mesh.part = p->part;
    p->mesh.parts = input_below(&a->in, PARTS + 1);
    for (uint32_t i = 0; i < p->mesh.parts; i++) {
        const bool ends = i + 1 == p->mesh.parts && input_byte(&a->in) % 8 != 7;
        const uint32_t v = input_below(&a->in, VERTICES + 1 - vertices);
        const uint32_t t = input_below(&a->in, TRIANGLES + 1 - triangles);
        vertices = ends ? p->mesh.vertices : vertices + v;
        triangles = ends ? p->mesh.triangles : triangles + t;
        p->part[i] =
            (struct pel_mesh_part){vertices, triangles, input_word(&a->in),
                                   input_below(&a->in, 8) % 3};
    }
}

static void take_scene(struct api *a, struct place *p, struct pel_scene *s,
                       const struct pel_rect *bounds)
{
    static const struct pel_shading *const shadings[] = {
        &pel_shade_flat,        &pel_shade_gouraud, &pel_shade_lit_flat,
        &pel_shade_lit_gouraud, &pel_shade_phong,   &pel_shade_chosen};
    const uint32_t kind = input_byte(&a->in);
    *s = (struct pel_scene){.mesh = &p->mesh,
                            .viewport = *bounds,
                            .shading = shadings[kind % 6],
                            .tolerance = (int32_t)kind * 64,
                            .texel_tolerance = (int32_t)kind * 16,
                            .lighting = &p->lighting,
                            .color = PEL_RGB(200, 100, 50),
                            .transparency = kind & 64 ? 100 : 0,
                            .cull = (enum pel_cull)(kind / 8 % 3),
                            .sort = kind & 128 ? &pel_depth_sort_radix : NULL};
    take_mesh(a, p);
    take_lighting(a, p);
    take_camera(a, &s->camera);
    if (kind & 32)
        take_texture(a, p, s);
    if (input_byte(&a->in) % 8 == 0)
        s->viewport = api_rect(a);
    if (input_byte(&a->in) & 1) {
        pel_matrix_turn(&p->pose.turn, (int)input_below(&a->in, 3),
                        (uint16_t)input_word(&a->in));
        for (int k = 0; k < 3; k++)
            p->pose.at[k] = input_number(&a->in) % (PEL_LENGTH_MAX + 1);
        s->pose = &p->pose;
    }
    take_parts(a, p);
}

static void draw_certified(struct pel_frame *frame,
                           const struct pel_surface *surface,
                           const struct pel_depth *depth)
{
    const size_t size = PEL_CERTIFICATE_SCRATCH_SIZE(frame->triangles);
    void *scratch = malloc(size);
    struct pel_doubt doubt;
    if (pel_scene_certify(frame, scratch, size, 5000, &doubt))
        abort();
    pel_scene_draw_certified(frame, surface, &doubt.bounds, depth);
    free(scratch);
}

static void draw_depth(struct pel_frame *frame,
                       const struct pel_surface *surface, bool certified)
{
    struct pel_depth depth;
    const int bits = surface->bounds.x0 & 8 ? 32 : 16;
    const size_t size = pel_depth_size(&surface->bounds, bits);
    void *values = malloc(size);
    if (pel_depth_init(&depth, &surface->bounds, bits, values, size))
        abort();
    if (certified)
        draw_certified(frame, surface, &depth);
    else
        pel_scene_draw_depth(frame, surface, &depth);
    free(values);
}

void api_scene(struct api *a, const struct pel_surface *surface)
{
    struct place p = {.mesh = {.vertices = 0}};
    struct pel_scene scene;
    struct pel_frame frame;
    int16_t normals[VERTICES][3];
    take_scene(a, &p, &scene, &surface->bounds);
    const size_t size = pel_scene_scratch_size(&scene);
    void *scratch = malloc(size);
    pel_mesh_normals(&p.mesh, normals, scratch, size);
    if (pel_scene_prepare(&frame, &scene, scratch, size) == PEL_OK) {
        const uint32_t how = input_byte(&a->in) % 4;
        if (how)
            draw_depth(&frame, surface, how == 2);
        else
            pel_scene_draw(&frame, surface);
    }
    free(scratch);
}
