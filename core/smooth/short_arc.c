#include "smooth_arc.h"

#include "arc_parts.h"
#include "smooth_edge.h"

#if PEL_SMOOTH_TINY
/* Two circles, from one ray to the other; then half discs at both ends, or
 * lines. */
struct arc {
    struct pel_smooth_short_outline outline; /* first */
    const struct pel_point *center;
    int32_t radius[2];
    uint32_t inverse[2];
    struct pel_angles angles;
    struct {
        uint16_t x, y; /* the size of its direction */
    } ray[2];
    union {
        int64_t step[2];  /* of the lines, to the next row: px 2^-32 */
        uint32_t inverse; /* of the half discs */
    } of;
};

static bool is_up(const struct arc *a, bool last)
{
    return (last ? a->angles.to : a->angles.from) >> 15;
}

static struct pel_point direction_of(const struct arc *a, bool last)
{
    struct pel_point d = {a->ray[last].x, a->ray[last].y};
    const int32_t quadrant = (last ? a->angles.to : a->angles.from) >> 14;
    if (quadrant == 1 || quadrant == 2)
        d.x = -d.x;
    if (quadrant >= 2)
        d.y = -d.y;
    return d;
}

/* Rays by number: of the first angle, of the last one, and OPPOSITE of them. */
enum { LAST = 1, OPPOSITE = 2 };

static PEL_NOINLINE struct pel_smooth_place place_on(const struct arc *a,
                                                     int32_t ray,
                                                     int32_t radius)
{
    struct pel_point d = direction_of(a, ray & LAST);
    if (radius == 0) /* a sector's centre, without the products */
        return (struct pel_smooth_place){0, 0};
    if (ray & OPPOSITE)
        d = (struct pel_point){-d.x, -d.y};
    return pel_smooth_arc_place_at(d, radius);
}

/* The ray on which curve i begins, or ends: of half discs, 2 and 3, both sides
 * of their own. */
static int32_t ray_of(int32_t i, bool last)
{
    return i < 2 ? last : i == 2 ? LAST + OPPOSITE * last : OPPOSITE * !last;
}

static int32_t radius_of(const struct arc *a, int32_t i)
{
    return i < 2 ? a->radius[i] : (a->radius[0] - a->radius[1]) >> 1;
}

/* A coordinate of a place on a ray, off by FAR at most. */
enum { FAR = 520 };
static int32_t about(int32_t d, int32_t radius)
{
    return d * (radius >> 8) >> 7;
}

static int32_t height_of(const struct arc *a, bool last, int32_t radius)
{
    const int32_t y = about(a->ray[last].y, radius);
    return is_up(a, last) ? -y : y;
}

/* May the row have something between two heights? */
static PEL_NOINLINE bool is_near(const struct arc *a, int32_t from, int32_t to)
{
    const int32_t down = a->outline.seen.y * 256 - a->center->y;
    return down < pel_max(from, to) + FAR &&
           down + 256 > pel_min(from, to) - FAR;
}

/* .. of the half disc on a ray? */
static bool is_half_near(const struct arc *a, bool last)
{
    const int32_t r = radius_of(a, 2);
    const int32_t y = height_of(a, last, a->radius[1] + r);
    return is_near(a, y - r, y + r);
}

static struct pel_point half_of(const struct arc *a, int32_t ray)
{
    const struct pel_smooth_place m =
        place_on(a, ray, (a->radius[0] + a->radius[1]) >> 1);
    return pel_smooth_arc_half_center(a->center, m);
}

static void set_circle(const struct arc *a, int32_t i,
                       struct pel_smooth_curve *c)
{
    pel_smooth_circle_begin(&c->circle, a->radius[i]);
    c->circle.of.inverse = a->inverse[i];
    c->circle.hole = i == 1;
    c->center = *a->center;
    if (a->angles.from != a->angles.to)
        pel_smooth_arc_set_quarters(&c->circle, a->angles);
}

static void set_half(const struct arc *a, bool last, struct pel_smooth_curve *c)
{
    const uint16_t from =
        (uint16_t)(last ? a->angles.to : a->angles.from + 32768);
    const struct pel_angles angles = {from, (uint16_t)(from + 32768)};
    pel_smooth_circle_begin(&c->circle, radius_of(a, 2));
    c->circle.of.inverse = a->of.inverse;
    c->center = half_of(a, last);
    pel_smooth_arc_set_quarters(&c->circle, angles);
}

static bool curve(const struct pel_smooth_short_outline *outline, int32_t i,
                  struct pel_smooth_curve *c)
{
    const struct arc *const a = (const void *)outline;
    c->spread.x = c->spread.y = 0;
    if (i < 2)
        set_circle(a, i, c);
    else if (is_half_near(a, i == 2))
        set_half(a, i == 2, c);
    else
        return false;
    return true;
}

/* The place where curve i begins or ends; far from the strip any other that is
 * as far. */
static struct pel_smooth_place place_near(const struct arc *a, int32_t i,
                                          bool last,
                                          const struct pel_smooth_strip *s)
{
    const int32_t ray = ray_of(i, last), radius = radius_of(a, i);
    const int32_t v = about(a->ray[ray & LAST].y, radius) * 256;
    if (s->near - v > FAR * 256 || v - s->far > FAR * 256)
        return (struct pel_smooth_place){0, v};
    return place_on(a, ray, radius);
}

static bool cut(struct pel_smooth_short_outline *outline, int32_t i, int32_t k)
{
    struct pel_smooth_window *const w = &outline->of.window;
    const struct pel_smooth_circle *const circle = &w->curve.circle;
    struct pel_smooth_strip *const s = &w->crossing.strip;
    for (int32_t last = 0; last < 2; last++)
        if (k == (last ? circle->count - 1 : 0)) {
            const struct pel_smooth_place p =
                place_near((const void *)outline, i, last, s);
            pel_smooth_cut_at(s, &p, last == ((circle->first + k) & 1));
        }
    return pel_smooth_is_left(s);
}

static PEL_NOINLINE bool is_line_near(const struct arc *a, bool last)
{
    return is_near(a, height_of(a, last, a->radius[0]),
                   height_of(a, last, a->radius[1]));
}

static PEL_NOINLINE void set_end(struct pel_smooth_far_place *end,
                                 const struct pel_point *center,
                                 const struct pel_smooth_place *p)
{
    end->x = (int64_t)center->x * 256 + p->x;
    end->y = (int64_t)center->y * 256 + p->y;
}

/* The line at the end of a ray, from its upper end to the lower one. */
static bool find_line(const struct pel_smooth_short_outline *outline, int32_t i,
                      struct pel_smooth_crossing *c)
{
    const struct arc *const a = (const void *)outline;
    const bool last = i == 0;
    const int64_t *const step = &a->of.step[last];
    const int32_t y = outline->seen.y, lower = !is_up(a, last);
    struct pel_smooth_far_place end[2];
    if (!is_line_near(a, last))
        return false;
    c->rising = lower == last;
    for (int32_t k = 0; k < 2; k++) {
        const struct pel_smooth_place p = place_on(a, last, a->radius[k]);
        set_end(&end[k ^ lower], a->center, &p);
    }
    if (!pel_smooth_upright(c, y, end[0].y, end[1].y))
        return false;
    end[1].x = pel_smooth_line_at(end, step, y, true);
    end[0].x = pel_smooth_line_at(end, step, y, false);
    pel_smooth_line_cross(c, end[0].x < end[1].x ? end[0].x : end[1].x,
                          (int32_t)(end[1].x - end[0].x));
    const struct pel_span columns = pel_smooth_crossed(&c->strip, c->center);
    if (columns.x1 - columns.x0 > 1) /* its height is asked for between them */
        pel_smooth_slope_set(&c->strip.slope, (uint64_t)pel_size_of(*step));
    return true;
}

/* The upright side that closes what rounding leaves open between a half disc
 * and a circle: the gap is less than 4 sub-pixels above or below it. */
static bool find_joint(const struct pel_smooth_short_outline *outline,
                       int32_t i, struct pel_smooth_crossing *c)
{
    const struct arc *const a = (const void *)outline;
    const bool last = i & 1, inner = i >> 1;
    if (!is_half_near(a, last))
        return false;
    const struct pel_point half = half_of(a, last);
    const struct pel_smooth_place h =
        place_on(a, last + OPPOSITE * inner, radius_of(a, 2));
    c->left = false;
    c->center = half.x + (h.x >> 8);
    c->strip.at_near = c->strip.at_far = h.x & 255;
    const int64_t to = (int64_t)half.y * 256 + h.y;
    const int64_t y =
        (int64_t)a->center->y * 256 + place_on(a, last, a->radius[inner]).y;
    c->rising = (to < y) == (last != inner);
    return pel_smooth_upright(c, outline->seen.y, y < to ? y : to,
                              y < to ? to : y);
}

static const struct pel_smooth_kind whole = {.curves = 2, .curve = curve};
static const struct pel_smooth_kind butt = {2, 2, curve, cut, find_line};
static const struct pel_smooth_kind pie = {1, 2, curve, cut, find_line};
static const struct pel_smooth_kind rounded = {4, 4, curve, cut, find_joint};

static PEL_NOINLINE void set_rays(struct arc *a,
                                  const struct pel_smooth_kind *kind)
{
    const bool is_round = kind->curves > 2;
    const struct pel_point zero = {0, 0};
    struct pel_rise rise;
    for (int32_t last = 0; last < 2; last++) {
        const struct pel_point d =
            pel_direction(last ? a->angles.to : a->angles.from);
        const struct pel_point down = {d.y < 0 ? -d.x : d.x,
                                       pel_magnitude(d.y)};
        a->ray[last].x = (uint16_t)pel_magnitude(d.x);
        a->ray[last].y = (uint16_t)down.y;
        if (!is_round)
            a->of.step[last] = pel_smooth_slope(&zero, &down, &rise);
    }
    if (is_round)
        a->of.inverse = pel_smooth_circle_inverse(radius_of(a, 2));
}

/* A box of pixels around the ends of the rays and the axes between them, which
 * may be a little larger than the arc. */
static PEL_NOINLINE bool begin_box(struct arc *a,
                                   const struct pel_smooth_kind *kind)
{
    const int32_t more = FAR + (kind->curves > 2 ? radius_of(a, 2) : 0);
    struct pel_rect box = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    struct pel_smooth_curve c;
    set_circle(a, 0, &c);
    pel_smooth_arc_add_axes(&box, &c);
    for (int32_t k = 0; k < 4; k++) {
        const struct pel_point d = direction_of(a, k & 1);
        const int32_t radius = a->radius[k >> 1];
        pel_smooth_arc_widen(&box, c.center.x + about(d.x, radius),
                             c.center.y + about(d.y, radius));
    }
    box = pel_smooth_arc_pixels_of(&box, more);
    return pel_smooth_short_outline_begin(&a->outline, &box);
}

/* NULL: nothing is to be seen. */
static PEL_NOINLINE const struct pel_smooth_kind *begin(
    struct arc *a, const struct pel_arc_shape *arc,
    const struct pel_smooth_kind *kind)
{
    if (!pel_smooth_arc_is_legal(arc) || arc->outer <= arc->inner ||
        !pel_angles_set(&a->angles, arc->from, arc->to))
        return NULL;
    a->center = &arc->center;
    for (int32_t i = 0; i < 2; i++) {
        a->radius[i] = i ? arc->inner : arc->outer;
        a->inverse[i] = pel_smooth_circle_inverse(a->radius[i]);
    }
    if (a->angles.from == a->angles.to)
        kind = &whole;
    return kind;
}

static PEL_NOINLINE const struct pel_smooth_kind *begin_sector(
    struct arc *a, const struct pel_sector_shape *sector)
{
    const struct pel_arc_shape arc = {sector->center, 0, sector->radius,
                                      sector->from, sector->to};
    const struct pel_smooth_kind *const kind = begin(a, &arc, &pie);
    a->center = &sector->center;
    return kind;
}

static PEL_ALWAYS_INLINE void paint_arc(struct arc *a,
                                        const struct pel_smooth_kind *kind)
{
    if (!kind)
        return;
    set_rays(a, kind);
    if (begin_box(a, kind))
        pel_smooth_short_outline_paint(&a->outline, kind);
}

void pel_smooth_arc(const struct pel_surface *surface,
                    const struct pel_arc_shape *arc,
                    const struct pel_paint *paint)
{
    struct arc a;
    a.outline.smooth = (struct pel_smooth){surface, paint};
    paint_arc(&a, begin(&a, arc, &butt));
}

void pel_smooth_arc_round(const struct pel_surface *surface,
                          const struct pel_arc_shape *arc,
                          const struct pel_paint *paint)
{
    struct arc a;
    a.outline.smooth = (struct pel_smooth){surface, paint};
    paint_arc(&a, begin(&a, arc, &rounded));
}

void pel_smooth_sector(const struct pel_surface *surface,
                       const struct pel_sector_shape *sector,
                       const struct pel_paint *paint)
{
    struct arc a;
    a.outline.smooth = (struct pel_smooth){surface, paint};
    paint_arc(&a, begin_sector(&a, sector));
}
#endif
