#include "sim/asset/import.h"

#include <math.h>

/* One less than what the numbers hold, for the rounding of the offset. */
#define NUMBERS_EACH_SIDE 32766
#define STEP_MAX 16384
#define OFFSET_MAX 1073741824.0

struct extent {
    double origin[3]; /* the middle, or the least */
    double half;      /* of the longest axis */
};

static struct extent extent_of(const struct import_points *points)
{
    struct extent e = {{0}, 0};
    for (int k = 0; k < points->axes; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < points->count; i++) {
            double value = points->first[i * points->stride + (size_t)k];
            low = fmin(low, value);
            high = fmax(high, value);
        }
        e.half = fmax(e.half, (high - low) / 2);
        e.origin[k] = points->is_signed ? (low + high) / 2 : low;
    }
    return e;
}

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

struct pel_mesh_quantum import_quantum(const struct import_points *points)
{
    struct pel_mesh_quantum quantum;
    struct extent e = extent_of(points);
    double step = 1;
    int shift = points->shift_max;
    while (shift > -64 && !fits(&e, shift, &step))
        shift--;
    for (int k = 0; k < 3; k++)
        quantum.offset[k] = (int32_t)lround(ldexp(e.origin[k], shift));
    quantum.step = (int32_t)step;
    quantum.shift = shift;
    return quantum;
}

long import_quantised(const struct pel_mesh_quantum *quantum, int axis,
                      double value)
{
    double numerator = ldexp(value, quantum->shift) - quantum->offset[axis];
    return lround(numerator / quantum->step);
}
