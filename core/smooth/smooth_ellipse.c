/* An ellipse is a disc whose axes are scaled: where it is at a distance from
 * one axis is a root, times a ratio. */
#include "smooth_ellipse.h"

#include "../base/divide.h"
#include "../base/sqrt.h"
#include "round.h"

/* Pieces are also seen in a picture of which it is the circle of radius 1
 * (bulge_of). Of what there are two of, the first belongs to x by y, which has
 * the radius y. */
struct ellipse {
    struct pel_smooth_oval oval; /* first */
    const struct pel_ellipse_shape *shape;
    uint32_t ratio[2];   /* of the other radius to it, 2^-shift, from 2^31 on */
    uint32_t inverse[2]; /* 2^24 / radius of x, of y */
    uint8_t shift[2];
    uint8_t fine; /* bits of a piece's size beyond 16 */
};

static void set_axis(struct ellipse *e, int i, int32_t radius, int32_t other)
{
    uint64_t n = (uint64_t)other;
    for (e->shift[i] = 0; n >> 31 < (uint64_t)radius; n <<= 1)
        e->shift[i]++;
    e->ratio[i] = pel_divide(n, (uint32_t)radius);
    e->inverse[i] = pel_divide(UINT32_C(1) << 24, (uint32_t)other);
}

/* The square of the root that `root_at` takes, times 4^up; below 2^46 at
 * first.
 */
static PEL_SMOOTH_APART uint64_t square_at(int32_t radius, int32_t distance,
                                           int *up)
{
    uint64_t n = (uint64_t)(pel_square(radius) - pel_square(distance));
    for (*up = 0; n >> 60 == 0; n <<= 2)
        ++*up;
    return n;
}

/* 2^-16 px, at a distance in 1/256 px. Of 31 bits of the root and 32 of the
 * ratio an error of 2^-29 remains. */
static int32_t root_at(const struct pel_smooth_oval *oval, int32_t distance,
                       bool down)
{
    const struct ellipse *const e = (const void *)oval;
    const struct pel_point *const r = &e->shape->radius;
    const int32_t radius = down ? r->x : r->y;
    struct pel_root root;
    int up;
    if (distance == 0 && !down)
        return r->x * 256;
    if (pel_magnitude(distance) >= radius)
        return 0;
    pel_square_root(square_at(radius, distance, &up), &root);
    const int shift = pel_min(e->shift[down] + up - 8, 63);
    const uint64_t at = pel_multiply(root.root, e->ratio[down]) >> shift;
    return pel_min((int32_t)at, (down ? r->y : r->x) * 256);
}

/* A length in the picture of the circle, in 2^-15 2^-fine: at most 2^15. */
static uint32_t size_of(const struct ellipse *e, int i, int32_t length)
{
    const uint64_t size = pel_multiply((uint32_t)length, e->inverse[i]);
    return (uint32_t)pel_min((int32_t)(size >> (17 - e->fine)), 32768);
}

/* A quarter of the square of a piece's chord there, in 2^-32 4^-fine. */
static uint32_t chord_of(const struct ellipse *e,
                         const struct pel_smooth_arc_piece *p)
{
    const uint32_t x = size_of(e, 0, p->u1 - p->u0);
    const uint32_t y = size_of(e, 1, p->v0 - p->v1);
    return x * x + y * y;
}

/* The cross product of a piece's ends, 2^-16 px^2. */
static uint32_t cross_of(const struct pel_smooth_arc_piece *p)
{
    const uint32_t du = (uint32_t)(p->u1 - p->u0);
    const uint32_t dv = (uint32_t)(p->v0 - p->v1);
    const uint32_t u = (uint32_t)(p->u0 >> 1) + (uint32_t)(p->u1 >> 1);
    const uint32_t v = (uint32_t)(p->v0 >> 1) + (uint32_t)(p->v1 >> 1);
    return (uint32_t)((pel_multiply(du, v) + pel_multiply(dv, u)) >> 16);
}

/* The area between a piece and its chord, 2^-15 px. In the picture of the
 * circle it is, with half of the chord q and the sine s of its angle,
 *     1/3 s q^2 (1 + 3/10 q^2 + 9/56 q^4 ..) / sqrt(1 - q^2)
 * (strip.c has the rest of the series as a cubic). s is the cross product
 * of both ends, and grows with the area. */
static uint32_t bulge_of(const struct pel_smooth_oval *oval,
                         const struct pel_smooth_arc_piece *p)
{
    const struct ellipse *const e = (const void *)oval;
    const uint32_t q = chord_of(e, p), k = (q >> 16) >> 2 * e->fine;
    const uint64_t product = pel_multiply(cross_of(p), q);
    const uint32_t area = (uint32_t)(product >> (33 + 2 * e->fine));
    uint32_t more = 15469 + (120567 * k >> 16);
    more = 55255 + (more * k >> 16);
    return (area + (area * (more * k >> 16) >> 16)) * 21845 >> 16;
}

static PEL_NOINLINE void set_ellipse(struct ellipse *e,
                                     const struct pel_ellipse_shape *shape)
{
    const int32_t a = shape->radius.x, b = shape->radius.y;
    e->oval = (struct pel_smooth_oval){root_at, bulge_of};
    e->shape = shape;
    set_axis(e, 0, b, a);
    set_axis(e, 1, a, b);
    e->fine = 0;
    while (pel_min(a, b) >> (e->fine + 9) > 0)
        e->fine++;
}

static bool is_legal(const struct pel_ellipse_shape *shape)
{
    const struct pel_point r = shape->radius;
    const bool legal = pel_point_legal(shape->center) &&
                       pel_radius_legal(r.x) && pel_radius_legal(r.y);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&shape->center, 1, r.x | r.y));
    return legal && r.x > 0 && r.y > 0;
}

/* As a circle of the upright radius that is stretched. */
static void set_curve(struct pel_smooth_curve *curve, const struct ellipse *e)
{
    pel_smooth_circle_begin(&curve->circle, e->shape->radius.y);
    curve->center = e->shape->center;
    curve->spread.x = curve->spread.y = 0;
    curve->circle.of.oval = &e->oval;
    curve->circle.down = PEL_SMOOTH_OVAL;
}

#if PEL_SMOOTH_TINY
struct oval {
    struct pel_smooth_short_outline outline; /* first */
    struct ellipse ellipse;
};

static bool curve_of(const struct pel_smooth_short_outline *outline, int32_t i,
                     struct pel_smooth_curve *curve)
{
    PEL_CAST(void, i);
    set_curve(curve, &((const struct oval *)(const void *)outline)->ellipse);
    return true;
}

static const struct pel_smooth_kind kind = {.curves = 1, .curve = curve_of};

static bool begin_oval(struct oval *o)
{
    struct pel_smooth_curve curve;
    set_curve(&curve, &o->ellipse);
    return pel_smooth_curve_begin(&o->outline, &curve,
                                  o->ellipse.shape->radius.x);
}

static PEL_ALWAYS_INLINE void paint_oval(struct oval *o)
{
    pel_smooth_short_outline_paint(&o->outline, &kind);
}
#else
struct oval {
    struct pel_smooth_outline outline;
    struct pel_smooth_curve curve;
    struct ellipse ellipse;
};

static bool begin_oval(struct oval *o)
{
    set_curve(&o->curve, &o->ellipse);
    return pel_smooth_curve_begin(&o->outline, &o->curve,
                                  o->ellipse.shape->radius.x);
}

static inline void paint_oval(struct oval *o)
{
    pel_smooth_outline_paint(&o->outline);
}
#endif

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct oval *o,
                                  const struct pel_ellipse_shape *shape)
{
    if (!is_legal(shape))
        return false;
    set_ellipse(&o->ellipse, shape);
    return begin_oval(o);
}

void pel_smooth_ellipse(const struct pel_surface *surface,
                        const struct pel_ellipse_shape *shape,
                        const struct pel_paint *paint)
{
    struct oval o;
    o.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&o, shape))
        paint_oval(&o);
}
