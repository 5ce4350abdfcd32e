#include "camera.h"

#include <math.h>
#include <string.h>

#include "camera_view.h"
#include "message.h"

const struct camera camera_default = {
    .up = {0, 1, 0},
    .focal = 50,
    .sensor = {36, 0},
    .width = 1200,
    .height = 1200,
    .background = PEL_RGB(255, 255, 255),
};

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* The length before; 0 when the vector has no direction. */
static double normalise(double v[3])
{
    double length = sqrt(camera_dot(v, v));
    for (int k = 0; k < 3 && length > 0; k++)
        v[k] /= length;
    return length;
}

bool camera_view_init(struct camera_view *view, const struct camera *camera)
{
    double up[3];
    double *x = view->axis[0], *y = view->axis[1], *z = view->axis[2];
    memcpy(view->eye, camera->eye, sizeof(view->eye));
    memcpy(up, camera->up, sizeof(up));
    for (int k = 0; k < 3; k++)
        z[k] = camera->target[k] - camera->eye[k];
    double distance = normalise(z);
    normalise(up);
    cross(z, up, x);
    if (!(distance > 0) || !(normalise(x) > 1e-9))
        return false;
    cross(x, z, y);
    view->near = distance / 1000;
    view->middle[0] = camera->width / 2.0;
    view->middle[1] = camera->height / 2.0;
    view->scale[0] = camera->width / camera->sensor[0] * camera->focal;
    view->scale[1] = camera->height / camera->sensor[1] * camera->focal;
    return true;
}

static void middle_of_box(const struct mesh *mesh, double middle[3])
{
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (uint32_t i = 0; i < mesh->vertices; i++) {
            low = fmin(low, mesh->vertex[i].position[k]);
            high = fmax(high, mesh->vertex[i].position[k]);
        }
        middle[k] = mesh->vertices ? (low + high) / 2 : 0;
    }
}

/* The smallest distance from the target that shows the whole mesh with a
 * margin. In camera space around the target, a vertex is seen when
 *     |x| scale <= 0.9 W/2 (distance + z),
 * so the right and the left side, and the top and the bottom, ask for a
 * distance each. `shift` gets, for x and y, by how much to move the target so
 * that opposite sides ask for nearly the same. */
static double distance_to_see(const struct mesh *mesh,
                              const struct camera_view *view, double shift[2])
{
    double needed[2][2] = {{0, 0}, {0, 0}}; /* of each axis, each side */
    double deepest = 0;
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        double p[3];
        camera_view_point(view, mesh->vertex[i].position, p);
        double z = p[2] - 1; /* the eye is 1 away from the target */
        deepest = fmax(deepest, fabs(z));
        for (int k = 0; k < 2; k++) {
            double width = 0.9 * view->middle[k] / view->scale[k];
            double *side = &needed[k][p[k] < 0];
            *side = fmax(*side, fabs(p[k]) / width - z);
        }
    }
    double distance = deepest * 1.01;
    for (int k = 0; k < 2; k++) {
        double width = 0.9 * view->middle[k] / view->scale[k];
        shift[k] = (needed[k][0] - needed[k][1]) / 2 * width;
        distance = fmax(distance, fmax(needed[k][0], needed[k][1]));
    }
    return distance > 0 ? distance : 1;
}

/* Places the eye; moves the target, unless the user chose it, until the mesh
 * is in the middle: a few steps do. */
static bool frame_eye(struct camera *camera, const struct mesh *mesh)
{
    static const double direction[3] = {0.36, 0.28, 0.89};
    struct camera_view view;
    double distance = 1, shift[2];
    for (int step = 0; step < 8; step++) {
        for (int k = 0; k < 3; k++)
            camera->eye[k] = camera->target[k] + direction[k];
        if (!camera_view_init(&view, camera))
            return false;
        distance = distance_to_see(mesh, &view, shift);
        for (int k = 0; k < 3 && !camera->has_target && step < 7; k++)
            camera->target[k] +=
                shift[0] * view.axis[0][k] + shift[1] * view.axis[1][k];
    }
    for (int k = 0; k < 3; k++)
        camera->eye[k] = camera->target[k] - view.axis[2][k] * distance;
    return true;
}

bool camera_frame(struct camera *camera, const struct mesh *mesh)
{
    struct camera_view view;
    if (!camera->has_sensor)
        camera->sensor[1] = camera->sensor[0] * camera->height / camera->width;
    if (!camera->has_target)
        middle_of_box(mesh, camera->target);
    if (!camera->has_eye && !frame_eye(camera, mesh))
        return message_error("--up points along the view; 0,1,0 would be right "
                             "for a mesh that stands upright");
    return camera_view_init(&view, camera) ||
           message_error("--eye is --target, or --up points along the view; an "
                         "eye beside the target and --up across the view would "
                         "be right");
}
