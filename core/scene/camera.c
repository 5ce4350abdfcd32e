#include "camera.h"

/* Exact for vectors up to 2^30: below 2^61. */
static void cross(const int32_t a[3], const int32_t b[3], int64_t out[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        out[k] = (int64_t)a[i] * b[j] - (int64_t)a[j] * b[i];
    }
}

static bool in_world(const pel_length v[3])
{
    for (int k = 0; k < 3; k++)
        if (v[k] > PEL_LENGTH_MAX || v[k] < -PEL_LENGTH_MAX)
            return false;
    return true;
}

/* Of vectors that fit 30 bits as they are the product is exact; rounding others
 * moves it by less than 2^30. */
static bool across(const int64_t forward[3], const int32_t camera_up[3],
                   pel_cosine right[3])
{
    const int64_t up[3] = {camera_up[0], camera_up[1], camera_up[2]};
    int32_t a[3], b[3];
    int64_t product[3];
    if (!pel_vector_fit(forward, a) || !pel_vector_fit(up, b))
        return false;
    cross(a, b, product);
    return pel_reach_of(product) >= UINT32_C(1) << 30 &&
           pel_unit_exact(product, right);
}

enum pel_status pel_camera_basis(const struct pel_camera *camera,
                                 struct pel_matrix *basis)
{
    int64_t forward[3], down[3];
    if (!in_world(camera->eye) || !in_world(camera->target))
        return PEL_ERROR_RANGE;
    for (int k = 0; k < 3; k++)
        forward[k] = (int64_t)camera->target[k] - camera->eye[k];
    if (!across(forward, camera->up, basis->row[0]))
        return PEL_ERROR_RANGE;
    pel_unit_exact(forward, basis->row[2]);
    cross(basis->row[2], basis->row[0], down);
    pel_unit_exact(down, basis->row[1]);
    return PEL_OK;
}
