/* The demo `lighting`: a mesh with a texture and three lights, Gouraud and
 * Phong, term by term and light by light. */
#include "sim/demo/mesh.h"

enum { SIZE = 480, LIGHTS = 3 };

/* What a picture shows. */
struct lighting_case {
    enum scene_shade shade;
    unsigned terms;
    int light; /* the only one, or -1: all */
    bool unlit, untextured;
};

enum { ALL = SCENE_ALL_TERMS };

static const struct lighting_case cases[] = {
    {SCENE_GOURAUD, ALL, -1, false, false},
    {SCENE_GOURAUD, SCENE_AMBIENT, -1, false, false},
    {SCENE_GOURAUD, SCENE_DIFFUSE, -1, false, false},
    {SCENE_GOURAUD, SCENE_SPECULAR, -1, false, false},
    {SCENE_GOURAUD, ALL, 0, false, false},
    {SCENE_GOURAUD, ALL, 1, false, false},
    {SCENE_GOURAUD, ALL, 2, false, false},
    {SCENE_PHONG, ALL, -1, false, false},
    {SCENE_PHONG, SCENE_AMBIENT, -1, false, false},
    {SCENE_PHONG, SCENE_DIFFUSE, -1, false, false},
    {SCENE_PHONG, SCENE_SPECULAR, -1, false, false},
    {SCENE_PHONG, ALL, 0, false, false},
    {SCENE_PHONG, ALL, 1, false, false},
    {SCENE_PHONG, ALL, 2, false, false},
    {SCENE_GOURAUD, ALL, -1, true, false},
    {SCENE_PHONG, ALL, -1, true, false},
    {SCENE_GOURAUD, ALL, -1, false, true},
    {SCENE_PHONG, ALL, -1, false, true},
};

/* Three lights around the mesh, its size away from its middle: warm from the
 * right and above, blue from the left, red from behind and above. */
static void set_lights(struct scene_settings *s, const struct model *model,
                       int only)
{
    static const struct scene_light around[LIGHTS] = {
        {{1.2, 1.2, 1.6}, {1, 0.95, 0.8}, false},
        {{-2, 0.4, 0.8}, {0.25, 0.45, 1}, false},
        {{0.3, 1.5, -1.8}, {1, 0.35, 0.25}, false}};
    double size = 0;
    for (int k = 0; k < 3; k++)
        if (model->high[k] - model->low[k] > size)
            size = model->high[k] - model->low[k];
    for (int i = 0; i < LIGHTS; i++) {
        if (only >= 0 && only != i)
            continue;
        struct scene_light *light = &s->light[s->lights++];
        *light = around[i];
        for (int k = 0; k < 3; k++)
            light->at[k] =
                (model->low[k] + model->high[k]) / 2 + size * around[i].at[k];
    }
}

static struct scene_settings settings_of(const struct lighting_case *c,
                                         const struct model *model)
{
    struct scene_settings s = scene_default;
    s.camera.width = s.camera.height = SIZE;
    s.camera.background = PEL_RGB(24, 26, 32);
    s.shade = c->unlit ? SCENE_GOURAUD : c->shade;
    s.lit = c->unlit ? SCENE_UNLIT : SCENE_LIT;
    s.ambient = 0.2;
    s.specular = 0.5;
    s.shininess = 24;
    s.terms = c->terms;
    s.texture = c->untextured ? SCENE_TEXTURE_NONE : SCENE_TEXTURE_BILINEAR;
    s.mapping =
        c->shade == SCENE_PHONG ? SCENE_MAP_PERSPECTIVE : SCENE_MAP_VERTICES;
    set_lights(&s, model, c->light);
    return s;
}

static bool draw(struct demo_result *result, int which)
{
    struct model model;
    if (!demo_mesh_model(&model, result))
        return false;
    const struct scene_settings settings = settings_of(&cases[which], &model);
    const bool done = demo_mesh_draw(&model, &settings, result);
    model_free(&model);
    return done;
}

#define GOURAUD "Light and texture at the vertices, the colours interpolated"
#define PHONG "Light and texture at every pixel, the normal interpolated"

const struct demo demo_lighting[] = {
    {"lighting-gouraud", GOURAUD ": three lights, all terms.", draw, 0},
    {"lighting-gouraud-ambient", GOURAUD ": the ambient term.", draw, 1},
    {"lighting-gouraud-diffuse", GOURAUD ": the diffuse term.", draw, 2},
    {"lighting-gouraud-specular", GOURAUD ": the specular term.", draw, 3},
    {"lighting-gouraud-light1", GOURAUD ": light 1 alone.", draw, 4},
    {"lighting-gouraud-light2", GOURAUD ": light 2 alone.", draw, 5},
    {"lighting-gouraud-light3", GOURAUD ": light 3 alone.", draw, 6},
    {"lighting-phong", PHONG ": three lights, all terms.", draw, 7},
    {"lighting-phong-ambient", PHONG ": the ambient term.", draw, 8},
    {"lighting-phong-diffuse", PHONG ": the diffuse term.", draw, 9},
    {"lighting-phong-specular", PHONG ": the specular term.", draw, 10},
    {"lighting-phong-light1", PHONG ": light 1 alone.", draw, 11},
    {"lighting-phong-light2", PHONG ": light 2 alone.", draw, 12},
    {"lighting-phong-light3", PHONG ": light 3 alone.", draw, 13},
    {"lighting-texture-vertices", "The texture alone, at the vertices.", draw,
     14},
    {"lighting-texture-pixels", "The texture alone, at every pixel.", draw, 15},
    {"lighting-gouraud-plain", "Gouraud without the texture.", draw, 16},
    {"lighting-phong-plain", "Phong without the texture.", draw, 17},
    {NULL, NULL, NULL, 0},
};
