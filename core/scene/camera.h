/* Cameras: where the eye is, and what part of the world a picture shows. */
#ifndef PEL_SCENE_CAMERA_H
#define PEL_SCENE_CAMERA_H

#include "../base/status.h"
#include "matrix.h"

PEL_BEGIN_DECLS

enum pel_projection { PEL_PERSPECTIVE, PEL_ORTHOGRAPHIC };

/* With x_c to the right, y_c downwards and z_c the distance along the view, of
 * a place seen from the eye, and W x H the viewport, its middle is hit by
 * z_c's axis and
 *
 *     perspective:   x = W / 2 + W focal / sensor[0] x_c / z_c
 *                    y = H / 2 + H focal / sensor[1] y_c / z_c
 *     orthographic:  x = W / 2 + W / sensor[0] x_c, y alike.
 *
 * Pixels are square when sensor[0] : sensor[1] is W : H. */
struct pel_camera {
    pel_length eye[3], target[3];
    int32_t up[3]; /* of any length: {0, 1, 0} will do */

    /* Perspective: focal length and sensor in any unit that is the same for
     * the three, such as 1/1000 mm; 1 to 2^24. Orthographic: the sensor is a
     * pel_length, width and height of what is seen, focal is not used. */
    int32_t focal, sensor[2];

    pel_length near_plane; /* > 0: nothing nearer is seen */
    enum pel_projection projection;
};

/* The rotation from world to x_c, y_c, z_c: right to 2^-28 while the parts of
 * `up` and of target - eye are below 2^30, otherwise to 2^-28 by the sine of
 * the angle between the two. PEL_ERROR_RANGE: the eye is at the
 * target, or `up` is 0 or lies along the view, or a place is out of range. */
enum pel_status pel_camera_basis(const struct pel_camera *camera,
                                 struct pel_matrix *basis);
PEL_END_DECLS
#endif
