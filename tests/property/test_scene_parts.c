/* Meshes of several parts equal their triangles drawn one by one, each as a
 * mesh with the material of its part. */
#include <string.h>

#include "tests/support/any_scene.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"

enum { SIDE = 64, PARTS = 5, TEXTURES = 2, TEXELS = 8 };

static struct any_scene s;
static struct pel_mesh_part part[PARTS];
static struct pel_mesh_texture texture[TEXTURES], plain[TEXTURES];
static pel_color texels[TEXELS * TEXELS], cut[TEXELS * TEXELS];
static uint32_t depths[SIDE * SIDE];

/* The second one is cut out, as texels show that are drawn or not. */
static void any_textures(struct random *r)
{
    for (int i = 0; i < TEXELS * TEXELS; i++) {
        texels[i] = random_word(r);
        cut[i] = pel_alpha(texels[i]) < 128 ? 0 : texels[i] | 0xFF000000u;
    }
    for (int i = 0; i < TEXTURES; i++) {
        texture[i] = s.texture;
        if (random_word(r) % 2)
            texture[i].mapping = i ? &pel_map_affine : &pel_map_vertices;
    }
    texture[1].sampler = pel_texture_init_nearest;
    texture[1].texels =
        (struct pel_texels){NULL, texels, TEXELS, TEXELS, false};
    memcpy(plain, texture, sizeof plain);
    plain[1].texels.colors = cut;
    texture[1].alpha = pel_texture_cut_out;
}

static void any_parts(struct random *r)
{
    uint32_t end = 0;
    s.mesh.part = part;
    s.mesh.parts = PARTS;
    s.scene.texture = texture;
    s.scene.textures = TEXTURES;
    any_textures(r);
    for (int i = 0; i < PARTS; i++) {
        end = i < PARTS - 1
                  ? end + random_word(r) % (s.mesh.triangles - end + 1)
                  : s.mesh.triangles;
        part[i] = (struct pel_mesh_part){
            3 * end, end,
            random_word(r) | (random_word(r) % 2 ? UINT32_C(0xFF000000) : 0),
            random_word(r) % (TEXTURES + 1)};
    }
}

static void any_drawing(struct random *r)
{
    static const struct pel_shading *const shading[] = {
        &pel_shade_flat, &pel_shade_gouraud, &pel_shade_lit_gouraud,
        &pel_shade_phong};
    any_scene(r, &s, SIDE);
    any_scene_light(r, &s);
    any_scene_noise(r, &s, 3);
    s.scene.shading = shading[random_word(r) % 4];
    s.scene.transparency = random_word(r) % 2 ? 0 : (uint8_t)random_word(r);
    if (random_word(r) % 2)
        s.mesh.colors = NULL;
    any_parts(r);
}

static const struct pel_mesh_part *part_of(uint32_t triangle)
{
    const struct pel_mesh_part *p = part;
    while (triangle >= p->triangles)
        p++;
    return p;
}

/* Triangle i alone, on whatever depths there are. */
static void draw_one(const struct pel_frame *whole, uint32_t i,
                     const struct canvas *c, const struct pel_depth *depth)
{
    static uint64_t scratch[sizeof s.scratch / 8];
    const struct pel_mesh_part *p = part_of(i);
    struct pel_scene one = *whole->scene;
    struct pel_mesh mesh = *one.mesh;
    struct pel_frame frame;
    mesh.parts = 0;
    mesh.indices8 += i;
    mesh.triangles = 1;
    one.mesh = &mesh;
    one.color = p->color;
    one.transparency =
        (uint8_t)(255 - pel_round_div255(pel_alpha(p->color) *
                                         (255u - one.transparency)));
    one.texture = p->texture ? &plain[p->texture - 1] : NULL;
    assert_int_equal(pel_scene_prepare(&frame, &one, scratch, sizeof scratch),
                     PEL_OK);
    if (depth)
        pel_scene_draw_depth(&frame, &c->surface, depth);
    else
        pel_scene_draw(&frame, &c->surface);
}

static void draw_each(const struct pel_frame *frame, const struct canvas *c,
                      const struct pel_depth *depth)
{
    for (int pass = 0; pass < 2; pass++)
        for (uint32_t k = 0; k < frame->triangles; k++) {
            const uint32_t i = frame->order[k].index;
            const bool opaque = pel_alpha(part_of(i)->color) == 255 &&
                                frame->scene->transparency == 0;
            if (depth ? opaque == !pass : !pass)
                draw_one(frame, i, c, depth);
        }
}

TEST(parts_equal_meshes_of_their_own)
{
    static struct canvas got, want;
    for (struct cases c = cases_of(400); cases_next(&c);) {
        const bool deep = random_word(&c.random) % 2;
        struct pel_frame frame;
        struct pel_depth depth;
        any_drawing(&c.random);
        any_scene_prepare(&s, &frame);
        const struct pel_rect *v = &s.scene.viewport;
        pel_depth_init(&depth, v, 32, depths, sizeof depths);
        canvas_open(&got, &pel_xrgb8888, v, 0);
        canvas_open(&want, &pel_xrgb8888, v, 0);
        if (deep)
            pel_scene_draw_depth(&frame, &got.surface, &depth);
        else
            pel_scene_draw(&frame, &got.surface);
        pel_depth_clear(&depth);
        draw_each(&frame, &want, deep ? &depth : NULL);
        canvas_check_same(&want, &got);
    }
}

TEST(wrong_parts_are_named)
{
    static const struct {
        uint32_t vertices[2], triangles[2], texture; /* the second's */
        enum pel_status status;
        uint32_t part;
    } rows[] = {
        {{3, 0}, {1, 0}, 0, PEL_OK, 0},
        {{3, 0}, {1, 0}, TEXTURES, PEL_OK, 0},
        {{3, 0}, {1, 0}, TEXTURES + 1, PEL_ERROR_RANGE, 1},
        {{3, 1}, {1, 0}, 0, PEL_ERROR_SIZE, 1},
        {{3, 0}, {1, 1}, 0, PEL_ERROR_SIZE, 1},
        {{UINT32_MAX, 0}, {1, 0}, 0, PEL_ERROR_SIZE, 1},
        {{3, 0}, {UINT32_MAX, 0}, 0, PEL_ERROR_SIZE, 1},
    };
    struct random r = cases_shared(1);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct pel_frame frame;
        any_drawing(&r);
        s.mesh.parts = 2;
        for (int k = 0; k < 2; k++)
            part[k] = (struct pel_mesh_part){
                (k ? s.mesh.vertices : 0) + rows[i].vertices[k],
                (k ? s.mesh.triangles : 0) + rows[i].triangles[k], 0,
                k ? rows[i].texture : 0};
        frame.fault.part = 0;
        const enum pel_status status =
            pel_scene_prepare(&frame, &s.scene, s.scratch, sizeof s.scratch);
        if (status != rows[i].status ||
            (status != PEL_OK && frame.fault.part != rows[i].part))
            fail_msg("row %zu: status %d, part %u", i, status,
                     frame.fault.part);
    }
    s.mesh.part = NULL;
    assert_int_equal(pel_mesh_check(&s.mesh, NULL), PEL_ERROR_NULL);
}

TEST(no_texture_of_nothing)
{
    const struct pel_mesh_image image = {NULL, 0, 0, false};
    struct pel_surface surface;
    assert_int_equal(
        pel_mesh_texture_of_image(NULL, &surface, &image, &pel_rgb565_le),
        PEL_ERROR_NULL);
    assert_int_equal(
        pel_mesh_texture_of_image(&s.texture, &surface, NULL, &pel_rgb565_le),
        PEL_ERROR_NULL);
    assert_int_equal(
        pel_mesh_texture_of_image(&s.texture, &surface, &image, &pel_rgb565_le),
        PEL_ERROR_NULL);
}
