/* Cameras, and the projection of a mesh to sub-pixels. */
#ifndef PEL_SCENE_CAMERA_H
#define PEL_SCENE_CAMERA_H

#include "../base/rect.h"
#include "../base/status.h"
#include "mesh.h"
#include "vector.h"

PEL_BEGIN_DECLS

enum pel_projection { PEL_PERSPECTIVE, PEL_ORTHOGRAPHIC };

/* Of a position seen from the eye x_c leads to the right, y_c downwards, z_c
 * along the view, through the middle of the viewport of W x H pixels:
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

/* The rotation from world to x_c, y_c, z_c: right to 2^-28 while `up` and
 * target - eye are below 2^30, otherwise to 2^-28 by the sine of their angle.
 * PEL_ERROR_RANGE: the eye is at the target, `up` is 0 or along the view, or a
 * position is out of range. */
enum pel_status pel_camera_basis(const struct pel_camera *camera,
                                 struct pel_matrix *basis);

/* The pose of a mesh: world = turn position + at. */
struct pel_pose {
    struct pel_matrix turn;
    pel_length at[3];
};

/* No turn, at (0, 0, 0). */
extern const struct pel_pose pel_pose_none;

/* Camera space with x and y scaled for the viewport, so that the sub-pixel of a
 * position is center + x 2^spread / z. Fine numbers are 2^-fine_bits world
 * units in 64 bits, below 2^61; they are clipped. Coarse ones, 2^-coarse of
 * them, are below 2^29 in size for every vertex of the mesh; they are stored.
 */
struct pel_projector {
    struct pel_matrix rows; /* of the mesh, scaled */
    int64_t origin[3];      /* fine */
    int64_t near_fine;      /* the near plane, fine */
    int32_t near_coarse;    /* coarse, at least 1 */
    int32_t one;       /* coarse: z of all positions when orthographic, or 0 */
    int32_t center[2]; /* sub-pixels */
    int32_t spread[2]; /* 0..24 */
    int32_t down;      /* bits from a row times a position to fine */
    int32_t fine_bits, coarse;
    struct pel_quantization quantization;
};

/* The mesh has passed pel_mesh_check. PEL_ERROR_NULL; PEL_ERROR_SIZE: an empty
 * viewport, or one beyond +-32,767 px, or a focal length or sensor out of
 * range, or of an extent that makes more than 65,536 or less than 1/256 pixel
 * of a unit at distance 1; PEL_ERROR_RANGE: pel_camera_basis, or `near_plane`
 * is not above 0, or more than 2^28 times smaller than the farthest a vertex of
 * the mesh could be away.
 */
enum pel_status pel_projector_init(struct pel_projector *projector,
                                   const struct pel_mesh *mesh,
                                   const struct pel_pose *pose,
                                   const struct pel_camera *camera,
                                   const struct pel_rect *viewport);

/* An upper bound of the distance of legal positions from (0, 0, 0), in
 * numerators; below 2^33, and below 2^16 units. */
int64_t pel_quantization_extent(const struct pel_quantization *quantization);

/* The x of a vertex that has to be clipped: it is behind the near plane, or out
 * of the legal range of sub-pixels less one pixel. */
#define PEL_NOT_ON_SCREEN INT32_MIN

struct pel_projected {
    int32_t x, y; /* sub-pixels, absolute */
    int32_t z;    /* coarse; right for every vertex */
};

/* Projects a vertex to the sub-pixel nearest to the exact projection, or its
 * neighbour, while (S + |x|) D / z < 2^27: S sub-pixels per unit at distance 1,
 * x sub-pixels from the middle of the viewport, D the sum of the components of
 * the distances from eye to pose and from there to the vertex. The error before
 * rounding is less than (S + |x|) D / z 2^-28 sub-pixels, where the camera's
 * directions are right to 2^-28. */
void pel_project(const struct pel_projector *projector,
                 const int16_t position[3], struct pel_projected *out);

/* x, y, z of a vertex, fine. */
void pel_project_fine(const struct pel_projector *projector,
                      const int16_t position[3], int64_t out[3]);

/* The sub-pixel of a fine place in front of the near plane, clamped to the
 * legal range less one pixel. */
struct pel_point pel_project_clipped(const struct pel_projector *projector,
                                     const int64_t fine[3]);

/* The legal range of sub-pixels less one pixel. */
#define PEL_GUARD_MIN (PEL_COORDINATE_MIN + 256)
#define PEL_GUARD_MAX (PEL_COORDINATE_MAX - 256)
PEL_END_DECLS
#endif
