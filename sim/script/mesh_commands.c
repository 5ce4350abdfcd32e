/* Cameras, lights and meshes. All but `mesh` itself is done while the script is
 * read, so that a mesh can be refused there. */
#include "sim/script/assets.h"
#include "sim/script/meshes.h"

static struct scene_settings *settings(const struct script_pen *pen)
{
    return &pen->scene->settings;
}

static void set_numbers(double *to, const int32_t *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        to[i] = v[i] / 65536.0;
}

static void set_eye(struct script_pen *pen, const int32_t *v, size_t n)
{
    settings(pen)->camera.has_eye = true;
    set_numbers(settings(pen)->camera.eye, v, n);
}

static void set_target(struct script_pen *pen, const int32_t *v, size_t n)
{
    settings(pen)->camera.has_target = true;
    set_numbers(settings(pen)->camera.target, v, n);
}

static void set_up(struct script_pen *pen, const int32_t *v, size_t n)
{
    set_numbers(settings(pen)->camera.up, v, n);
}

/* The camera finds its own place again. */
static void set_frame(struct script_pen *pen, const int32_t *v, size_t n)
{
    struct camera *camera = &settings(pen)->camera;
    (void)v;
    (void)n;
    camera->has_eye = camera->has_target = camera->has_near = false;
}

static void set_projection(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->camera.projection =
        v[0] ? PEL_ORTHOGRAPHIC : PEL_PERSPECTIVE;
}

static void set_focal(struct script_pen *pen, const int32_t *v, size_t n)
{
    set_numbers(&settings(pen)->camera.focal, v, n);
}

static void set_sensor(struct script_pen *pen, const int32_t *v, size_t n)
{
    settings(pen)->camera.has_sensor = true;
    set_numbers(settings(pen)->camera.sensor, v, n);
}

static void set_near(struct script_pen *pen, const int32_t *v, size_t n)
{
    settings(pen)->camera.has_near = true;
    set_numbers(&settings(pen)->camera.near, v, n);
}

static void set_viewport(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->left = v[0];
    settings(pen)->top = v[1];
    settings(pen)->camera.width = v[2];
    settings(pen)->camera.height = v[3];
}

static const char *check_viewport(const int32_t *v, size_t n)
{
    (void)n;
    if (v[0] < -32767 || v[1] < -32767 || v[0] + v[2] > 32767 ||
        v[1] + v[3] > 32767)
        return "all of it must lie within -32767..32767 pixels";
    return NULL;
}

static void add_light(struct script_pen *pen, const int32_t *v,
                      bool directional)
{
    struct scene_settings *s = settings(pen);
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

static void add_point(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    add_light(pen, v, false);
}

static void add_sun(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    add_light(pen, v, true);
}

static const char *check_sun(const int32_t *v, size_t n)
{
    (void)n;
    return v[0] || v[1] || v[2] ? NULL
                                : "X Y Z is the way towards it, not 0 0 0";
}

/* As at first, but for the material. */
static void set_no_lights(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    settings(pen)->lights = 0;
    settings(pen)->has_light = false;
}

static void set_ambient(struct script_pen *pen, const int32_t *v, size_t n)
{
    settings(pen)->has_light = true;
    set_numbers(settings(pen)->ambient_color, v, n);
}

static void set_material(struct script_pen *pen, const int32_t *v, size_t n)
{
    struct scene_settings *s = settings(pen);
    (void)n;
    s->has_light = true;
    set_numbers(&s->ambient, v, 1);
    set_numbers(&s->diffuse, v + 1, 1);
    set_numbers(&s->specular, v + 2, 1);
    s->shininess = v[3];
}

static void set_terms(struct script_pen *pen, const int32_t *v, size_t n)
{
    static const unsigned terms[] = {SCENE_ALL_TERMS, SCENE_AMBIENT,
                                     SCENE_DIFFUSE, SCENE_SPECULAR};
    (void)n;
    settings(pen)->terms = terms[v[0]];
}

static void set_highlights(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->plain_highlights = v[0] == 1;
}

static void set_back_highlights(struct script_pen *pen, const int32_t *v,
                                size_t n)
{
    (void)n;
    settings(pen)->no_back_highlights = v[0] == 1;
}

static void set_lit(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->lit = (enum scene_lit)v[0];
}

static void set_shade(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->shade = (enum scene_shade)v[0];
}

static void set_texture(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->texture = (enum scene_texture)v[0];
}

static void set_texture_file(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pen->scene->texture = v[0];
}

static void set_own_texture(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->scene->texture = -1;
}

static void set_mapping(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->mapping = (enum scene_mapping)v[0];
}

static void set_span(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->span = 2 << v[0];
}

static void set_wrap(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->wrap = (enum pel_wrap)v[0];
}

static void set_normals(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pen->scene->smooth_normals = v[0] == 1;
}

static void set_order(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->order = (enum scene_order)v[0];
}

static void set_cull(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->cull = (enum pel_cull)v[0];
}

static void set_color(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->has_color = true;
    settings(pen)->color = (pel_color)v[0];
    settings(pen)->transparency = (uint8_t)(255 - pel_alpha((pel_color)v[0]));
}

static void set_own_colors(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    settings(pen)->has_color = false;
    settings(pen)->transparency = 0;
}

static void set_transparency(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    settings(pen)->transparency = (uint8_t)v[0];
}

static void set_turn(struct script_pen *pen, const int32_t *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        settings(pen)->turn[i] = (uint16_t)v[i];
}

static void draw_mesh(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    if (!scene_draw(&pen->assets->meshes[v[0]]->scene, pen->surface))
        pen->failed = true;
}

#define STATE(name, kinds, usage, set)              \
    {                                               \
        name, kinds, usage, SCRIPT_SCENE, set, NULL \
    }

const struct script_command script_mesh_commands[] = {
    STATE("camera eye", "xxx", "X Y Z", set_eye),
    STATE("camera target", "xxx", "X Y Z", set_target),
    STATE("camera up", "xxx", "X Y Z", set_up),
    STATE("camera frame", "", "", set_frame),
    STATE("camera projection", "o", "perspective|orthographic", set_projection),
    STATE("camera focal", "m", "MM", set_focal),
    STATE("camera sensor", "mm", "WIDTH HEIGHT", set_sensor),
    STATE("camera near", "m", "DISTANCE", set_near),
    {"camera viewport", "iiss", "X Y WIDTH HEIGHT", SCRIPT_SCENE, set_viewport,
     check_viewport},
    STATE("light point", "xxxkkk", "X Y Z R G B", add_point),
    {"light sun", "xxxkkk", "X Y Z R G B", SCRIPT_SCENE, add_sun, check_sun},
    STATE("light none", "", "", set_no_lights),
    STATE("ambient", "kkk", "R G B", set_ambient),
    STATE("material", "kkke", "KA KD KS SHININESS", set_material),
    STATE("shade", "o", "flat|gouraud|phong", set_shade),
    STATE("option mesh light", "o", "auto|on|off", set_lit),
    STATE("option mesh terms", "o", "all|ambient|diffuse|specular", set_terms),
    STATE("option mesh highlights", "o", "coloured|plain", set_highlights),
    STATE("option mesh backhighlights", "o", "on|off", set_back_highlights),
    STATE("option mesh texture", "o", "none|nearest|bilinear", set_texture),
    STATE("option mesh mapping", "o", "vertices|affine|subdivided|perspective",
          set_mapping),
    STATE("option mesh span", "o", "2|4|8|16|32|64", set_span),
    STATE("option mesh wrap", "o", "clamp|repeat|mirror", set_wrap),
    STATE("option mesh normals", "o", "file|smooth", set_normals),
    STATE("option mesh order", "o", "painter|zbuffer16|zbuffer32", set_order),
    STATE("option mesh cull", "o", "none|back|front", set_cull),
    STATE("option mesh color own", "", "", set_own_colors),
    STATE("option mesh color", "c", "COLOUR", set_color),
    STATE("option mesh transparency", "b", "0..255", set_transparency),
    STATE("option mesh turn", "ttt", "X Y Z", set_turn),
    STATE("texture own", "", "", set_own_texture),
    STATE("texture", "Q", "FILE", set_texture_file),
    {"mesh", "M", "FILE", SCRIPT_MESH, draw_mesh, NULL},
    {NULL, NULL, NULL, SCRIPT_STATE, NULL, NULL},
};
