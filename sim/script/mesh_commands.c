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
    pen->failed = s->lights == SCENE_LIGHTS_MAX;
    if (pen->failed)
        return;
    struct scene_light *light = &s->light[s->lights++];
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

#define SET(member, values) \
    SCRIPT_SCENE, SCRIPT_SETTING(struct script_scene, member, values)
#define FLAG(member) .flag = offsetof(struct script_scene, member)
#define DO(set) SCRIPT_SCENE, .draw = set

const struct script_command script_mesh_commands[] = {
    {"camera eye", "xxx", "X Y Z", SET(settings.camera.eye, 3),
     FLAG(settings.camera.has_eye)},
    {"camera target", "xxx", "X Y Z", SET(settings.camera.target, 3),
     FLAG(settings.camera.has_target)},
    {"camera up", "xxx", "X Y Z", SET(settings.camera.up, 3)},
    {"camera frame", "", "", DO(set_frame)},
    {"camera projection", "o", CAMERA_PROJECTIONS,
     SET(settings.camera.projection, 1)},
    {"camera focal", "m", "MM", SET(settings.camera.focal, 1)},
    {"camera sensor", "mm", "WIDTH HEIGHT", SET(settings.camera.sensor, 2),
     FLAG(settings.camera.has_sensor)},
    {"camera near", "m", "DISTANCE", SET(settings.camera.near_plane, 1),
     FLAG(settings.camera.has_near)},
    {"camera viewport", "iiss", "X Y WIDTH HEIGHT", DO(set_viewport),
     .check = check_viewport},
    {"light point", "xxxkkk", "X Y Z R G B", DO(add_point),
     FLAG(settings.has_light)},
    {"light sun", "xxxkkk", "X Y Z R G B", DO(add_sun),
     FLAG(settings.has_light), .check = check_sun},
    {"light none", "", "", DO(set_no_lights)},
    {"ambient", "kkk", "R G B", SET(settings.ambient_color, 3),
     FLAG(settings.has_light)},
    {"material", "kkke", "KA KD KS SHININESS", DO(set_material),
     FLAG(settings.has_light)},
    {"shade", "o", SCENE_SHADES, SET(settings.shade, 1)},
    {"option mesh tolerance", "b", "0..255", DO(set_tolerance)},
    {"option mesh texel_tolerance", "u", "TEXELS",
     SET(settings.texel_tolerance, 1)},
    {"option mesh light", "o", "auto|on|off", SET(settings.lit, 1)},
    {"option mesh terms", "o", "all|ambient|diffuse|specular", DO(set_terms)},
    {"option mesh highlights", "o", SCENE_HIGHLIGHTS,
     SET(settings.plain_highlights, 1)},
    {"option mesh backhighlights", "o", "on|off",
     SET(settings.no_back_highlights, 1)},
    {"option mesh sides", "o", SCENE_SIDES, SET(settings.both_sides, 1)},
    {"option mesh interpolation", "o", SCENE_INTERPOLATIONS,
     SET(settings.in_world, 1)},
    {"option mesh texture", "o", SCENE_TEXTURES, SET(settings.texture, 1)},
    {"option mesh mapping", "o", SCENE_MAPPINGS, SET(settings.mapping, 1)},
    {"option mesh span", "o", SCENE_SPANS, SET(settings.span, 1)},
    {"option mesh wrap", "o", SCENE_WRAPS, SET(settings.wrap, 1)},
    {"option mesh normals", "o", SCENE_NORMALS, SET(smooth_normals, 1)},
    {"option mesh crease", "m", "DEGREES", SET(crease, 1), FLAG(has_crease)},
    {"option mesh order", "o", SCENE_ORDERS, SET(settings.order, 1)},
    {"option mesh cull", "o", SCENE_CULLS, SET(settings.cull, 1)},
    {"option mesh color own", "", "", DO(set_own_colors)},
    {"option mesh color", "c", "COLOUR", DO(set_color),
     FLAG(settings.has_color)},
    {"option mesh transparency", "b", "0..255", SET(settings.transparency, 1)},
    {"option mesh turn", "ttt", "X Y Z", SET(settings.turn, 3)},
    {"texture own", "", "", DO(set_own_texture)},
    {"texture", "Q", "FILE", SET(texture, 1)},
    {"mesh", "M", "FILE", SCRIPT_PICTURE, .draw = draw_mesh},
    {.name = NULL},
};
