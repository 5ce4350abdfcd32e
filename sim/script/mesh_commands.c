/* Cameras, lights and meshes. All but `mesh` itself is done while the script is
 * read, so that a mesh can be refused there. */
#include "sim/script/parser.h"

static void set_numbers(double *to, const int32_t *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        to[i] = v[i] / 65536.0;
}

/* The camera finds its own place again. */
static void set_frame(struct script_pen *pen, const int32_t *v)
{
    struct camera *camera = &pen->scene->settings.camera;
    (void)v;
    camera->has_eye = camera->has_target = camera->has_near = false;
}

static void set_viewport(struct script_pen *pen, const int32_t *v)
{
    struct scene_settings *s = &pen->scene->settings;
    s->left = v[0];
    s->top = v[1];
    s->camera.width = v[2];
    s->camera.height = v[3];
}

static const char *check_viewport(const int32_t *v, size_t n)
{
    (void)n;
    if (v[0] < -32767 || v[1] < -32767 || v[0] + v[2] > 32767 ||
        v[1] + v[3] > 32767)
        return "expected all of it within -32767..32767 pixels";
    return NULL;
}

static void add_light(struct script_pen *pen, const int32_t *v,
                      bool directional)
{
    struct scene_settings *s = &pen->scene->settings;
    struct scene_light *light = &s->light[s->lights];
    pen->failed = s->lights == SCENE_LIGHTS_MAX;
    if (pen->failed)
        return;
    s->has_light = true;
    s->lights++;
    light->directional = directional;
    set_numbers(light->at, v, 3);
    set_numbers(light->color, v + 3, 3);
}

static void add_point(struct script_pen *pen, const int32_t *v)
{
    add_light(pen, v, false);
}

static void add_sun(struct script_pen *pen, const int32_t *v)
{
    add_light(pen, v, true);
}

static const char *check_sun(const int32_t *v, size_t n)
{
    (void)n;
    return v[0] || v[1] || v[2]
               ? NULL
               : "expected the direction towards it, X Y Z, not 0 0 0";
}

/* All as at the start, but for the material. */
static void set_no_lights(struct script_pen *pen, const int32_t *v)
{
    (void)v;
    pen->scene->settings.lights = 0;
    pen->scene->settings.has_light = false;
}

static void set_material(struct script_pen *pen, const int32_t *v)
{
    struct scene_settings *s = &pen->scene->settings;
    s->has_light = true;
    set_numbers(&s->ambient, v, 1);
    set_numbers(&s->diffuse, v + 1, 1);
    set_numbers(&s->specular, v + 2, 1);
    s->shininess = v[3];
}

static void set_terms(struct script_pen *pen, const int32_t *v)
{
    pen->scene->settings.terms = v[0] ? 1u << (v[0] - 1) : SCENE_ALL_TERMS;
}

static void set_own_texture(struct script_pen *pen, const int32_t *v)
{
    (void)v;
    pen->scene->texture = -1;
}

static void set_color(struct script_pen *pen, const int32_t *v)
{
    struct scene_settings *s = &pen->scene->settings;
    s->has_color = true;
    s->color = (pel_color)v[0];
    s->transparency = (int)(255 - pel_alpha(s->color));
}

static void set_tolerance(struct script_pen *pen, const int32_t *v)
{
    pen->scene->settings.tolerance = v[0];
}

static void set_own_colors(struct script_pen *pen, const int32_t *v)
{
    (void)v;
    pen->scene->settings.has_color = false;
    pen->scene->settings.transparency = 0;
}

static void draw_mesh(struct script_pen *pen, const int32_t *v)
{
    if (!scene_draw(&pen->script->assets[v[0]].mesh->scene, pen->surface))
        pen->failed = true;
}

#define SETTING(name, kinds, usage, member)                                \
    {                                                                      \
        name, kinds, usage, SCRIPT_SCENE,                                  \
            SCRIPT_SETTING(struct script_scene, member, sizeof(kinds) - 1) \
    }
#define FLAGGED(name, kinds, usage, member, flag_)                          \
    {                                                                       \
        name, kinds, usage, SCRIPT_SCENE,                                   \
            SCRIPT_SETTING(struct script_scene, member, sizeof(kinds) - 1), \
            .flag = offsetof(struct script_scene, flag_)                    \
    }
#define ACTION(name, kinds, usage, set)               \
    {                                                 \
        name, kinds, usage, SCRIPT_SCENE, .draw = set \
    }

const struct script_command script_mesh_commands[] = {
    FLAGGED("camera eye", "xxx", "X Y Z", settings.camera.eye,
            settings.camera.has_eye),
    FLAGGED("camera target", "xxx", "X Y Z", settings.camera.target,
            settings.camera.has_target),
    SETTING("camera up", "xxx", "X Y Z", settings.camera.up),
    ACTION("camera frame", "", "", set_frame),
    SETTING("camera projection", "o", CAMERA_PROJECTIONS,
            settings.camera.projection),
    SETTING("camera focal", "m", "MM", settings.camera.focal),
    FLAGGED("camera sensor", "mm", "WIDTH HEIGHT", settings.camera.sensor,
            settings.camera.has_sensor),
    FLAGGED("camera near", "m", "DISTANCE", settings.camera.near_plane,
            settings.camera.has_near),
    {"camera viewport", "iiss", "X Y WIDTH HEIGHT", SCRIPT_SCENE,
     .draw = set_viewport, .check = check_viewport},
    ACTION("light point", "xxxkkk", "X Y Z R G B", add_point),
    {"light sun", "xxxkkk", "X Y Z R G B", SCRIPT_SCENE, .draw = add_sun,
     .check = check_sun},
    ACTION("light none", "", "", set_no_lights),
    FLAGGED("ambient", "kkk", "R G B", settings.ambient_color,
            settings.has_light),
    ACTION("material", "kkke", "KA KD KS SHININESS", set_material),
    SETTING("shade", "o", SCENE_SHADES, settings.shade),
    ACTION("option mesh tolerance", "b", "0..255", set_tolerance),
    SETTING("option mesh texel_tolerance", "u", "TEXELS",
            settings.texel_tolerance),
    SETTING("option mesh light", "o", "auto|on|off", settings.lit),
    ACTION("option mesh terms", "o", "all|ambient|diffuse|specular", set_terms),
    SETTING("option mesh highlights", "o", SCENE_HIGHLIGHTS,
            settings.plain_highlights),
    SETTING("option mesh backhighlights", "o", "on|off",
            settings.no_back_highlights),
    SETTING("option mesh sides", "o", SCENE_SIDES, settings.both_sides),
    SETTING("option mesh texture", "o", SCENE_TEXTURES, settings.texture),
    SETTING("option mesh mapping", "o", SCENE_MAPPINGS, settings.mapping),
    SETTING("option mesh span", "o", SCENE_SPANS, settings.span),
    SETTING("option mesh wrap", "o", SCENE_WRAPS, settings.wrap),
    SETTING("option mesh normals", "o", SCENE_NORMALS, smooth_normals),
    FLAGGED("option mesh crease", "m", "DEGREES", crease, has_crease),
    SETTING("option mesh order", "o", SCENE_ORDERS, settings.order),
    SETTING("option mesh cull", "o", SCENE_CULLS, settings.cull),
    ACTION("option mesh color own", "", "", set_own_colors),
    ACTION("option mesh color", "c", "COLOUR", set_color),
    SETTING("option mesh transparency", "b", "0..255", settings.transparency),
    SETTING("option mesh turn", "ttt", "X Y Z", settings.turn),
    ACTION("texture own", "", "", set_own_texture),
    SETTING("texture", "Q", "FILE", texture),
    {"mesh", "M", "FILE", SCRIPT_PICTURE, .draw = draw_mesh},
    {.name = NULL},
};
