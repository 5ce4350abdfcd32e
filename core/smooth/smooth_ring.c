#include "smooth_ring.h"

#include "round.h"

#if PEL_SMOOTH_TINY
struct hollow {
    struct pel_smooth_round disc; /* first */
    int32_t radius;
    uint32_t inverse;
};

/* The hole is a second curve. */
static bool curve_of(const struct pel_smooth_short_outline *outline, int32_t i,
                     struct pel_smooth_curve *curve)
{
    const struct hollow *const t = (const void *)outline;
    pel_smooth_round_curve(outline, i, curve);
    if (i > 0) {
        pel_smooth_circle_begin(&curve->circle, t->radius);
        curve->circle.of.inverse = t->inverse;
        curve->circle.hole = true;
    }
    return true;
}

static const struct pel_smooth_kind rings = {.curves = 2, .curve = curve_of};

static void set_hole(struct hollow *t, int32_t radius)
{
    t->radius = radius;
    t->inverse = pel_smooth_circle_inverse(radius);
}

static PEL_ALWAYS_INLINE void paint_ring(struct hollow *t)
{
    pel_smooth_short_outline_paint(&t->disc.outline, &rings);
}
#else
struct hollow {
    struct pel_smooth_round disc;
};

static void set_hole(struct hollow *t, int32_t radius)
{
    pel_smooth_round_cut(&t->disc, radius);
}

static inline void paint_ring(struct hollow *t)
{
    pel_smooth_outline_paint(&t->disc.outline);
}
#endif

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct hollow *t,
                                  const struct pel_ring_shape *ring)
{
    const bool legal = pel_point_legal(ring->center) &&
                       pel_radius_legal(ring->inner) &&
                       pel_radius_legal(ring->outer);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&ring->center, 1, ring->outer));
    if (!legal || ring->outer <= ring->inner)
        return false;
    t->disc.center = ring->center;
    t->disc.radius = ring->outer;
    t->disc.spread.x = t->disc.spread.y = 0;
    if (!pel_smooth_round_begin(&t->disc))
        return false;
    set_hole(t, ring->inner);
    return true;
}

void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *ring,
                     const struct pel_paint *paint)
{
    struct hollow t;
    t.disc.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&t, ring))
        paint_ring(&t);
}
