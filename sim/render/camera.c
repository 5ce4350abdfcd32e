#include "sim/render/scene.h"

#include <math.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/mesh/vector.h"

/* The margin of a picture that is framed. */
#define SEEN 0.9

/* Camera space here: x right, y up, z away from the eye along the view. */
struct frustum {
    double eye[3];
    double axis[3][3]; /* x, y, z of camera space, in world space */
    double distance;   /* from eye to target */
    double extent[2];  /* x/z and y/z at the sides of the picture, or x, y */
};

/* False when eye and target are the same or `up` points along the view. */
static bool frustum_init(struct frustum *frustum, const struct camera *camera)
{
    double up[3];
    double *x = frustum->axis[0], *y = frustum->axis[1], *z = frustum->axis[2];
    const bool flat = camera->projection == PEL_ORTHOGRAPHIC;
    memcpy(frustum->eye, camera->eye, sizeof(frustum->eye));
    memcpy(up, camera->up, sizeof(up));
    vector_subtract(camera->target, camera->eye, z);
    frustum->distance = vector_normalise(z);
    vector_normalise(up);
    vector_cross(z, up, x);
    if (!(frustum->distance > 0) || !(vector_normalise(x) > 1e-9))
        return false;
    vector_cross(x, z, y);
    for (int k = 0; k < 2; k++)
        frustum->extent[k] =
            camera->sensor[k] / 2 / (flat ? 1 : camera->focal) * SEEN;
    return true;
}

static void frustum_point(const struct frustum *frustum, const double world[3],
                          double point[3])
{
    double d[3];
    vector_subtract(world, frustum->eye, d);
    for (int k = 0; k < 3; k++)
        point[k] = vector_dot(frustum->axis[k], d);
}

/* The distance or size that each side of the picture needs. */
struct needs {
    double side[2][2]; /* of each axis, each direction */
    double depth;      /* of the deepest vertex around the target */
};

/* In camera space around the target, a vertex is seen in perspective when
 * |x| <= extent (distance + z), and in an orthographic picture when |x| <=
 * extent: so that is what each side asks for, a distance or a size. */
static void find_needs(const struct model *model, const struct frustum *frustum,
                       bool flat, struct needs *needs)
{
    const struct pel_quantization *q = &model->mesh.position;
    memset(needs, 0, sizeof(*needs));
    for (uint32_t i = 0; i < model->mesh.vertices; i++) {
        const int16_t *at = model->mesh.positions[i];
        double p[3], world[3];
        for (int k = 0; k < 3; k++)
            world[k] = ldexp(pel_quantization_value(q, k, at[k]), -q->shift);
        frustum_point(frustum, world, p);
        const double z = p[2] - 1; /* the eye is 1 away from the target */
        needs->depth = fmax(needs->depth, fabs(z));
        for (int k = 0; k < 2; k++) {
            double *side = &needs->side[k][p[k] < 0];
            const double need =
                flat ? fabs(p[k]) : fabs(p[k]) / frustum->extent[k] - z;
            *side = fmax(*side, need);
        }
    }
}

/* The sensor of an orthographic camera: as large as the model needs. */
static void fit_sensor(struct camera *camera, const struct needs *needs)
{
    const double w = fmax(needs->side[0][0], needs->side[0][1]);
    const double h = fmax(needs->side[1][0], needs->side[1][1]);
    double pixel = 2 / SEEN * fmax(w / camera->width, h / camera->height);
    if (!(pixel > 0))
        pixel = 1;
    camera->sensor[0] = pixel * camera->width;
    camera->sensor[1] = pixel * camera->height;
}

/* Places the eye in front, a little to the right and above; moves the target,
 * unless the user chose it, until the opposite sides need the same: a few steps
 * do.
 */
static bool frame_eye(struct camera *camera, const struct model *model)
{
    const bool flat = camera->projection == PEL_ORTHOGRAPHIC;
    static const double direction[3] = {0.36, 0.28, 0.89};
    struct needs needs;
    struct frustum frustum;
    double distance;
    for (int step = 0; step < 8; step++) {
        for (int k = 0; k < 3; k++)
            camera->eye[k] = camera->target[k] + direction[k];
        if (!frustum_init(&frustum, camera))
            return false;
        find_needs(model, &frustum, flat, &needs);
        for (int j = 0; j < 2 && step < 7 && !camera->has_target; j++) {
            const double *side = needs.side[j];
            const double shift =
                (side[0] - side[1]) / 2 * (flat ? 1 : frustum.extent[j]);
            for (int k = 0; k < 3; k++)
                camera->target[k] += shift * frustum.axis[j][k];
        }
    }
    distance = needs.depth * (flat ? 2 : 1.01);
    for (int k = 0; k < 2 && !flat; k++)
        distance = fmax(distance, fmax(needs.side[k][0], needs.side[k][1]));
    for (int k = 0; k < 3; k++)
        camera->eye[k] = camera->target[k] -
                         frustum.axis[2][k] * (distance > 0 ? distance : 1);
    if (flat && !camera->has_sensor)
        fit_sensor(camera, &needs);
    return true;
}

/* An eye that the user placed sees the model around the target. */
static bool frame_sensor(struct camera *camera, const struct model *model)
{
    struct needs needs;
    struct frustum frustum;
    if (!frustum_init(&frustum, camera))
        return false;
    vector_subtract(camera->target, frustum.axis[2], frustum.eye);
    find_needs(model, &frustum, true, &needs);
    fit_sensor(camera, &needs);
    return true;
}

bool camera_frame(struct camera *camera, const struct model *model)
{
    struct frustum frustum;
    const bool flat = camera->projection == PEL_ORTHOGRAPHIC;
    if (!camera->has_sensor)
        camera->sensor[1] = camera->sensor[0] * camera->height / camera->width;
    if (!camera->has_target)
        model_middle(model, camera->target);
    if (!camera->has_eye && !frame_eye(camera, model))
        return message_error("up points along the view: expected 0,1,0 for a "
                             "mesh that stands upright");
    const bool fitted = !flat || !camera->has_eye || camera->has_sensor ||
                        frame_sensor(camera, model);
    if (!fitted || !frustum_init(&frustum, camera))
        return message_error("eye and target are one place, or up points along "
                             "the view: expected an eye beside the target and "
                             "an up across the view");
    double middle[3], at[3];
    const double radius = model_middle(model, middle);
    frustum_point(&frustum, middle, at);
    if (!camera->has_near)
        camera->near_plane =
            fmax(frustum.distance / 1000, 0.98 * (at[2] - radius));
    return true;
}
