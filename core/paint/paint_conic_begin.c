#include "paint_conic.h"
#include "../base/turn.h"
#include "curve_colors.h"

/* For a cubic that is right to 1/512 px and 1e-5 turns. */
static const int32_t far[5] = {4067, 8192, 20643, 52016, 131072};

#if PEL_FAST_64BIT

/* floor(across 2^38 / square), where that is below 2^27. */
static uint64_t bracket(uint32_t across, uint64_t square)
{
    return ((uint64_t)across << 38) / (square ? square : 1);
}

#else

/* Bit by bit, in less code and stack than the compiler's division: the rest is
 * below the square, which is below 2^51. */
static PEL_NOINLINE uint64_t bracket(uint32_t across, uint64_t square)
{
    uint64_t rest = (uint64_t)across << 11;
    uint32_t quotient = 0;
    for (int bit = 0; bit < 27; bit++) {
        rest <<= 1;
        quotient <<= 1;
        if (rest >= square) {
            rest -= square;
            quotient |= 1;
        }
    }
    return quotient;
}

#endif

/* The angle falls by dy / r^2 radians per sub-pixel to the right: per pixel and
 * in 2^-64 turns dy 2^8 2^64 / (2 pi r^2) = (dy 2^38 / r^2) 2^2 (2^32 / 2 pi).
 * |dy| < 2^25. At r >= 4067 the bracket is below 2^27, and the slope below
 * 2^58; nearer slopes are of no use and may overflow. */
static PEL_WALK int64_t slope_of(int32_t x, int32_t y)
{
    const uint64_t square = (uint64_t)(pel_square(x) + pel_square(y));
    const uint32_t across = (uint32_t)(y < 0 ? -y : y);
    const uint64_t fall = bracket(across, square) * PEL_TURNS_OF_RADIAN * 4;
    return (int64_t)(y > 0 ? 0 - fall : fall);
}

static PEL_HOT int64_t knot(const struct pel_curve *curve, int32_t x, int32_t y,
                            uint64_t *value)
{
    const uint32_t turn = pel_turn_of(x, y);
    *value = (uint64_t)(turn - PEL_CURVE_PAINT(struct pel_conic, curve)->start)
             << 32;
    return slope_of(x, y);
}

#if PEL_FAST_64BIT

static PEL_HOT struct pel_knot knot_of(const struct pel_curve *curve, int32_t x,
                                       int32_t y)
{
    struct pel_knot k;
    k.slope = knot(curve, x, y, &k.value);
    return k;
}

void pel_conic_colors(const struct pel_color_paint *paint, const void *context,
                      const struct pel_run *run, pel_color *colors)
{
    const struct pel_conic *p = (const void *)paint;
    struct pel_course course = pel_course_of(&p->curve, run);
    course.knot = knot_of;
    pel_course_colors(&course, context, colors);
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_conic *p = (const void *)paint;
    const struct pel_run run = {x, y, n};
    pel_conic_colors(paint, &p->curve, &run, out);
}

#else

static const struct pel_walker walker = {offsetof(struct pel_conic, curve),
                                         pel_curve_begin, pel_curve_follow};

#endif

enum pel_status pel_conic_begin(struct pel_conic *paint,
                                struct pel_point center, uint16_t start,
                                pel_curve_run *run)
{
    if (!paint)
        return PEL_ERROR_NULL;
    if (!pel_points_legal(&center, 1))
        return PEL_ERROR_RANGE;
#if PEL_FAST_64BIT
    pel_color_paint_init(&paint->base, colors, true);
#else
    pel_walker_paint_init(&paint->base, &walker, true);
#endif
    paint->start = (uint32_t)start << 16;
    paint->curve.center = center;
    paint->curve.far = far;
#if !PEL_FAST_64BIT
    paint->curve.knot = knot;
#endif
    paint->curve.run = run;
    paint->curve.bits = 64;
    paint->curve.limit = UINT64_MAX;
    paint->curve.outside = PEL_CURVE_NOWHERE;
    return PEL_OK;
}
