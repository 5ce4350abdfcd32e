#include "projector.h"

/* num / den = mantissa 2^(spread - 30) with mantissa in [2^29, 2^30]. num <=
 * 2^47 and num <= den 2^spread <= 2^48, so the shifted one fits 54 bits. */
static bool scale_of(uint64_t num, uint64_t den, int32_t *mantissa,
                     int8_t *spread)
{
    int8_t bits = 0;
    while (bits < 24 && num > den << bits)
        bits++;
    *mantissa = (int32_t)(((num << (30 - bits)) + den / 2) / den);
    *spread = bits;
    return num >= den && num <= den << bits;
}

/* Legal sizes in pixels, and of focal length and sensor. */
static bool sizes_legal(const struct pel_camera *c, const struct pel_rect *v)
{
    const bool ortho = c->projection == PEL_ORTHOGRAPHIC;
    const uint32_t limit = ortho ? PEL_LENGTH_MAX : UINT32_C(1) << 24;
    return v->x0 >= -32767 && v->y0 >= -32767 && v->x1 <= 32767 &&
           v->y1 <= 32767 && !pel_rect_empty(v) && v->x1 - v->x0 <= 32767 &&
           v->y1 - v->y0 <= 32767 && (uint32_t)c->sensor[0] - 1 < limit &&
           (uint32_t)c->sensor[1] - 1 < limit &&
           (ortho || (uint32_t)c->focal - 1 < limit);
}

/* Rows of x and y become the sub-pixels of a unit. */
static bool scale_rows(struct pel_projector *p, struct pel_matrix *basis,
                       const struct pel_camera *camera,
                       const struct pel_rect *viewport)
{
    const int32_t from[2] = {viewport->x0, viewport->y0};
    const int32_t to[2] = {viewport->x1, viewport->y1};
    const int32_t focal =
        camera->projection == PEL_ORTHOGRAPHIC ? PEL_UNITS(1) : camera->focal;
    for (int k = 0; k < 2; k++) {
        const uint32_t size = (uint32_t)(to[k] - from[k]) * 256;
        int32_t mantissa;
        if (!scale_of((uint64_t)size * (uint32_t)focal,
                      (uint32_t)camera->sensor[k], &mantissa, &p->spread[k]))
            return false;
        for (int j = 0; j < 3; j++)
            basis->row[k][j] = (int32_t)pel_scale_down(
                (int64_t)basis->row[k][j] * mantissa, 30);
        p->center[k] = (from[k] + to[k]) * 128;
    }
    return true;
}

/* A row times a place is 2^-(30 + shift) unit, times a world vector 2^-46 unit.
 * The coarser of both less 2 bits is fine: each part is then below 3 2^59, and
 * what the other one loses is nothing that the rows' own rounding would leave
 * right. */
static void place_origin(struct pel_projector *p, const struct pel_matrix *rows,
                         const struct pel_pose *pose,
                         const struct pel_camera *camera)
{
    const int shift = p->quantum.shift;
    int64_t from_eye[3];
    for (int k = 0; k < 3; k++)
        from_eye[k] = (int64_t)(pose ? pose->at[k] : 0) - camera->eye[k];
    p->fine_bits = (int8_t)((shift < 16 ? shift + 30 : 46) - 2);
    p->down = (int8_t)(shift + 30 - p->fine_bits);
    pel_matrix_apply(rows, from_eye, 46 - p->fine_bits, p->origin);
}

/* How far the origin and the farthest number of the mesh can be away. */
static void choose_coarse(struct pel_projector *p)
{
    uint64_t reach = 0;
    for (int k = 0; k < 3; k++) {
        int64_t far = 0;
        for (int j = 0; j < 3; j++)
            far += pel_size_of(p->rows.row[k][j]) *
                   (pel_size_of(p->quantum.offset[j]) +
                    INT64_C(32768) * p->quantum.step);
        reach |= (uint64_t)((far >> p->down) + 1 + pel_size_of(p->origin[k]));
    }
    p->coarse = (int8_t)pel_max(pel_bits_of(reach) - 29, 0);
}

static enum pel_status place_near(struct pel_projector *p,
                                  const struct pel_camera *camera)
{
    const int bits = p->fine_bits - p->coarse; /* of a unit, coarse */
    int64_t near = pel_scale_down(camera->near, 16 - bits);
    if (camera->near <= 0 || near < 1)
        return PEL_ERROR_RANGE;
    p->near_fine = pel_scale_down(camera->near, 16 - p->fine_bits);
    near = near < INT32_C(1) << 29 ? near : INT32_C(1) << 29;
    p->near = (int32_t)near;
    p->one = 0;
    if (camera->projection == PEL_ORTHOGRAPHIC)
        p->one = (int32_t)(UINT32_C(1) << bits);
    return PEL_OK;
}

enum pel_status pel_projector_init(struct pel_projector *projector,
                                   const struct pel_mesh *mesh,
                                   const struct pel_pose *pose,
                                   const struct pel_camera *camera,
                                   const struct pel_rect *viewport)
{
    struct pel_projector *p = projector;
    struct pel_matrix basis;
    enum pel_status status = pel_camera_basis(camera, &basis);
    if (status != PEL_OK)
        return status;
    if (!sizes_legal(camera, viewport) ||
        !scale_rows(p, &basis, camera, viewport))
        return PEL_ERROR_SIZE;
    p->quantum = mesh->position;
    place_origin(p, &basis, pose, camera);
    if (pose)
        pel_matrix_multiply(&p->rows, &basis, &pose->turn);
    else
        p->rows = basis;
    choose_coarse(p);
    if (camera->projection == PEL_ORTHOGRAPHIC) /* one unit fits 29 bits */
        p->coarse = (int8_t)pel_max(p->coarse, p->fine_bits - 29);
    return place_near(p, camera);
}
