#include "paint_linear.h"

#include "../base/fraction.h"
#include "ramp_vector.h"

/* Begins a walk of n pixels at (x, y). */
static void begin_walk(const struct pel_linear *p, struct pel_point pixel,
                       int32_t n, struct pel_ramp_walk *w)
{
    w->at = p->at + pel_times(p->dx, pixel.x) + pel_times(p->dy, pixel.y);
    w->d1 = p->dx;
    w->d2 = 0;
    w->d3 = 0;
    w->bits = p->bits;
    const uint64_t last = w->at + pel_times(p->dx, n - 1);
    w->inside = (w->at | last) >> p->bits == 0;
    /* Both ends on one side of the way: one colour of a padded ramp. */
    if (p->ramp.spread == PEL_PAD && w->at >> p->bits != 0 &&
        last >> p->bits != 0 && (int64_t)(w->at ^ last) >= 0)
        w->d1 = 0;
}

#if PEL_FAST_64BIT

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_linear *p = (const void *)paint;
    const struct pel_point pixel = {x, y};
    struct pel_ramp_mixer mixer;
    struct pel_ramp_walk w;
    begin_walk(p, pixel, n, &w);
    w.n = n;
    pel_ramp_prepare(&mixer, &p->ramp);
    pel_ramp_run(&mixer, &w, out);
}

#else

static void begin(const void *paint, struct pel_strip *s)
{
    const struct pel_point pixel = {s->x, s->y};
    begin_walk(paint, pixel, s->walk.n, &s->walk);
}

static void run(const void *paint, struct pel_ramp_walk *walk, int32_t n,
                pel_color *colors)
{
    pel_ramp_run(&((const struct pel_linear *)paint)->ramp, walk, n, colors);
}

static const struct pel_walker walker = {0, begin, run};

#endif

/* With 2^e <= the longer of |dx|, |dy|, the way is at least 2^e sub-pixels
 * long, and no pixel is farther than 2^25.6 sub-pixels from `from`: |t| < 2^(26
 * - e), which leaves 36 + e bits for the fraction. The gradients lose up to one
 * unit of these bits a pixel, 2^17 on the longest way from the anchor, the
 * pixel of `from`, and a walk looks at 32 bits; so much is added that a
 * position never falls below a cell's beginning that it lies on. */
static void set_plane(struct pel_linear *p, struct pel_point from, int32_t dx,
                      int32_t dy)
{
    const int32_t x = pel_pixel_of(from.x), y = pel_pixel_of(from.y);
    const int64_t square = (int64_t)dx * dx + (int64_t)dy * dy;
    int32_t longer = pel_max(dx < 0 ? -dx : dx, dy < 0 ? -dy : dy);
    p->bits = 36;
    for (; longer > 1; longer >>= 1)
        p->bits++;
    p->dx = pel_fraction_of((int64_t)dx * 256, square, p->bits);
    p->dy = pel_fraction_of((int64_t)dy * 256, square, p->bits);
    p->at = pel_fraction_of((int64_t)dx * (pel_pixel_center(x) - from.x) +
                                (int64_t)dy * (pel_pixel_center(y) - from.y),
                            square, p->bits);
    p->at += 131072 + (UINT64_C(1) << (p->bits - 32)) -
             (uint64_t)(int64_t)x * p->dx - (uint64_t)(int64_t)y * p->dy;
}

enum pel_status pel_linear_init(struct pel_linear *paint, struct pel_point from,
                                struct pel_point to,
                                const struct pel_ramp *ramp)
{
    enum pel_status status = pel_ramp_check(ramp);
    if (!paint)
        return PEL_ERROR_NULL;
    if (status != PEL_OK)
        return status;
    if (!pel_point_legal(from) || !pel_point_legal(to))
        return PEL_ERROR_RANGE;
    if (from.x == to.x && from.y == to.y)
        return PEL_ERROR_SIZE;
#if PEL_FAST_64BIT
    pel_color_paint_init(&paint->base, colors, pel_ramp_opaque(ramp));
#else
    pel_walker_paint_init(&paint->base, &walker, pel_ramp_opaque(ramp));
#endif
    paint->ramp = *ramp;
    set_plane(paint, from, to.x - from.x, to.y - from.y);
    return PEL_OK;
}
