/* A camera as numbers for the projection. */
#ifndef SIM_CAMERA_VIEW_H
#define SIM_CAMERA_VIEW_H

#include "camera.h"

/* Camera space here: x right, y up, z away from the eye along the view. */
struct camera_view {
    double eye[3];
    double axis[3][3]; /* x, y, z of camera space, in world space */
    double scale[2];   /* px per x/z and y/z */
    double middle[2];  /* px */
    double near;       /* smallest z that is seen */
};

/* False when eye and target are the same or `up` points along the view. */
bool camera_view_init(struct camera_view *view, const struct camera *camera);

static inline double camera_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* World to camera space. */
static inline void camera_view_point(const struct camera_view *view,
                                     const double world[3], double point[3])
{
    double d[3];
    for (int k = 0; k < 3; k++)
        d[k] = world[k] - view->eye[k];
    for (int k = 0; k < 3; k++)
        point[k] = camera_dot(view->axis[k], d);
}

#endif
