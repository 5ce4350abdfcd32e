#include <errno.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/cli/number.h"
#include "sim/cli/option_text.h"
#include "sim/render/scene_options.h"

enum {
    KEY_EYE = 0x100,
    KEY_TARGET,
    KEY_UP,
    KEY_PROJECTION,
    KEY_FOCAL,
    KEY_SENSOR,
    KEY_NEAR,
    KEY_SIZE,
    KEY_BACKGROUND
};

static const struct argp_option options[] = {
    {0, 0, 0, 0, "Camera:", 2},
    {"eye", KEY_EYE, "X,Y,Z", 0,
     "where the camera stands (default: where it sees the whole mesh)", 0},
    {"target", KEY_TARGET, "X,Y,Z", 0,
     "what it looks at (default: the middle of the mesh)", 0},
    {"up", KEY_UP, "X,Y,Z", 0, "what is up in the picture (default: 0,1,0)", 0},
    {"projection", KEY_PROJECTION, "NAME", 0,
     "perspective (default) or orthographic", 0},
    {"focal", KEY_FOCAL, "MM", 0, "focal length in mm (default: 50)", 0},
    {"sensor", KEY_SENSOR, "WxH", 0,
     "sensor size in mm (default: 36 mm wide, square pixels); of an "
     "orthographic camera the size of what is seen, in the mesh's units",
     0},
    {"near", KEY_NEAR, "DISTANCE", 0,
     "nothing nearer to the eye is seen (default: just before the mesh)", 0},
    {"size", KEY_SIZE, "WxH", 0,
     "size of the picture in pixels (default: 1200x1200)", 0},
    {"background", KEY_BACKGROUND, "COLOUR", 0, "#rrggbb (default: #ffffff)",
     0},
    {0},
};

static bool parse_point(const char *option, const char *text, double point[3])
{
    static const struct option_numbers numbers = {
        3, ',', -MESH_LIMIT, MESH_LIMIT, "X,Y,Z such as 0,1.5,4"};
    return option_numbers(option, text, &numbers, point);
}

static bool parse_focal(const char *text, struct camera *camera)
{
    static const struct option_numbers numbers = {
        1, 0, 1e-6, 1e6, "a length in mm, such as 50,"};
    return option_numbers("--focal", text, &numbers, &camera->focal);
}

static bool parse_sensor(const char *text, struct camera *camera)
{
    static const struct option_numbers numbers = {2, 'x', 1e-6, MESH_LIMIT,
                                                  "WxH in mm, such as 36x24,"};
    camera->has_sensor = true;
    return option_numbers("--sensor", text, &numbers, camera->sensor);
}

static bool parse_near(const char *text, struct camera *camera)
{
    static const struct option_numbers numbers = {
        1, 0, 1e-15, MESH_LIMIT, "a distance above 0, such as 0.1,"};
    camera->has_near = true;
    return option_numbers("--near", text, &numbers, &camera->near);
}

static bool parse_projection(const char *text, struct camera *camera)
{
    static const char *const names[] = {"perspective", "orthographic", NULL};
    int choice = 0;
    const bool right = option_choice("--projection", text, names, &choice);
    camera->projection = choice ? PEL_ORTHOGRAPHIC : PEL_PERSPECTIVE;
    return right;
}

static bool parse_size(const char *text, struct camera *camera)
{
    char copy[32];
    int64_t w = 0, h = 0;
    const char *x = strchr(text, 'x');
    size_t n = x ? (size_t)(x - text) : sizeof(copy);
    if (n < sizeof(copy)) {
        memcpy(copy, text, n);
        copy[n] = '\0';
        if (number_integer(copy, 1, 32767, &w) == NUMBER_OK &&
            number_integer(x + 1, 1, 32767, &h) == NUMBER_OK) {
            camera->width = (int)w;
            camera->height = (int)h;
            return true;
        }
    }
    return message_error("--size is '%s'; WxH from 1x1 to 32767x32767, such as "
                         "640x480, would be right",
                         text);
}

/* The options that say where things are. */
static bool parse_place(int key, const char *text, struct camera *camera)
{
    camera->is_set = true;
    switch (key) {
    case KEY_EYE:
        camera->has_eye = true;
        return parse_point("--eye", text, camera->eye);
    case KEY_TARGET:
        camera->has_target = true;
        return parse_point("--target", text, camera->target);
    case KEY_UP:
        return parse_point("--up", text, camera->up);
    case KEY_PROJECTION:
        return parse_projection(text, camera);
    case KEY_FOCAL:
        return parse_focal(text, camera);
    case KEY_SENSOR:
        return parse_sensor(text, camera);
    default:
        return parse_near(text, camera);
    }
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct scene_options *o = state->input;
    struct camera *camera = &o->settings.camera;
    bool right;
    if (key < KEY_EYE || key > KEY_BACKGROUND)
        return ARGP_ERR_UNKNOWN;
    options_note(&o->given, options, key);
    if (key == KEY_SIZE)
        right = parse_size(text, camera);
    else if (key == KEY_BACKGROUND)
        right = option_color("--background", text, &camera->background);
    else
        right = parse_place(key, text, camera);
    return right ? 0 : EINVAL;
}

const struct argp camera_argp = {.options = options, .parser = parse};
