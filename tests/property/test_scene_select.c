/* Methods that are chosen against the exact ones: no channel of any pixel is
 * off by more than the tolerance, and bounds are not far above what happens. */
#include "core/scene/select.h"
#include "core/scene/select_light.h"
#include "tests/support/any_scene.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"

enum { SIDE = 96 };

static const int32_t tolerances[] = {0, 1, 2, 4, 8};

/* Are there enough cases to expect the worst ones among them? */
static bool is_whole_set(void)
{
    return cases_scaled(100) >= 100 && !cases_alone();
}

/* Normals of a triangle differ by about 1 / `of` of their length. */
static void bend_normals(struct random *r, struct any_scene *s, int32_t of)
{
    for (uint32_t i = 0; i < s->mesh.vertices; i++)
        for (int k = 0; k < 3; k++)
            s->normals[i][k] =
                (int16_t)(i % 3 ? s->normals[i - i % 3][k] +
                                      random_between(r, -14000, 14000) / of
                                : random_between(r, -14000, 14000));
}

/* Lights above white, and what only some scenes have. */
static void any_dress(struct random *r, struct any_scene *s)
{
    any_scene_light(r, s);
    bend_normals(r, s, 1 << random_between(r, 0, 6));
    if (random_word(r) % 2)
        s->lighting.ambient_color[1] = s->lighting.ambient_color[2] = 65536;
    if (random_word(r) % 2)
        for (int i = 0; i < ANY_LIGHTS; i++)
            for (int k = 0; k < 3; k++)
                s->light[i].color[k] = 65536;
    if (random_word(r) % 3 == 0) /* some that may be left out */
        for (int i = 0; i < ANY_LIGHTS; i++)
            for (int k = 0; k < 3; k++)
                s->light[i].color[k] >>= random_between(r, 0, 16);
    if (random_word(r) % 3 == 0)
        s->lighting.shininess =
            random_word(r) % 2 ? random_between(r, 1, 3) : 256;
    if (random_word(r) % 4 == 0)
        s->lighting.diffuse = s->lighting.specular =
            random_between(r, 0, PEL_FACTOR_END - 1);
    if (random_word(r) % 4 == 0) { /* close to the triangles */
        for (int k = 0; k < 3; k++)
            s->scene.camera.eye[k] +=
                (s->scene.camera.target[k] - s->scene.camera.eye[k]) / 4 * 3;
    }
    if (random_word(r) % 2) /* light that falls to 0 */
        s->lighting.ambient = 0;
    if (random_word(r) % 2)
        s->mesh.colors = NULL;
    s->scene.color = random_word(r);
    if (random_word(r) % 3 == 0)
        any_scene_noise(r, s, random_between(r, 2, 5));
    if (s->scene.texture && random_word(r) % 3 == 0)
        s->texture.mapping = &pel_map_vertices;
}

/* Every other soup in perspective. */
TEST(soups)
{
    static const struct pel_shading *const all[2][2] = {
        {&pel_shade_phong, &pel_shade_chosen},
        {&pel_perspective_phong, &pel_perspective_chosen}};
    static struct any_scene s;
    static struct canvas exact, chosen;
    struct pel_frame frame;
    int32_t worst[5] = {0}, lights = 0;
    for (struct cases c = cases_of(400); cases_next(&c);) {
        any_scene(&c.random, &s, SIDE);
        any_dress(&c.random, &s);
        const struct pel_shading *const *pair = all[random_word(&c.random) % 2];
        any_scene_draw(&s, pair[0], &frame, &exact);
        if (s.texture.mapping == &pel_map_perspective)
            s.texture.mapping = &pel_map_chosen;
        for (int i = 0; i < 5; i++) {
            s.scene.tolerance = tolerances[i] * 256;
            any_scene_draw(&s, pair[1], &frame, &chosen);
            lights += s.lighting.lights - frame.lights.count;
            const int32_t off = canvas_difference(&exact, &chosen);
            worst[i] = pel_max(worst[i], off);
            if (off > tolerances[i])
                fail_msg("off by %d with tolerance %d; %s", off, tolerances[i],
                         cases_replay());
        }
    }
    print_message("worst with tolerance 0, 1, 2, 4, 8: %d %d %d %d %d\n",
                  worst[0], worst[1], worst[2], worst[3], worst[4]);
    for (int i = 0; i < 5 && is_whole_set(); i++)
        assert_true(worst[i] * 2 >= tolerances[i]);
    assert_true(!is_whole_set() || lights > 0);
}

/* Places in a texture, which its colors tell: a step a texel. */
TEST(places_in_textures)
{
    static struct any_scene s;
    static struct canvas exact, chosen;
    static pel_color ramp[256 * 256];
    struct pel_frame frame;
    int32_t worst[5] = {0}, spans = 0;
    for (uint32_t i = 0; i < 256 * 256; i++)
        ramp[i] = UINT32_C(0xFF000000) | i;
    for (struct cases c = cases_of(400); cases_next(&c);) {
        any_scene(&c.random, &s, SIDE);
        any_scene_noise(&c.random, &s, 8);
        s.texture.texels.colors = ramp;
        s.texture.wrap_u = s.texture.wrap_v = PEL_WRAP_CLAMP;
        s.texture.mapping = &pel_map_perspective;
        any_scene_draw(&s, &pel_shade_gouraud, &frame, &exact);
        s.texture.mapping = &pel_map_chosen;
        for (int i = 1; i < 5; i++) {
            s.scene.texel_tolerance = tolerances[i] * 256;
            any_scene_draw(&s, &pel_shade_gouraud, &frame, &chosen);
            const int32_t off = canvas_difference(&exact, &chosen);
            worst[i] = pel_max(worst[i], off);
            spans += frame.work->perspective.by.span > 0;
            if (off > tolerances[i] + 1)
                fail_msg("%d texels off with tolerance %d; %s", off,
                         tolerances[i], cases_replay());
        }
    }
    print_message("worst with tolerance 1, 2, 4, 8: %d %d %d %d\n", worst[1],
                  worst[2], worst[3], worst[4]);
    assert_true(!is_whole_set() || (worst[4] >= 4 && spans > 0));
}

/* A triangle that fills the picture, lit by one light from the eye's side;
 * normals of length 1 around a middle one. */
static void patch(struct random *r, struct any_scene *s)
{
    static const int16_t corner[3][3] = {
        {-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
    any_scene(r, s, SIDE);
    any_scene_light(r, s);
    s->mesh.triangles = 1;
    s->mesh.vertices = 3;
    s->mesh.colors = NULL;
    s->scene.pose = NULL;
    s->scene.color = UINT32_MAX;
    s->mesh.position = (struct pel_quantization){{0, 0, 0}, 1, 15};
    s->scene.camera = (struct pel_camera){.eye = {0, 0, PEL_UNITS(100)},
                                          .up = {0, 1, 0},
                                          .near_plane = PEL_UNITS(1),
                                          .focal = 1000,
                                          .sensor = {20, 20}};
    s->scene.viewport = (struct pel_rect){0, 0, SIDE, SIDE};
    s->light[0] = (struct pel_light){.at = {0, 0, 1}, .directional = true};
    for (int k = 0; k < 3; k++)
        s->light[0].color[k] = 65536;
    s->lighting.lights = 1;
    s->lighting.ambient = 0;
    s->lighting.plain_highlights = s->lighting.no_back_highlights = false;
    const int32_t bend = random_between(r, 400, 4000);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            s->positions[i][k] = corner[i][k];
            s->normals[i][k] =
                (int16_t)(k == 2 ? 20000
                                 : corner[i][k] / 32767 * bend +
                                       random_between(r, -bend, bend) / 4);
        }
}

/* The bounds of the scene's one triangle. */
static struct pel_light_bounds bounds_of(const struct any_scene *s,
                                         struct pel_frame *frame)
{
    const pel_color own[3] = {s->scene.color, s->scene.color, s->scene.color};
    struct pel_light_bounds bounds;
    uint8_t note[3];
    for (int i = 0; i < 3; i++)
        note[i] = (uint8_t)(frame->vertex[i].color >> 24);
    assert_true(pel_light_bound(frame, note, own, &bounds));
    return bounds;
}

/* What the bound of Gouraud leaves unused, of highlights alone and of diffuse
 * light alone. */
TEST(bounds_are_tight)
{
    static struct any_scene s;
    static struct canvas exact, chosen;
    struct pel_frame frame;
    double tight[2] = {0, 0};
    for (struct cases c = cases_of(200); cases_next(&c);) {
        patch(&c.random, &s);
        const int kind = (int)(random_word(&c.random) % 2);
        s.lighting.diffuse = kind ? 60000 : 0;
        s.lighting.specular = kind ? 0 : 60000;
        s.lighting.shininess = kind ? 1 : 20;
        s.scene.tolerance = 255 * 256;
        any_scene_draw(&s, &pel_shade_chosen, &frame, &chosen);
        const struct pel_light_bounds b = bounds_of(&s, &frame);
        if (b.plane < 4 * 256 || b.plane > 100 * 256)
            continue;
        s.scene.tolerance = (int32_t)b.plane + 132; /* and not flat */
        any_scene_draw(&s, &pel_shade_phong, &frame, &exact);
        any_scene_draw(&s, &pel_shade_chosen, &frame, &chosen);
        const double part =
            256. * canvas_difference(&exact, &chosen) / (double)b.plane;
        tight[kind] = part > tight[kind] ? part : tight[kind];
    }
    print_message("worst error by bound: highlights %.2f, diffuse %.2f\n",
                  tight[0], tight[1]);
    assert_true(!is_whole_set() || (tight[0] > 0.5 && tight[1] > 0.5));
}
