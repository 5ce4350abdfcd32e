#include <math.h>
#include <string.h>

#include "sim/mesh/vector.h"
#include "sim/view/turntable.h"

#define TURN 6.283185307179586

/* The camera stays below the zenith: there its up would point along the view.
 */
#define STEEPEST 0.245 /* turns */

static const double zoom_most = 8;

void view_reset(struct view *view)
{
    view->settings = view->first;
    view->dark = 0;
    view->spin = view->tilt = 0;
    view->zoom = 1;
}

bool view_init(struct view *view, const struct scene_settings *settings,
               const struct model *model)
{
    struct camera *camera = &view->first.camera;
    view->first = *settings;
    view->turning = view->lit = false;
    if (!camera_frame(camera, model))
        return false;
    camera->has_eye = camera->has_target = true;
    view_reset(view);
    return true;
}

/* The vector from the target to the eye, as length, elevation above the horizon
 * in turns, and the directions of the horizon and of up. */
struct orbit {
    double length, elevation;
    double ahead[3], up[3];
};

static struct orbit orbit_of(const struct camera *camera)
{
    struct orbit orbit;
    memcpy(orbit.up, camera->up, sizeof orbit.up);
    vector_subtract(camera->eye, camera->target, orbit.ahead);
    vector_normalise(orbit.up);
    const double height = vector_dot(orbit.ahead, orbit.up);
    orbit.length = vector_length(orbit.ahead);
    orbit.elevation = asin(fmin(fmax(height / orbit.length, -1), 1)) / TURN;
    for (int k = 0; k < 3; k++)
        orbit.ahead[k] -= height * orbit.up[k];
    vector_normalise(orbit.ahead);
    return orbit;
}

void view_orbit(struct view *view, double right, double up)
{
    const struct orbit orbit = orbit_of(&view->first.camera);
    const double low = fmin(-STEEPEST - orbit.elevation, 0);
    const double high = fmax(STEEPEST - orbit.elevation, 0);
    view->tilt = fmin(fmax(view->tilt + up, low), high);
    view->spin += right;
    view->spin -= floor(view->spin);
}

void view_zoom(struct view *view, double factor)
{
    view->zoom = fmin(fmax(view->zoom * factor, 1 / zoom_most), zoom_most);
}

/* An eye that has not moved is not computed again: rounding would move it. */
static void place_eye(const struct view *view, struct camera *camera)
{
    const bool closer =
        view->zoom != 1 && camera->projection == PEL_PERSPECTIVE;
    const struct orbit orbit = orbit_of(camera);
    const double angle = TURN * (orbit.elevation + view->tilt);
    const double length = orbit.length / (closer ? view->zoom : 1);
    if (view->tilt == 0 && !closer)
        return;
    for (int k = 0; k < 3; k++)
        camera->eye[k] =
            camera->target[k] +
            length * (cos(angle) * orbit.ahead[k] + sin(angle) * orbit.up[k]);
}

/* A sensor that grows with the window, so that what was seen before still is;
 * square pixels of a perspective camera are left to camera_frame. */
static void place_sensor(const struct view *view, struct camera *camera,
                         int width, int height)
{
    const bool flat = camera->projection == PEL_ORTHOGRAPHIC;
    const double size[2] = {(double)width / camera->width,
                            (double)height / camera->height};
    for (int k = 0; k < 2; k++) {
        camera->sensor[k] *= size[k] / fmin(size[0], size[1]);
        if (flat)
            camera->sensor[k] /= view->zoom;
    }
    camera->has_sensor = camera->has_sensor || flat;
    camera->width = width;
    camera->height = height;
}

/* Switches lights off. Where no light is named core has one of its own; to
 * switch that off it is named, and made black. */
static void place_lights(const struct view *view, struct scene_settings *s)
{
    if (s->lights == 0 && (view->dark & 1)) {
        s->lights = 1;
        s->light[0] =
            (struct scene_light){.at = {0, 1, 0}, .directional = true};
    }
    for (int i = 0; i < s->lights; i++)
        for (int k = 0; k < 3 && (view->dark >> i & 1); k++)
            s->light[i].color[k] = 0;
}

void view_settings(const struct view *view, int width, int height,
                   struct scene_settings *settings)
{
    *settings = view->settings;
    place_eye(view, &settings->camera);
    place_sensor(view, &settings->camera, width, height);
    place_lights(view, settings);
    /* As `pel render --turn` rounds it. */
    const uint16_t spin = (uint16_t)(int32_t)(view->spin * 65536);
    settings->turn[1] = (uint16_t)(settings->turn[1] + spin);
}
