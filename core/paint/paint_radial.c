#include "paint_radial.h"

#include "../base/fraction.h"
#include "../base/root.h"
#include "curve_colors.h"
#include "patch.h"
#include "ramp_vector.h"

/* For a cubic that is right to 1/512 px, which is 2^-13 of the way or less when
 * the radius is at least 16 px; for smaller ones from the second on, which
 * gives 1/8,192 px. */
static const int32_t far[6] = {2581, 6502, 16384, 41286, 104032, 262144};

/* 64 r is the root of 4,096 r^2, below 2^61. dx / r = 64 dx inverse
 * 2^(shift - 62), where 64 |dx| 2^shift <= 2^31, and the slope is 2^14 times
 * that times the scale, which is at most 2^30. */
static PEL_WALK int64_t slope_of(const struct pel_root *r, int32_t x,
                                 uint32_t scale)
{
    const uint64_t way = (uint64_t)(int64_t)x << (6 + r->shift);
    const int64_t cosine =
        (int64_t)pel_times(way, (int32_t)(r->inverse >> 1)) >> 31;
    return (int64_t)pel_times((uint64_t)cosine, (int32_t)scale) >> 16;
}

static PEL_WIDE uint64_t square_of(int32_t x, int32_t y)
{
    return (uint64_t)(pel_square(x) + pel_square(y)) * 4096;
}

#if PEL_FAST_64BIT

static PEL_HOT struct pel_knot knot_of(const struct pel_curve *curve, int32_t x,
                                       int32_t y)
{
    const struct pel_radial *p = PEL_CURVE_PAINT(struct pel_radial, curve);
    const struct pel_root r = pel_root_of(square_of(x, y));
    return (struct pel_knot){(uint64_t)r.root * p->scale + p->phase,
                             slope_of(&r, x, p->scale)};
}

static void run_colors(const struct pel_color_paint *paint, const void *mixer,
                       const struct pel_run *run, pel_color *out)
{
    const struct pel_radial *p = (const void *)paint;
    struct pel_course course = pel_course_of(&p->curve, run);
    course.knot = knot_of;
    pel_course_colors(&course, mixer, out);
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_radial *p = (const void *)paint;
    const struct pel_run run = {x, y, n};
    struct pel_ramp_mixer mixer;
    pel_ramp_prepare(&mixer, &p->ramp);
    run_colors(paint, &mixer, &run, out);
}

#if PEL_PATCHES

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_radial *p = (const void *)paint;
    const struct pel_patchwork work = {&p->base,          &p->curve,  &p->ramp,
                                       pel_radial_taylor, run_colors, true};
    pel_patch_fill(&work, spans);
}

#endif

#else

static int64_t knot(const struct pel_curve *curve, int32_t x, int32_t y,
                    uint64_t *value)
{
    const struct pel_radial *p = PEL_CURVE_PAINT(struct pel_radial, curve);
    struct pel_root r;
    *value = square_of(x, y);
    pel_root_guess(*value, &r); /* pel_square_root() would keep a copy */
    pel_root_settle(*value, &r);
    *value = pel_multiply(r.root, p->scale) + p->phase;
    return slope_of(&r, x, p->scale);
}

static void run(const struct pel_curve *curve, struct pel_ramp_walk *walk,
                int32_t n, pel_color *colors)
{
    pel_ramp_run(&PEL_CURVE_PAINT(struct pel_radial, curve)->ramp, walk, n,
                 colors);
}

static const struct pel_walker walker = {offsetof(struct pel_radial, curve),
                                         pel_curve_begin, pel_curve_follow};

#endif

/* One pixel farther than where a padded ramp ends: the errors are less than a
 * sub-pixel. */
static int32_t outside_of(const struct pel_rings *rings, enum pel_spread spread)
{
    const int64_t way = (int64_t)rings->radius * (65536 - rings->phase);
    return spread == PEL_PAD ? (int32_t)(way / 65536) + 257 : PEL_CURVE_NOWHERE;
}

/* Distances along a row have no maximum inside a piece, so its ends tell
 * whether it reaches 1, up to the bound of t: hence the limit. A little is
 * added to the phase, because a walk looks at 32 bits: so a position does not
 * fall below a cell's beginning that it lies on. */
static void set_curve(struct pel_radial *p, const struct pel_rings *rings)
{
    uint8_t bits = 36;
    for (int32_t radius = rings->radius; radius > 1; radius >>= 1)
        bits++;
    p->scale =
        (uint32_t)pel_fraction_of(1, (int64_t)rings->radius * 64, bits) + 1;
    p->phase = (uint64_t)rings->phase << (bits - 16);
    p->phase += UINT64_C(1) << (bits - 32);
    p->curve.center = rings->center;
    p->curve.far = far + (rings->radius < PEL_PX(16));
#if PEL_FAST_64BIT
    p->curve.run = pel_ramp_run;
#else
    p->curve.knot = knot;
    p->curve.run = run;
#endif
    p->curve.bits = bits;
    p->curve.limit = (UINT64_C(1) << bits) - (UINT64_C(1) << (bits - 10));
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
#if PEL_FAST_64BIT
    pel_color_paint_init(&paint->base, colors, pel_ramp_opaque(ramp));
#else
    pel_walker_paint_init(&paint->base, &walker, pel_ramp_opaque(ramp));
#endif
#if PEL_PATCHES
    paint->base.paint.fill = fill;
#endif
    paint->ramp = *ramp;
    set_curve(paint, rings);
    paint->curve.outside = outside_of(rings, ramp->spread);
    return PEL_OK;
}
