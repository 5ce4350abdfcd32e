/* An ellipse is a disc whose axes are scaled: where it is at a distance from
 * one axis is a root, times a ratio. */
#include "smooth_ellipse.h"

#include "../base/divide.h"
#include "../base/sqrt.h"
#include "round.h"

/* How far from one axis the ellipse is, by the distance from the other. */
struct axis {
    int32_t radius; /* of the distance, 1/256 px */
    int32_t most;   /* the other one, 2^-16 px */
    uint32_t ratio; /* of the other one to it, 2^-shift, from 2^31 on */
    int32_t shift;
};

/* Pieces are also seen in a picture of which it is the circle of radius 1
 * (bulge_of). */
struct ellipse {
    struct pel_smooth_oval oval; /* first */
    struct axis axis[2];         /* x by y; y by x */
    uint32_t inverse[2];         /* 2^24 / radius of x, of y */
    int32_t fine;                /* bits of a piece's size beyond 16 */
};

static void set_axis(struct axis *axis, int32_t radius, int32_t other)
{
    uint64_t n = (uint64_t)other;
    axis->radius = radius;
    axis->most = other * 256;
    axis->shift = 0;
    for (; n >> 31 < (uint64_t)radius; n <<= 1)
        axis->shift++;
    axis->ratio = pel_divide(n, (uint32_t)radius);
}

/* The square of the root that `root_at` takes, times 4^up; below 2^46 at
 * first.
 */
static uint64_t square_at(const struct axis *axis, int32_t distance, int *up)
{
    uint64_t n = (uint64_t)(pel_square(axis->radius) - pel_square(distance));
    for (*up = 0; n >> 60 == 0; n <<= 2)
        ++*up;
    return n;
}

/* 2^-16 px, at a distance in 1/256 px. Of 31 bits of the root and 32 of the
 * ratio an error of 2^-29 remains. */
static PEL_NOINLINE int32_t root_at(const struct axis *axis, int32_t distance)
{
    struct pel_root root;
    int up;
    if (pel_magnitude(distance) >= axis->radius)
        return 0;
    pel_square_root(square_at(axis, distance, &up), &root);
    const int shift = pel_min(axis->shift + up - 8, 63);
    const uint64_t at = pel_multiply(root.root, axis->ratio) >> shift;
    return pel_min((int32_t)at, axis->most);
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

static int32_t at(const struct pel_smooth_oval *oval, int32_t distance,
                  bool down)
{
    const struct ellipse *const e = (const void *)oval;
    return root_at(&e->axis[down], distance);
}

static PEL_NOINLINE void set_ellipse(struct ellipse *e, int32_t a, int32_t b)
{
    e->oval = (struct pel_smooth_oval){at, bulge_of};
    set_axis(&e->axis[0], b, a);
    set_axis(&e->axis[1], a, b);
    e->inverse[0] = pel_divide(UINT32_C(1) << 24, (uint32_t)a);
    e->inverse[1] = pel_divide(UINT32_C(1) << 24, (uint32_t)b);
    e->fine = 0;
    while (pel_min(a, b) >> (e->fine + 9) > 0)
        e->fine++;
}

static bool is_legal(const struct pel_ellipse_shape *shape)
{
    return pel_point_legal(shape->center) &&
           pel_radius_legal(shape->radius.x) &&
           pel_radius_legal(shape->radius.y);
}

void pel_smooth_ellipse(const struct pel_surface *surface,
                        const struct pel_ellipse_shape *shape,
                        const struct pel_paint *paint)
{
    const struct pel_point c = shape->center, r = shape->radius;
    const bool legal = is_legal(shape);
    struct ellipse e;
    struct pel_smooth_outline outline;
    struct pel_smooth_curve curve;
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&shape->center, 1, r.x | r.y));
    if (!legal || r.x == 0 || r.y == 0)
        return;
    set_ellipse(&e, r.x, r.y);
    pel_smooth_round_set(&outline, &curve, c, 0, r.y);
    curve.circle.of.oval = &e.oval;
    curve.circle.down = PEL_SMOOTH_OVAL;
    curve.circle.reach = r.x * 256;
    if (pel_smooth_round_begin(surface, &outline, paint))
        pel_smooth_outline_paint(&outline);
}
