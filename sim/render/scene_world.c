#include "sim/render/scene.h"

#include <math.h>

#include "sim/mesh/vector.h"

#define WORLD 16384.0      /* units each way, as core has them */
#define ROUNDING 1.00002   /* of a mesh: half of 1/65,536 of its extent */
#define NEAREST (1 / 16.0) /* of an eye, if nothing is to be scaled */
#define FAR_LIGHT 1024

static pel_length length_of(const struct scene *scene, double value)
{
    const double v = value * scene->units * 65536;
    return (pel_length)lround(fmax(-PEL_LENGTH_MAX, fmin(v, PEL_LENGTH_MAX)));
}

static double extent_of(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* `from` has any length: the largest part gets 30 bits. */
static void place_direction(const double from[3], int32_t to[3])
{
    const double extent = extent_of(from);
    for (int k = 0; k < 3; k++)
        to[k] = (int32_t)lround(from[k] / (extent > 0 ? extent : 1) *
                                PEL_COSINE_ONE);
}

/* The largest coordinate of camera and model, however that is turned. */
static double extent_of_all(const struct scene *scene,
                            const struct scene_settings *s)
{
    double middle[3];
    const double radius = model_middle(scene->model, middle);
    double extent = fmax(extent_of(s->camera.eye), extent_of(s->camera.target));
    extent = fmax(extent, (extent_of(middle) + radius) * ROUNDING);
    if (s->camera.projection == PEL_ORTHOGRAPHIC)
        for (int k = 0; k < 2; k++)
            extent = fmax(extent, s->camera.sensor[k]);
    return extent;
}

static bool is_far(const struct scene_light *light, double extent)
{
    return !light->directional && extent_of(light->at) > FAR_LIGHT * extent;
}

/* The power of two that makes all fit core's world, 1 where it does already.
 */
static double units_of(const struct scene *scene,
                       const struct scene_settings *s)
{
    const double places = extent_of_all(scene, s);
    double extent = places, view[3];
    int exponent;
    for (int i = 0; i < s->lights; i++)
        if (!s->light[i].directional && !is_far(&s->light[i], places))
            extent = fmax(extent, extent_of(s->light[i].at));
    vector_subtract(s->camera.target, s->camera.eye, view);
    if (extent <= WORLD && vector_length(view) >= NEAREST &&
        scene->model->mesh.position.shift <= PEL_MESH_SHIFT_MAX)
        return 1;
    frexp(extent, &exponent); /* extent < 2^exponent */
    return ldexp(WORLD, -exponent);
}

static void place_pose(struct scene *scene, const uint16_t turn[3])
{
    static const struct pel_matrix none = PEL_MATRIX_IDENTITY;
    const struct model *model = scene->model;
    struct pel_matrix *to = &scene->pose.turn;
    int64_t middle[3], moved[3];
    *to = none;
    for (int k = 0; k < 3; k++) {
        const struct pel_matrix from = *to;
        struct pel_matrix one;
        pel_matrix_turn(&one, k, turn[k]);
        pel_matrix_multiply(to, &one, &from);
        middle[k] = length_of(scene, (model->low[k] + model->high[k]) / 2);
    }
    pel_matrix_apply(to, middle, 30, moved);
    for (int k = 0; k < 3; k++)
        scene->pose.at[k] = (pel_length)(middle[k] - moved[k]);
    const bool turned = turn[0] || turn[1] || turn[2];
    scene->core.pose = turned ? &scene->pose : NULL;
}

/* A lens in 1/1000 mm, in larger steps where that is too much; square pixels
 * that nobody measured are exactly square. */
static void place_lens(struct pel_camera *to, const struct camera *from)
{
    double lens[3] = {from->focal, from->sensor[0], from->sensor[1]};
    double unit = 1000;
    if (!from->has_sensor) {
        unit = ceil(36000.0 / from->width) * from->width / lens[1];
        lens[2] = lens[1] * from->height / from->width;
    }
    const double most = fmax(lens[0], fmax(lens[1], lens[2]));
    while (most * unit > 1 << 24)
        unit /= 2;
    to->focal = (int32_t)fmax(round(lens[0] * unit), 1);
    for (int k = 0; k < 2; k++)
        to->sensor[k] = (int32_t)fmax(round(lens[1 + k] * unit), 1);
}

static void place_camera(struct scene *scene, const struct scene_settings *s)
{
    const struct camera *from = &s->camera;
    struct pel_camera *to = &scene->core.camera;
    for (int k = 0; k < 3; k++) {
        to->eye[k] = length_of(scene, from->eye[k]);
        to->target[k] = length_of(scene, from->target[k]);
    }
    place_direction(from->up, to->up);
    to->projection = from->projection;
    to->near_plane = (pel_length)fmax(length_of(scene, from->near_plane), 1);
    if (from->projection == PEL_PERSPECTIVE)
        place_lens(to, from);
    for (int k = 0; k < 2 && from->projection == PEL_ORTHOGRAPHIC; k++)
        to->sensor[k] = length_of(scene, from->sensor[k]);
    scene->core.viewport = (struct pel_rect){
        s->left, s->top, s->left + from->width, s->top + from->height};
}

static pel_factor factor_of(double value)
{
    return (pel_factor)lround(value * 65536);
}

static void place_light(struct scene *scene, struct pel_light *to,
                        const struct scene_light *from, bool directional)
{
    to->directional = directional;
    for (int k = 0; k < 3; k++) {
        to->color[k] = factor_of(from->color[k]);
        to->at[k] = length_of(scene, from->at[k]);
    }
    if (directional)
        place_direction(from->at, to->at);
}

/* A light for those who name none: white, from above, left of the viewer. */
static struct scene_light own_light(const struct camera *camera)
{
    struct scene_light light = {.color = {1, 1, 1}, .directional = true};
    const double *up = camera->up;
    double view[3], left[3];
    vector_subtract(camera->eye, camera->target, view);
    vector_cross(view, up, left);
    const double along = vector_dot(view, view), upward = vector_dot(up, up);
    for (int k = 0; k < 3; k++)
        light.at[k] = view[k] / sqrt(along) + 0.9 * up[k] / sqrt(upward) +
                      0.6 * left[k] / sqrt(along * upward);
    return light;
}

static void place_lights(struct scene *scene, const struct scene_settings *s)
{
    const double extent = extent_of_all(scene, s);
    struct pel_lighting *to = &scene->lighting;
    to->light = scene->light;
    to->lights = s->lights;
    for (int i = 0; i < s->lights; i++)
        place_light(scene, &scene->light[i], &s->light[i],
                    s->light[i].directional || is_far(&s->light[i], extent));
    if (s->lights == 0) {
        const struct scene_light own = own_light(&s->camera);
        place_light(scene, &scene->light[0], &own, true);
        to->lights = 1;
    }
    for (int k = 0; k < 3; k++)
        to->ambient_color[k] = factor_of(s->ambient_color[k]);
    to->ambient = s->terms & SCENE_AMBIENT ? factor_of(s->ambient) : 0;
    to->diffuse = s->terms & SCENE_DIFFUSE ? factor_of(s->diffuse) : 0;
    to->specular = s->terms & SCENE_SPECULAR ? factor_of(s->specular) : 0;
    to->shininess = s->shininess;
    to->plain_highlights = s->plain_highlights;
    to->no_back_highlights = s->no_back_highlights;
    to->both_sides = s->both_sides;
}

void scene_place(struct scene *scene, const struct scene_settings *settings)
{
    int exponent;
    scene->units = units_of(scene, settings);
    frexp(scene->units, &exponent); /* units = 2^(exponent - 1) */
    scene->mesh = scene->model->mesh;
    scene->mesh.position.shift -= exponent - 1;
    place_pose(scene, settings->turn);
    place_camera(scene, settings);
    place_lights(scene, settings);
}

static void print_three(FILE *out, const char *name, const int32_t value[3])
{
    fprintf(out, "    .%s = {%ld, %ld, %ld},\n", name, (long)value[0],
            (long)value[1], (long)value[2]);
}

void scene_print_camera(FILE *out, const struct scene *scene)
{
    const struct pel_camera *camera = &scene->core.camera;
    const struct pel_rect *view = &scene->core.viewport;
    const int scale = ilogb(scene->units);
    fprintf(out,
            "/* struct pel_camera, for a viewport of %ld x %ld pixels; places "
            "in 1/65536. */\n",
            (long)(view->x1 - view->x0), (long)(view->y1 - view->y0));
    if (scale != 0)
        fprintf(out,
                "/* The mesh is too large or small as it is: after "
                "pel_mesh_of_asset, take\n   mesh.position.shift -= %d. */\n",
                scale);
    fprintf(out, "{\n");
    print_three(out, "eye", camera->eye);
    print_three(out, "target", camera->target);
    print_three(out, "up", camera->up);
    if (camera->projection == PEL_PERSPECTIVE)
        fprintf(out, "    .focal = %ld,\n", (long)camera->focal);
    fprintf(out, "    .sensor = {%ld, %ld},\n", (long)camera->sensor[0],
            (long)camera->sensor[1]);
    fprintf(out, "    .near_plane = %ld,\n", (long)camera->near_plane);
    fprintf(out, "    .projection = %s,\n}\n",
            camera->projection == PEL_PERSPECTIVE ? "PEL_PERSPECTIVE"
                                                  : "PEL_ORTHOGRAPHIC");
}
