#include "camera.h"

/* Exact for vectors up to 2^30: below 2^61. */
static void cross(const int32_t a[3], const int32_t b[3], int64_t out[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        out[k] = pel_minor(a[i], b[j], a[j], b[i]);
    }
}

static bool in_world(pel_length v)
{
    const uint32_t limit = PEL_LENGTH_MAX;
    return (uint32_t)v + limit <= 2 * limit;
}

/* Of vectors that fit 30 bits as they are the product is exact; rounding others
 * moves it by less than 2^30. */
static bool across(const int64_t forward[3], const int64_t up[3],
                   pel_cosine right[3])
{
    int32_t a[3], b[3];
    int64_t product[3];
    if (!pel_vector_fit(forward, a) || !pel_vector_fit(up, b))
        return false;
    cross(a, b, product);
    return pel_vector_bound(product) >= UINT32_C(1) << 30 &&
           pel_normalize(product, right);
}

enum pel_status pel_camera_basis(const struct pel_camera *camera,
                                 struct pel_matrix *basis)
{
    int64_t forward[3], up[3];
    for (int k = 0; k < 3; k++) {
        if (!in_world(camera->eye[k]) || !in_world(camera->target[k]))
            return PEL_ERROR_RANGE;
        forward[k] = (int64_t)camera->target[k] - camera->eye[k];
        up[k] = camera->up[k];
    }
    if (!across(forward, up, basis->row[0]))
        return PEL_ERROR_RANGE;
    pel_normalize(forward, basis->row[2]);
    cross(basis->row[2], basis->row[0], up); /* down */
    pel_normalize(up, basis->row[1]);
    return PEL_OK;
}
