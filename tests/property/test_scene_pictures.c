/* Whole pictures against a renderer in extended precision: who is seen in every
 * pixel, and in which color. */
#include "core/scene/select.h"
#include "tests/support/any_scene.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/reference.h"
#include "tests/support/reference_scene.h"

enum { SIDE = 96 };

struct seen {
    real place[3], normal[3], screen[3];
    real color[3]; /* the surface's, or lit, red first */
    real uv[2];
    struct pel_point at;
    bool moved; /* core has it at a neighbour */
};

struct picture {
    struct any_scene s;
    struct pel_frame frame;
    struct seen vertex[ANY_VERTICES];
    uint32_t order[ANY_TRIANGLES]; /* from the farthest on */
    struct canvas numbers, colors;
    bool lit, phong;
};

static uint64_t covered, differ;
static int32_t worst;

static void see_vertex(struct picture *p, uint32_t i)
{
    const struct pel_scene *scene = &p->s.scene;
    struct seen *v = &p->vertex[i];
    const struct pel_projected *core = &p->frame.vertex[i].at;
    reference_place(scene, i, v->place);
    reference_project(scene, v->place, v->screen);
    v->at = reference_snap(v->screen);
    v->moved = core->x != v->at.x || core->y != v->at.y;
    for (int k = 0; k < 3; k++)
        v->color[k] = scene->texture ? 255 : p->s.colors[i][k];
    if (scene->texture)
        reference_uv(scene, i, v->uv);
    if (p->lit || p->phong)
        reference_normal(scene, i, v->normal);
    if (p->lit) {
        const real own[3] = {v->color[0], v->color[1], v->color[2]};
        reference_light(scene, v->place, v->normal, own, v->color);
    }
}

static real depth_of(const struct picture *p, uint32_t t)
{
    const struct seen *v = &p->vertex[3 * t];
    return v[0].screen[2] + v[1].screen[2] + v[2].screen[2];
}

static void see(struct picture *p)
{
    uint32_t n = p->s.mesh.triangles;
    for (uint32_t i = 0; i < 3 * n; i++)
        see_vertex(p, i);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t at = i;
        for (; at > 0 && depth_of(p, p->order[at - 1]) < depth_of(p, i); at--)
            p->order[at] = p->order[at - 1];
        p->order[at] = i;
    }
}

/* The triangle that is seen, from 1; 0: none. */
static uint32_t number_at(const struct picture *p, int32_t x, int32_t y)
{
    for (uint32_t i = p->s.mesh.triangles; i-- > 0;) {
        const struct seen *v = &p->vertex[3 * p->order[i]];
        const struct pel_point at[3] = {v[0].at, v[1].at, v[2].at};
        if (reference_triangle_at(at, x, y))
            return p->order[i] + 1;
    }
    return 0;
}

/* The sum of v[i] w[i], of n numbers each. */
static void mix(const real w[3], const real *const v[3], int n, real *out)
{
    for (int k = 0; k < n; k++)
        out[k] = w[0] * v[0][k] + w[1] * v[1][k] + w[2] * v[2][k];
}

/* Weights that are linear in the world, from those on screen. */
static void set_world(const struct picture *p, const struct seen *v,
                      const real weight[3], real w[3])
{
    real sum = 0;
    for (int i = 0; i < 3; i++) {
        w[i] = weight[i];
        if (p->s.scene.camera.projection != PEL_ORTHOGRAPHIC)
            w[i] /= v[i].screen[2];
        sum += w[i];
    }
    for (int i = 0; i < 3; i++)
        w[i] /= sum;
}

static void facet_normal(const struct seen v[3], real normal[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        normal[k] =
            (v[1].place[i] - v[0].place[i]) * (v[2].place[j] - v[0].place[j]) -
            (v[1].place[j] - v[0].place[j]) * (v[2].place[i] - v[0].place[i]);
    }
}

static void color_at(const struct picture *p, uint32_t triangle,
                     const real screen[3], real out[3])
{
    const struct pel_scene *scene = &p->s.scene;
    const struct seen *v = &p->vertex[3 * triangle];
    const bool facet = scene->shading == &pel_shade_lit_flat;
    const bool flat = facet || scene->shading == &pel_shade_flat;
    const real third[3] = {1.0L / 3, 1.0L / 3, 1.0L / 3};
    const bool divided = scene->shading == &pel_perspective_gouraud ||
                         scene->shading == &pel_perspective_lit_gouraud ||
                         scene->shading == &pel_perspective_phong;
    const bool affine = p->s.texture.mapping == &pel_map_affine;
    real surface[3], uv[2], place[3], normal[3], world[3];
    const real *const w = divided ? world : screen;
    const real *const uvs[3] = {v[0].uv, v[1].uv, v[2].uv};
    const real *const colors[3] = {v[0].color, v[1].color, v[2].color};
    const real *const places[3] = {v[0].place, v[1].place, v[2].place};
    const real *const normals[3] = {v[0].normal, v[1].normal, v[2].normal};
    set_world(p, v, screen, world);
    mix(flat ? third : w, colors, 3, out);
    if (facet) {
        const real own[3] = {out[0], out[1], out[2]};
        mix(third, places, 3, place);
        facet_normal(v, normal);
        reference_light(scene, place, normal, own, out);
    }
    if (scene->texture) {
        mix(affine ? screen : world, uvs, 2, uv);
        reference_texel(scene->texture, uv[0], uv[1], true, surface);
        for (int k = 0; k < 3; k++)
            out[k] *= surface[k] / 255;
    }
    if (p->phong) {
        mix(w, places, 3, place);
        mix(w, normals, 3, normal);
        for (int k = 0; k < 3; k++)
            surface[k] = out[k];
        reference_light(scene, place, normal, surface, out);
    }
}

static void check_color(const struct picture *p, uint32_t triangle, int32_t x,
                        int32_t y, int32_t tolerance)
{
    const struct seen *v = &p->vertex[3 * triangle];
    const struct pel_point at[3] = {v[0].at, v[1].at, v[2].at};
    const uint32_t got = canvas_pixel(&p->colors, x, y);
    real w[3], want[3];
    reference_weights(at, x, y, w);
    color_at(p, triangle, w, want);
    for (int k = 0; k < 3; k++) {
        const int32_t channel = (int32_t)(got >> (16 - 8 * k) & 255);
        int32_t off = channel - (int32_t)(want[k] + 0.5L);
        off = off < 0 ? -off : off;
        worst = off > worst ? off : worst;
        if (off > tolerance)
            fail_msg("pixel %d, %d of triangle %u: channel %d is %d, not "
                     "%.3f; %s",
                     x, y, triangle, k, channel, (double)want[k],
                     cases_replay());
    }
}

static void check_pixels(const struct picture *p, int32_t tolerance)
{
    const struct pel_rect *b = &p->s.scene.viewport;
    for (int32_t y = b->y0; y < b->y1; y++)
        for (int32_t x = b->x0; x < b->x1; x++) {
            const uint32_t want = number_at(p, x, y);
            const uint32_t got = canvas_pixel(&p->numbers, x, y) & 0xFFFFFFu;
            const struct seen *v = &p->vertex[3 * (want ? want - 1 : 0)];
            covered += want || got;
            if (got != want || v[0].moved || v[1].moved || v[2].moved)
                differ += want || got;
            else if (want)
                check_color(p, want - 1, x, y, tolerance);
        }
}

static void draw(struct picture *p, struct canvas *canvas)
{
    const struct pel_flat black = PEL_FLAT(UINT32_C(0xFF000000));
    canvas_open(canvas, &pel_xrgb8888, &p->s.scene.viewport, 0);
    const struct pel_rect *b = &p->s.scene.viewport;
    pel_rectangle(&canvas->surface, (struct pel_point)PEL_AT(b->x0, b->y0),
                  (struct pel_point)PEL_AT(b->x1, b->y1), &black.paint);
    any_scene_prepare(&p->s, &p->frame);
    pel_scene_draw(&p->frame, &canvas->surface);
    canvas_check(canvas);
}

/* What a test adds to a random scene. */
typedef void dressing(struct random *r, struct picture *p);

static void check_pictures(uint64_t count, dressing *dress, int32_t tolerance)
{
    static struct picture p;
    covered = differ = 0;
    worst = 0;
    for (struct cases c = cases_of(count); cases_next(&c);) {
        any_scene(&c.random, &p.s, SIDE);
        dress(&c.random, &p);
        p.lit = p.s.scene.shading == &pel_shade_lit_gouraud ||
                p.s.scene.shading == &pel_perspective_lit_gouraud;
        p.phong = p.s.scene.shading == &pel_shade_phong ||
                  p.s.scene.shading == &pel_perspective_phong ||
                  p.s.scene.shading == &pel_shade_chosen;
        draw(&p, &p.colors);
        const struct pel_shading *shading = p.s.scene.shading;
        p.s.scene.shading = &any_scene_numbers;
        draw(&p, &p.numbers);
        p.s.scene.shading = shading;
        see(&p);
        check_pixels(&p, tolerance);
    }
    print_message("%llu pixels covered, %llu with another triangle or a vertex "
                  "that was rounded differently; all others within %d\n",
                  (unsigned long long)covered, (unsigned long long)differ,
                  (int)worst);
    assert_true(differ * 1000 <= covered);
}

static void dress_vertices(struct random *r, struct picture *p)
{
    static const struct pel_shading *const shading[] = {
        &pel_shade_flat, &pel_shade_gouraud, &pel_shade_lit_flat,
        &pel_shade_lit_gouraud};
    any_scene_light(r, &p->s);
    p->s.scene.shading = shading[random_word(r) % 4];
}

static void dress_phong(struct random *r, struct picture *p)
{
    any_scene_light(r, &p->s);
    p->s.lighting.both_sides = false; /* no sign is known where it changes */
    if (random_word(r) % 4 == 0)
        p->s.lighting.shininess = 256;
    p->s.scene.shading = &pel_shade_phong;
}

static void dress_chosen(struct random *r, struct picture *p)
{
    dress_phong(r, p);
    p->s.scene.shading = &pel_shade_chosen;
    p->s.scene.tolerance = 4 * 256;
}

static void dress_texture(struct random *r, struct picture *p)
{
    static const struct pel_shading *const shading[] = {
        &pel_shade_flat, &pel_shade_lit_flat, &pel_shade_lit_gouraud,
        &pel_shade_phong};
    any_scene_light(r, &p->s);
    any_scene_noise(r, &p->s, random_between(r, 2, 5));
    p->s.lighting.both_sides = false;
    p->s.scene.shading = shading[random_word(r) % 4];
    if (random_word(r) % 3 == 0)
        p->s.texture.mapping = &pel_map_affine;
}

static void dress_perspective(struct random *r, struct picture *p)
{
    static const struct pel_shading *const shading[] = {
        &pel_perspective_gouraud, &pel_perspective_lit_gouraud,
        &pel_perspective_phong};
    dress_texture(r, p);
    if (random_word(r) % 2)
        p->s.scene.texture = NULL;
    p->s.scene.shading = shading[random_word(r) % 3];
}

TEST(colors_of_vertices)
{
    check_pictures(1500, dress_vertices, 1);
}

TEST(phong)
{
    check_pictures(700, dress_phong, 2);
}

TEST(chosen)
{
    check_pictures(700, dress_chosen, 2 + 4);
}

TEST(textures)
{
    check_pictures(1000, dress_texture, 2);
}

TEST(perspective)
{
    check_pictures(1000, dress_perspective, 2);
}
