#include "paint_fan.h"

#include "../format/vector.h"

/* Positive when b lies clockwise of a; below 2^51. */
static PEL_NOINLINE_32 int64_t cross(const struct pel_point *a,
                                     const struct pel_point *b)
{
    return pel_product(a->x, b->y) - pel_product(a->y, b->x);
}

/* n pixels of a span, from (x, y) on; `at` is a channel there. */
struct part {
    uint64_t at;
    int32_t x, y, n;
    pel_color start; /* before its channels: the alpha of opaque fans */
};

/* pel_plane_at, before add_channel and not in it, to spare stack. */
static PEL_NOINLINE_32 void set_channel(struct part *r,
                                        const struct pel_plane *channel)
{
    r->at = channel->at;
    r->at += pel_times(channel->dx, r->x);
    r->at += pel_times(channel->dy, r->y);
}

#if PEL_VECTORS

/* Four channels, two a vector, and what they grow by. */
struct lanes {
    pel_u64x2 at[2], step[2];
};

static inline void set_lanes(struct lanes *lanes, struct part *r,
                             const struct pel_fan_triangle *t)
{
    for (int k = 0; k < 2; k++) {
        const struct pel_plane *channel = &t->channel[2 * k];
        set_channel(r, &channel[0]);
        const uint64_t first = r->at;
        set_channel(r, &channel[1]);
        lanes->at[k] = (pel_u64x2){first, r->at};
        lanes->step[k] = (pel_u64x2){channel[0].dx, channel[1].dx};
    }
}

static inline uint32_t next_color(struct lanes *lanes)
{
    const pel_u32x4 low = (pel_u32x4)lanes->at[0];
    const pel_u32x4 high = (pel_u32x4)lanes->at[1];
    lanes->at[0] += lanes->step[0];
    lanes->at[1] += lanes->step[1];
    return pel_clamp_u8(PEL_LANES(low, high, 1, 3, 5, 7));
}

/* The colors of a part inside one triangle. */
static void triangle_colors(struct part *r, const struct pel_fan_triangle *t,
                            pel_color *out)
{
    struct lanes lanes;
    set_lanes(&lanes, r, t);
    for (pel_color *const end = out + r->n; out < end; out++)
        *out = r->start | next_color(&lanes);
}

#else

/* Adds channel k to the colors of a part inside one triangle; channel 0 comes
 * first and overwrites them. */
static PEL_NOINLINE_32 void add_channel(const struct part *r,
                                        const struct pel_fan_triangle *t, int k,
                                        pel_color *out)
{
    const uint64_t step = t->channel[k].dx;
    uint64_t v = r->at;
    for (int32_t i = 0; k == 0 && i < r->n; i++)
        out[i] = r->start;
    for (pel_color *const end = out + r->n; out < end; out++, v += step) {
        uint32_t whole = (uint32_t)(v >> 32);
        if (whole > 255)
            whole = (int32_t)whole < 0 ? 0 : 255;
        *out |= whole << 8 * k;
    }
}

static void triangle_colors(struct part *r, const struct pel_fan_triangle *t,
                            pel_color *out)
{
    for (int k = 0; k < (r->start ? 3 : 4); k++) {
        set_channel(r, &t->channel[k]);
        add_channel(r, t, k, out);
    }
}

#endif

/* For how many of n pixels, the first at d from the hub, the cross product with
 * a ray is at least `least`: one pixel to the right it changes by -256 times
 * the ray's y. */
static PEL_NOINLINE_32 int32_t pixels_beside(const struct pel_point *ray,
                                             const struct pel_point *d,
                                             int32_t least, int32_t n)
{
    int64_t side =
        pel_product(ray->x, d->y) - pel_product(ray->y, d->x) - least;
    const int64_t step = (int64_t)ray->y * 256;
    int32_t count = 0;
    if ((PEL_64BIT || !PEL_SMALL_CODE) && side >= 0 &&
        side >= pel_product(ray->y, 256 * (n - 1)))
        return n;
    if (PEL_64BIT && side >= 0 && n > 0)
        return (int32_t)(side / step) + 1;
    for (; count < n && side >= 0; count++)
        side -= step;
    return count;
}

/* Sets *i to the triangle of the first pixel, searched from *i on; returns how
 * many pixels stay in it, 0 when there is none. */
static int32_t find_triangle(const struct pel_fan *p, const struct part *r,
                             int32_t *i)
{
    const struct pel_point d = {pel_pixel_center(r->x) - p->hub.x,
                                pel_pixel_center(r->y) - p->hub.y};
    for (int32_t tries = p->n; tries > 0; tries--) {
        const struct pel_fan_triangle *const t = &p->triangles[*i];
        int32_t count = pixels_beside(&t->from, &d, 0, r->n);
        count = pixels_beside(&t->past, &d, 1 - t->closed, count);
        if (count > 0)
            return count;
        *i = *i + 1 < p->n ? *i + 1 : 0;
    }
    return 0;
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_fan *p = (const void *)paint;
    const int32_t end = x + n;
    struct part r = {0, x, y, n, p->base.opaque ? UINT32_C(0xFF000000) : 0};
    int32_t triangle = 0;
    for (; (r.n = end - r.x) > 0; r.x += r.n) {
        r.n = find_triangle(p, &r, &triangle);
        if (r.n > 0) {
            triangle_colors(&r, &p->triangles[triangle], out);
        } else {
            *out = p->hub_color;
            r.n = 1;
        }
        out += r.n;
    }
}

/* From the hub to the i-th point, clockwise, 0 <= i < 2 n; the n-th is the 0-th
 * again. Sets *color to its color. */
static struct pel_point ray_of(const struct pel_fan_points *points, int turn,
                               int32_t i, pel_color *color)
{
    i = i < points->n ? i : i - points->n;
    i = turn > 0 ? i : points->n - 1 - i;
    *color = points->colors[i];
    return (struct pel_point){points->perimeter[i].x - points->hub.x,
                              points->perimeter[i].y - points->hub.y};
}

static bool is_zero(const struct pel_point *ray)
{
    return ray->x == 0 && ray->y == 0;
}

/* True for a ray in the second half of the turn, [1/2, 1). */
static bool is_late(const struct pel_point *ray)
{
    return ray->y < 0 || (ray->y == 0 && ray->x < 0);
}

/* The direction of the perimeter around the hub: 1 clockwise, -1
 * counter-clockwise, 0 when it turns back or goes around more than once. Each
 * time around it leaves the second half of the turn once. Over points on the
 * hub the way from ray to ray may be any part of a turn: one that seems to turn
 * back, and stays in its half, has gone around. */
static int turn_of_perimeter(const struct pel_fan_points *points)
{
    int turn = 0, rounds = 0, around[2] = {0, 0};
    pel_color color;
    struct pel_point a = {0, 0};
    bool skipped = false;
    for (int32_t i = 0, end = points->n; i <= end; i++) {
        const struct pel_point b = ray_of(points, 1, i, &color);
        if (is_zero(&b)) {
            skipped = true;
            continue;
        }
        const int64_t c = cross(&a, &b);
        if (is_zero(&a))
            end += i;
        else if (c != 0 && !skipped && turn == (c > 0 ? -1 : 1))
            return 0;
        else if (c != 0 && !skipped)
            turn = c > 0 ? 1 : -1;
        else if (c != 0 && is_late(&a) == is_late(&b))
            around[c > 0]++;
        rounds += is_late(&a) && !is_late(&b);
        skipped = false;
        a = b;
    }
    return rounds + around[turn < 0] > 1 ? 0 : turn;
}

/* True when no triangle begins on the ray of the i-th point: the next point in
 * another direction is not clockwise of it. */
static bool is_last_ray(const struct pel_fan_points *points, int turn,
                        int32_t i)
{
    pel_color color;
    const struct pel_point ray = ray_of(points, turn, i, &color);
    for (int32_t k = 1; k < points->n; k++) {
        const struct pel_point next = ray_of(points, turn, i + k, &color);
        int64_t dot = (int64_t)ray.x * next.x + (int64_t)ray.y * next.y;
        if (cross(&ray, &next) != 0 || dot <= 0)
            return cross(&ray, &next) == 0;
    }
    return true;
}

static void set_triangle(struct pel_fan_triangle *t, const struct pel_fan *p,
                         const struct pel_fan_points *points, int turn,
                         int32_t i)
{
    pel_color a, b;
    t->from = ray_of(points, turn, i, &a);
    const struct pel_point to = ray_of(points, turn, i + 1, &b);
    t->past = (struct pel_point){-to.x, -to.y};
    t->closed = is_last_ray(points, turn, i + 1 < points->n ? i + 1 : 0);
    const struct pel_point v[3] = {{0, 0}, t->from, to};
    struct pel_plane_setup setup;
    if (!pel_plane_start(&setup, v))
        t->past.x = t->past.y = t->closed = 0;
    setup.a = p->hub;
    setup.first = 0;
    for (int k = 0; k < 4; k++) {
        const int32_t value[3] = {(int32_t)(p->hub_color >> 8 * k & 255) * 256,
                                  (int32_t)(a >> 8 * k & 255) * 256,
                                  (int32_t)(b >> 8 * k & 255) * 256};
        pel_plane_set(&t->channel[k], &setup, value);
        t->channel[k].at += 0x80000000u;
    }
}

enum pel_status pel_fan_init(struct pel_fan *paint,
                             const struct pel_fan_points *points,
                             struct pel_fan_triangle *memory)
{
    if (paint)
        pel_paint_clear(&paint->base.paint);
    if (!paint || !points || !points->perimeter || !points->colors || !memory)
        return PEL_ERROR_NULL;
    if (points->n < 3 || points->n > 32767)
        return PEL_ERROR_SIZE;
    if (!pel_points_legal(points->perimeter, points->n) ||
        !pel_point_legal(points->hub))
        return PEL_ERROR_RANGE;
    const int turn = turn_of_perimeter(points);
    if (turn == 0)
        return PEL_ERROR_RANGE;
    pel_color all = points->hub_color;
    for (int32_t i = 0; i < points->n; i++)
        all &= points->colors[i];
    pel_color_paint_init(&paint->base, colors, pel_alpha(all) == 255);
    paint->hub = points->hub;
    paint->hub_color = points->hub_color;
    paint->triangles = memory;
    paint->n = points->n;
    for (int32_t i = 0; i < points->n; i++)
        set_triangle(&memory[i], paint, points, turn, i);
    return PEL_OK;
}
