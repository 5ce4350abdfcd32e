#include "paint_radial.h"

#include "curve.h"
#include "fraction.h"
#include "square_root.h"

/* For a cubic that is right to 1/512 px, which is 2^-13 of the way or less when
 * the radius is at least 16 px; for smaller ones from the second on, which
 * gives 1/8,192 px. */
static const int32_t far[6] = {2581, 6502, 16384, 41286, 104032, 262144};

/* 64 r is the root of 4,096 r^2, below 2^61. dx / r = 64 dx inverse
 * 2^(shift - 62), where 64 |dx| 2^shift <= 2^31, and the slope is 2^14 times
 * that times the scale, which is at most 2^30. */
static void knot(const void *paint, struct pel_point way, struct pel_knot *k)
{
    const struct pel_radial *p = paint;
    uint64_t square =
        (uint64_t)((int64_t)way.x * way.x + (int64_t)way.y * way.y);
    struct pel_root r;
    pel_square_root(square * 4096, &r);
    int64_t cosine =
        ((int64_t)way.x * 64 * ((int64_t)1 << r.shift)) * (r.inverse >> 1) >>
        31;
    k->value = (uint64_t)r.root * p->scale + p->phase;
    k->slope = cosine * (int64_t)p->scale >> 16;
}

static void run(const void *paint, const struct pel_ramp_walk *walk, int32_t n,
                pel_color *colors)
{
    pel_ramp_run(&((const struct pel_radial *)paint)->ramp, walk, n, colors);
}

/* Distances along a row have no maximum inside a piece, so its ends tell
 * whether it reaches 1, up to the bound of t. */
static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_radial *p = (const void *)paint;
    const uint64_t one = UINT64_C(1) << p->bits;
    const struct pel_curve curve = {
        p,
        knot,
        run,
        p->far,
        {pel_pixel_center(x) - p->center.x, pel_pixel_center(y) - p->center.y},
        x,
        p->bits,
        one - (one >> 10),
    };
    pel_curve_colors(&curve, n, out);
}

enum pel_status pel_radial_init(struct pel_radial *paint,
                                const struct pel_rings *rings,
                                const struct pel_ramp *ramp)
{
    enum pel_status status = pel_ramp_check(ramp);
    if (!paint || !rings)
        return PEL_ERROR_NULL;
    if (status != PEL_OK)
        return status;
    if (!pel_points_legal(&rings->center, 1) || rings->radius < 256 ||
        rings->radius > PEL_PX(32767))
        return PEL_ERROR_RANGE;
    pel_color_paint_init(&paint->base, colors, pel_ramp_opaque(ramp));
    paint->ramp = *ramp;
    paint->center = rings->center;
    paint->far = far + (rings->radius < PEL_PX(16));
    paint->bits = 36;
    for (int32_t radius = rings->radius; radius > 1; radius >>= 1)
        paint->bits++;
    paint->scale =
        (uint32_t)pel_fraction_of(1, (int64_t)rings->radius * 64, paint->bits) +
        1;
    paint->phase = (uint64_t)rings->phase << (paint->bits - 16);
    paint->phase += UINT64_C(1) << (paint->bits - 32);
    return PEL_OK;
}
