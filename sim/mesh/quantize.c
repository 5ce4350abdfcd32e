#include "sim/mesh/model.h"

#include <math.h>

#include "core/scene/mesh.h"

/* One less than what the numbers hold, for the rounding of the offset. */
#define NUMBERS_EACH_SIDE 32766
#define STEP_MAX 16384
#define OFFSET_MAX 1073741824.0

struct extent {
    double origin[3]; /* the middle, or the least */
    double half;      /* of the longest axis */
};

/* The largest shift for which step and offsets are legal: of the mesh's own
 * size it leaves at least 13 bits in the step, unless the mesh is far from the
 * origin. */
static bool fits(const struct extent *e, int shift, double *step)
{
    *step = fmax(ceil(ldexp(e->half / NUMBERS_EACH_SIDE, shift)), 1);
    bool legal = *step <= STEP_MAX;
    for (int k = 0; k < 3; k++)
        legal = legal && fabs(ldexp(e->origin[k], shift)) <= OFFSET_MAX;
    return legal;
}

static struct pel_quantization quantum_of(const struct extent *e, int shift)
{
    struct pel_quantization quantum;
    double step = 1;
    while (shift > -64 && !fits(e, shift, &step))
        shift--;
    for (int k = 0; k < 3; k++)
        quantum.offset[k] = (int32_t)lround(ldexp(e->origin[k], shift));
    quantum.step = (int32_t)step;
    quantum.shift = shift;
    return quantum;
}

struct pel_quantization quantize_positions(const struct mesh *mesh,
                                           int shift_max)
{
    struct extent e = {{0}, 0};
    double low[3], high[3];
    mesh_box(mesh, low, high);
    for (int k = 0; k < 3; k++) {
        e.half = fmax(e.half, (high[k] - low[k]) / 2);
        e.origin[k] = (low[k] + high[k]) / 2;
    }
    return quantum_of(&e, shift_max);
}

struct pel_quantization quantize_uv(const struct mesh *mesh)
{
    struct extent e = {{0}, 0};
    for (int k = 0; k < 2; k++) {
        double high = -INFINITY;
        e.origin[k] = INFINITY;
        for (uint32_t i = 0; i < mesh->vertices; i++) {
            e.origin[k] = fmin(e.origin[k], mesh->vertex[i].uv[k]);
            high = fmax(high, mesh->vertex[i].uv[k]);
        }
        e.half = fmax(e.half, (high - e.origin[k]) / 2);
    }
    return quantum_of(&e, PEL_MESH_SHIFT_MAX);
}

long quantize(const struct pel_quantization *quantum, int axis, double value)
{
    double numerator = ldexp(value, quantum->shift) - quantum->offset[axis];
    return lround(numerator / quantum->step);
}
