#include "camera.h"

#include "../base/divide.h"

/* The product is exact when the vectors fit 30 bits; rounding others moves it
 * by less than 2^30. */
static bool find_right(const int64_t forward[3], const int64_t up[3],
                       pel_cosine right[3])
{
    int32_t a[3], b[3];
    int64_t product[3];
    if (!pel_vector_fit(forward, a) || !pel_vector_fit(up, b))
        return false;
    pel_cross(a, b, product);
    return pel_vector_bound(product) >= UINT32_C(1) << 30 &&
           pel_normalize(product, right);
}

enum pel_status pel_camera_basis(const struct pel_camera *camera,
                                 struct pel_matrix *basis)
{
    int64_t forward[3], up[3];
    for (int k = 0; k < 3; k++) {
        if (!pel_length_legal(camera->eye[k]) ||
            !pel_length_legal(camera->target[k]))
            return PEL_ERROR_RANGE;
        forward[k] = (int64_t)camera->target[k] - camera->eye[k];
        up[k] = camera->up[k];
    }
    if (!find_right(forward, up, basis->row[0]))
        return PEL_ERROR_RANGE;
    pel_normalize(forward, basis->row[2]);
    pel_cross(basis->row[2], basis->row[0], up); /* down */
    pel_normalize(up, basis->row[1]);
    return PEL_OK;
}

const struct pel_pose pel_pose_none = {PEL_MATRIX_IDENTITY, {0, 0, 0}};

/* num / den = mantissa 2^(spread - 30) with mantissa in [2^29, 2^30]; the ratio
 * is 1 to 2^24. num <= 2^47, so the shifted one fits 54 bits. */
static bool scale_of(uint64_t num, uint32_t den, int32_t *mantissa,
                     int32_t *spread)
{
    int32_t bits = 0;
    if (num < den)
        return false;
    for (uint64_t end = den; num > end; end <<= 1)
        bits++;
    if (bits > 24)
        return false;
    *mantissa = (int32_t)pel_divide((num << (30 - bits)) + den / 2, den);
    *spread = bits;
    return true;
}

/* Row 0 or 1 becomes the sub-pixels of a unit, on pixels [from, to). */
static bool scale_row(struct pel_projector *p, const struct pel_camera *camera,
                      int k, int32_t from, int32_t to)
{
    uint32_t limit = UINT32_C(1) << 24, focal = (uint32_t)camera->focal;
    const uint32_t sensor = (uint32_t)camera->sensor[k];
    int32_t mantissa;
    if (camera->projection == PEL_ORTHOGRAPHIC) {
        limit = PEL_LENGTH_MAX;
        focal = PEL_UNITS(1);
    }
    if (from < -32767 || to > 32767 || from >= to || to - from > 32767 ||
        focal - 1 >= limit || sensor - 1 >= limit ||
        !scale_of(
            pel_times((uint64_t)(uint32_t)(to - from) * 256, (int32_t)focal),
            sensor, &mantissa, &p->spread[k]))
        return false;
    for (int j = 0; j < 3; j++)
        p->rows.row[k][j] = pel_scaled(p->rows.row[k][j], mantissa, 30);
    p->center[k] = (from + to) * 128;
    return true;
}

/* A row times a position is 2^-(30 + shift) unit, times a world vector 2^-46
 * unit. The coarser of both less 2 bits is fine: each part is then below 3
 * 2^59, and what the other one loses is nothing that the rows' own rounding
 * would leave right. */
static PEL_NOINLINE void set_origin(struct pel_projector *p,
                                    const struct pel_pose *pose,
                                    const struct pel_camera *camera)
{
    const int shift = pel_min(p->quantization.shift, 16);
    p->fine_bits = shift + 28;
    p->down = p->quantization.shift - shift + 2;
    for (int k = 0; k < 3; k++)
        p->origin[k] = pel_scale_down(pel_dot(p->rows.row[k], pose->at) -
                                          pel_dot(p->rows.row[k], camera->eye),
                                      18 - shift);
}

int64_t pel_quantization_extent(const struct pel_quantization *quantization)
{
    int64_t extent = pel_long_product(98304, quantization->step);
    const int32_t *const end = quantization->offset + 3;
    for (const int32_t *o = quantization->offset; o < end; o++)
        extent += pel_size_of(*o);
    const int64_t world =
        pel_long_product(3, pel_quantization_limit(quantization));
    return extent < world ? extent : world;
}

/* An upper bound of the distance of the origin plus that of the farthest
 * position of the mesh: a row is not longer than 1. */
static void choose_coarse(struct pel_projector *p)
{
    const int64_t far =
        (pel_quantization_extent(&p->quantization) * (1 << 30) >> p->down) + 1 +
        (int64_t)pel_vector_bound(p->origin);
    p->coarse = pel_max(pel_bits_of((uint64_t)far) - 29, 0);
}

static enum pel_status set_near(struct pel_projector *p,
                                const struct pel_camera *camera)
{
    const int bits = p->fine_bits - p->coarse; /* of a unit, coarse */
    int64_t near = pel_scale_down(camera->near_plane, 16 - bits);
    if (camera->near_plane <= 0 || near < 1)
        return PEL_ERROR_RANGE;
    p->near_fine = pel_scale_down(camera->near_plane, 16 - p->fine_bits);
    near = near < INT32_C(1) << 29 ? near : INT32_C(1) << 29;
    p->near_coarse = (int32_t)near;
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
    if (!p || !mesh || !pose || !camera || !viewport)
        return PEL_ERROR_NULL;
    enum pel_status status = pel_camera_basis(camera, &p->rows);
    if (status != PEL_OK)
        return status;
    if (!scale_row(p, camera, 0, viewport->x0, viewport->x1) ||
        !scale_row(p, camera, 1, viewport->y0, viewport->y1))
        return PEL_ERROR_SIZE;
    p->quantization = mesh->position;
    set_origin(p, pose, camera);
    pel_matrix_multiply(&p->rows, &p->rows, &pose->turn);
    choose_coarse(p);
    if (camera->projection == PEL_ORTHOGRAPHIC) /* one unit fits 29 bits */
        p->coarse = pel_max(p->coarse, p->fine_bits - 29);
    return set_near(p, camera);
}

void pel_project_fine(const struct pel_projector *projector,
                      const int16_t position[3], int64_t out[3])
{
    const struct pel_projector *p = projector;
    int32_t value[3];
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        value[k] = pel_quantization_value(&p->quantization, k, position[k]);
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        out[k] = pel_scale_down(pel_dot(p->rows.row[k], value), p->down) +
                 p->origin[k];
}

/* The nearest whole number to n 2^bits / z; z > 0, and `divisor` is z 2^-down,
 * of 31 bits. The numerator is then below 2^55, and one of 2^24 more keeps it
 * above 0. */
static int32_t quotient(int64_t n, int bits, int down, uint32_t divisor)
{
    uint64_t sum = (uint64_t)pel_scale_down(n, down - bits);
    sum += ((uint64_t)divisor << 24) + divisor / 2;
    return (int32_t)pel_divide(sum, divisor) - (INT32_C(1) << 24);
}

/* The sub-pixel of a fine position, clamped to the legal range; true when that
 * changes nothing. */
static bool on_screen(const struct pel_projector *p, const int64_t c[3],
                      int32_t out[2])
{
    const int64_t z = p->one ? pel_scale_down(p->one, -p->coarse) : c[2];
    const int down = pel_bits_of((uint64_t)z) - 31;
    const uint32_t divisor = (uint32_t)pel_scale_down(z, down);
    bool on = true;
    for (int k = 0; k < 2; k++) {
        int32_t at = c[k] < 0 ? PEL_GUARD_MIN * 2 : PEL_GUARD_MAX * 2;
        if (pel_size_of(c[k]) >> (24 - p->spread[k]) < z)
            at = quotient(c[k], p->spread[k], down, divisor);
        at += p->center[k];
        out[k] = pel_max(PEL_GUARD_MIN, pel_min(at, PEL_GUARD_MAX));
        on &= out[k] == at;
    }
    return on;
}

void pel_project(const struct pel_projector *projector,
                 const int16_t position[3], struct pel_projected *out)
{
    const struct pel_projector *p = projector;
    int64_t fine[3];
    int32_t at[2];
    pel_project_fine(p, position, fine);
    out->z = (int32_t)(fine[2] >> p->coarse);
    const bool seen = out->z >= p->near_coarse && on_screen(p, fine, at);
    out->x = seen ? at[0] : PEL_NOT_ON_SCREEN;
    out->y = seen ? at[1] : 0;
}

struct pel_point pel_project_clipped(const struct pel_projector *projector,
                                     const int64_t fine[3])
{
    int32_t at[2];
    on_screen(projector, fine, at);
    return (struct pel_point){at[0], at[1]};
}
