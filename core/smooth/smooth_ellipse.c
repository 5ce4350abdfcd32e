/* An ellipse is a disc whose axes are scaled: where it is at a distance from
 * one axis is a root, times a ratio. Its quarters in a row are strips as those
 * of discs (disc_side.h), whose areas add up in windows (window.h). */
#include "smooth_ellipse.h"

#include "../base/divide.h"
#include "../base/sqrt.h"
#include "window.h"

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
    struct pel_smooth smooth;
    struct pel_point center;
    struct axis x, y;    /* y by x; x by y */
    uint32_t inverse[2]; /* 2^24 / radius of x, of y */
    int32_t fine;        /* bits of a piece's size beyond 16 */
    int32_t row;         /* of what follows */
    int32_t v[2], at[2]; /* its ends below the centre, and x there */
};

/* What a quarter has in a row: from `near` to `far`, where x is at_near and
 * at_far, all 2^-16 px. */
struct quarter {
    int32_t near, far, at_near, at_far;
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

/* The square of the root that `other_at` takes, times 4^up; below 2^46 at
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
static PEL_NOINLINE int32_t other_at(const struct axis *axis, int32_t distance)
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

/* A piece from (u0, v0) to (u1, v1), u0 <= u1 and v0 >= v1. */
struct piece {
    int32_t u0, v0, u1, v1;
};

/* A length in the picture of the circle, in 2^-15 2^-fine: at most 2^15. */
static uint32_t size_of(const struct ellipse *e, int i, int32_t length)
{
    const uint64_t size = pel_multiply((uint32_t)length, e->inverse[i]);
    return (uint32_t)pel_min((int32_t)(size >> (17 - e->fine)), 32768);
}

/* A quarter of the square of a piece's chord there, in 2^-32 4^-fine. */
static uint32_t chord_of(const struct ellipse *e, const struct piece *p)
{
    const uint32_t x = size_of(e, 0, p->u1 - p->u0);
    const uint32_t y = size_of(e, 1, p->v0 - p->v1);
    return x * x + y * y;
}

/* The cross product of a piece's ends, 2^-16 px^2. */
static uint32_t cross_of(const struct piece *p)
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
 * (disc_side.c has the rest of the series as a cubic). s is the cross product
 * of both ends, and grows with the area. */
static PEL_NOINLINE uint32_t bulge_of(const struct ellipse *e,
                                      const struct piece *p)
{
    const uint32_t q = chord_of(e, p), k = (q >> 16) >> 2 * e->fine;
    const uint64_t product = pel_multiply(cross_of(p), q);
    const uint32_t area = (uint32_t)(product >> (33 + 2 * e->fine));
    uint32_t more = 15469 + (120567 * k >> 16);
    more = 55255 + (more * k >> 16);
    return (area + (area * (more * k >> 16) >> 16)) * 21845 >> 16;
}

/* The height of the ellipse at a column's boundary, in the strip. */
static int32_t height_at(const struct ellipse *e, const struct quarter *s,
                         int32_t u)
{
    return pel_max(s->near, pel_min(other_at(&e->x, u >> 8), s->far));
}

/* Moves a piece on to the next column, whose left boundary is u. */
static void next_piece(const struct ellipse *e, const struct quarter *s,
                       int64_t u, struct piece *p)
{
    const int32_t end =
        (int32_t)(u + 65536 < s->at_near ? u + 65536 : s->at_near);
    const int32_t from = u > s->at_far ? (int32_t)u : s->at_far;
    p->v0 = from == p->u1 ? p->v1 : height_at(e, s, from);
    p->u0 = from;
    p->u1 = pel_max(end, from);
    p->v1 = p->u1 == s->at_near ? s->near : height_at(e, s, p->u1);
}

/* What lies left of a quarter's side in columns that it crosses. */
static void find_areas(const struct ellipse *e, const struct quarter *s,
                       int32_t center, const struct pel_span *columns,
                       uint16_t *area)
{
    const uint32_t h = (uint32_t)(s->far - s->near) >> 1;
    struct piece p = {0, 0, s->at_far, s->far};
    for (int32_t x = columns->x0; x < columns->x1; x++) {
        const int64_t u = ((int64_t)x * 256 - center) * 256;
        next_piece(e, s, u, &p);
        const uint32_t width = (uint32_t)(p.u1 - p.u0) >> 1;
        const uint32_t sum = (uint32_t)(p.v0 - s->near + p.v1 - s->near) >> 1;
        const uint32_t full = (uint32_t)(p.u0 - u) >> 1;
        *area++ = (uint16_t)((full * h >> 15) + (width * sum >> 16) +
                             bulge_of(e, &p));
    }
}

/* The height of a row's top below the centre, 1/256 px. */
static int32_t height_of(const struct ellipse *e, int32_t y)
{
    const int32_t most = e->y.radius;
    return pel_max(-most, pel_min(y * 256 - e->center.y, most));
}

static void go_to(struct ellipse *e, int32_t y)
{
    for (int i = 0; i < 2; i++) {
        e->v[i] = height_of(e, y + i);
        e->at[i] =
            i == 0 && e->row == y - 1 ? e->at[1] : other_at(&e->y, e->v[i]);
    }
    e->row = y;
}

/* False: nothing of it is in the row. */
static bool find_quarter(const struct ellipse *e, bool below, struct quarter *s)
{
    const int32_t near = below ? e->v[0] : -e->v[1];
    s->near = pel_max(near, 0) * 256;
    s->far = (below ? e->v[1] : -e->v[0]) * 256;
    s->at_near = near > 0 ? e->at[!below] : e->y.most;
    s->at_far = pel_min(e->at[below], s->at_near);
    return s->near < s->far;
}

/* Adds the left side, mirrored, or the right side of a quarter. */
static void add_side(const struct ellipse *e, const struct quarter *s,
                     bool left, struct pel_smooth_window *w)
{
    uint16_t area[PEL_SMOOTH_COLUMNS];
    const int32_t center = left ? -e->center.x : e->center.x;
    struct pel_smooth_crossing c = {{pel_smooth_column(center, s->at_far),
                                     pel_smooth_column(center, s->at_near) + 1},
                                    (s->far - s->near) >> 1,
                                    left,
                                    left};
    if (!pel_smooth_window_find(w, &c))
        return;
    find_areas(e, s, center, &c.columns, area);
    pel_smooth_window_add(w, &c, area);
}

static PEL_NOINLINE int32_t paint_window(struct ellipse *e, int32_t x,
                                         int32_t end)
{
    struct pel_smooth_window w;
    pel_smooth_window_begin(&w, e->row, x, end);
    for (int i = 0; i < 4; i++) {
        struct quarter s;
        if (find_quarter(e, i / 2, &s))
            add_side(e, &s, i % 2 == 0, &w);
    }
    pel_smooth_window_paint(&w, &e->smooth);
    return w.next;
}

/* How far it reaches in the row, 2^-16 px. */
static int32_t reach_of(const struct ellipse *e)
{
    return e->v[0] < 0 && e->v[1] > 0 ? e->y.most : pel_max(e->at[0], e->at[1]);
}

static void paint_row(struct ellipse *e)
{
    const struct pel_rect *const clip = &e->smooth.target->clip;
    const int32_t reach = reach_of(e);
    const int32_t last = pel_smooth_column(e->center.x, reach);
    const int32_t end = pel_min(last + 1, clip->x1);
    int32_t x = pel_max(-1 - pel_smooth_column(-e->center.x, reach), clip->x0);
    while (x < end)
        x = paint_window(e, x, end);
}

static void set_ellipse(struct ellipse *e,
                        const struct pel_ellipse_shape *shape)
{
    const int32_t a = shape->radius.x, b = shape->radius.y;
    e->center = shape->center;
    set_axis(&e->x, a, b);
    set_axis(&e->y, b, a);
    e->inverse[0] = (UINT32_C(1) << 24) / (uint32_t)a;
    e->inverse[1] = (UINT32_C(1) << 24) / (uint32_t)b;
    e->row = INT32_MIN;
    e->fine = 0;
    while (pel_min(a, b) >> (e->fine + 9) > 0)
        e->fine++;
}

static void paint_rows(struct ellipse *e)
{
    const struct pel_rect *const clip = &e->smooth.target->clip;
    const int32_t top = pel_pixel_of(e->center.y - e->y.radius);
    const int32_t bottom = pel_pixel_of(e->center.y + e->y.radius + 255);
    const int32_t end = pel_min(bottom, clip->y1);
    for (int32_t y = pel_max(top, clip->y0); y < end; y++) {
        go_to(e, y);
        paint_row(e);
    }
}

/* Is all of it beside the clip, or above or below? */
static bool is_outside(const struct pel_ellipse_shape *shape,
                       const struct pel_rect *clip)
{
    const struct pel_point c = shape->center, r = shape->radius;
    return pel_pixel_of(c.x + r.x) < clip->x0 ||
           pel_pixel_of(c.x - r.x) >= clip->x1 ||
           pel_pixel_of(c.y + r.y) < clip->y0 ||
           pel_pixel_of(c.y - r.y) >= clip->y1;
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
    const bool legal = is_legal(shape);
    struct ellipse e;
    PEL_ASSERT(legal);
    PEL_HINT(
        pel_in_subpixels(&shape->center, 1, shape->radius.x | shape->radius.y));
    if (!legal || shape->radius.x == 0 || shape->radius.y == 0 ||
        is_outside(shape, &surface->clip) ||
        !pel_smooth_begin(&e.smooth, surface, paint))
        return;
    set_ellipse(&e, shape);
    paint_rows(&e);
}
