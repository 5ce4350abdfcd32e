/* The camera of the command line, and the projection on the host, in double. */
#ifndef SIM_CAMERA_H
#define SIM_CAMERA_H

#include <argp.h>

#include "mesh.h"
#include "pel2d.h"

/* What the user asked for; the flags say which of it. */
struct camera {
    double eye[3], target[3], up[3]; /* world units */
    double focal;                    /* mm, > 0 */
    double sensor[2];                /* mm, width and height, > 0 */
    int width, height;               /* px of the picture, 1..32,767 */
    pel_color background;
    bool has_eye, has_target, has_sensor;
    bool is_set; /* any option but --size and --background was given */
};

/* What no option says: up is +y, 50 mm on a sensor 36 mm wide, 1200x1200,
 * white. Eye, target and the sensor's height are chosen by camera_frame. */
extern const struct camera camera_default;

/* --eye X,Y,Z --target X,Y,Z --up X,Y,Z --focal MM --sensor WxH --size WxH
 * --background COLOUR, as a child of a command's options: its input (the child
 * input of argp) is the struct camera to fill. */
extern const struct argp camera_argp;

/* Fills in what was left open, from the mesh: the target is the middle of its
 * box; the eye stands in front, a little to the right and above, as near as
 * shows every vertex with a margin of 1/20; pixels are square. False, with a
 * message on standard error, when eye and target are the same or `up` points
 * along the view. */
bool camera_frame(struct camera *camera, const struct mesh *mesh);

/* Projects a mesh with a camera that camera_frame has completed:
 *     screen x = W/2 + (W / sensor width) focal x_c / z_c, y alike, downwards,
 * rounded to 1/256 px; the depth is z_c, the distance along the view. Triangles
 * are clipped to a near plane at 1/1000 of the distance from eye to target, and
 * to +-32,000 px, so that no coordinate is out of range; `clipped` is the
 * number of triangles of which this took something. False, with a message, when
 * memory is short; `flat` is then empty. */
bool mesh_project(const struct mesh *mesh, const struct camera *camera,
                  struct pel2d *flat, uint32_t *clipped);

#endif
