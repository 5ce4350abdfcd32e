#include "camera.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "number.h"

enum { KEY_EYE = 0x100, KEY_TARGET, KEY_UP, KEY_FOCAL, KEY_SENSOR, KEY_SIZE };
enum { KEY_BACKGROUND = KEY_SIZE + 1 };

static const struct argp_option options[] = {
    {0, 0, 0, 0, "Camera:", 2},
    {"eye", KEY_EYE, "X,Y,Z", 0,
     "where the camera stands (default: where it sees the whole mesh)", 0},
    {"target", KEY_TARGET, "X,Y,Z", 0,
     "what it looks at (default: the middle of the mesh)", 0},
    {"up", KEY_UP, "X,Y,Z", 0, "what is up in the picture (default: 0,1,0)", 0},
    {"focal", KEY_FOCAL, "MM", 0, "focal length in mm (default: 50)", 0},
    {"sensor", KEY_SENSOR, "WxH", 0,
     "sensor size in mm (default: 36 mm wide, square pixels)", 0},
    {"size", KEY_SIZE, "WxH", 0,
     "size of the picture in pixels (default: 1200x1200)", 0},
    {"background", KEY_BACKGROUND, "COLOUR", 0, "#rrggbb (default: #ffffff)",
     0},
    {0},
};

/* n finite numbers with `separator` between them, nothing else. */
static bool parse_numbers(const char *text, char separator, int n,
                          double *value)
{
    for (int i = 0; i < n; i++) {
        char *end;
        value[i] = strtod(text, &end);
        if (end == text || !(fabs(value[i]) <= MESH_LIMIT) ||
            *end != (i < n - 1 ? separator : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

static bool parse_point(const char *option, const char *text, double point[3])
{
    return parse_numbers(text, ',', 3, point) ||
           message_error("%s is '%s'; X,Y,Z such as 0,1.5,4 would be right",
                         option, text);
}

static bool parse_positive(const char *option, const char *text, int n,
                           double *value)
{
    bool right = parse_numbers(text, 'x', n, value);
    for (int i = 0; i < n && right; i++)
        right = value[i] >= 1e-6 && value[i] <= 1e6;
    return right ||
           message_error("%s is '%s'; %s in mm, such as %s, would be right",
                         option, text, n == 1 ? "a length" : "WxH",
                         n == 1 ? "50" : "36x24");
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

static bool parse_background(const char *text, struct camera *camera)
{
    const char *digits = text + (*text == '#');
    if (strlen(digits) != 6 ||
        digits[strspn(digits, "0123456789abcdefABCDEF")] != '\0')
        return message_error("--background is '%s'; #rrggbb, such as #ffffff, "
                             "would be right",
                             text);
    camera->background =
        PEL_RGB(0, 0, 0) | (pel_color)strtoul(digits, NULL, 16);
    return true;
}

/* The options that say where things are. */
static bool parse_place(int key, const char *text, struct camera *camera)
{
    switch (key) {
    case KEY_EYE:
        camera->has_eye = true;
        return parse_point("--eye", text, camera->eye);
    case KEY_TARGET:
        camera->has_target = true;
        return parse_point("--target", text, camera->target);
    case KEY_UP:
        return parse_point("--up", text, camera->up);
    case KEY_FOCAL:
        return parse_positive("--focal", text, 1, &camera->focal);
    default:
        camera->has_sensor = true;
        return parse_positive("--sensor", text, 2, camera->sensor);
    }
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct camera *camera = state->input;
    bool right;
    if (key == KEY_SIZE) {
        right = parse_size(text, camera);
    } else if (key == KEY_BACKGROUND) {
        right = parse_background(text, camera);
    } else if (key >= KEY_EYE && key <= KEY_SENSOR) {
        camera->is_set = true;
        right = parse_place(key, text, camera);
    } else {
        return ARGP_ERR_UNKNOWN;
    }
    return right ? 0 : EINVAL;
}

const struct argp camera_argp = {.options = options, .parser = parse};
