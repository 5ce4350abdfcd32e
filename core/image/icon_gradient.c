/* Gradients of icons: places by steps from pixel to pixel, colours by stops. */
#include "../base/divide.h"
#include "../path/transform.h"
#include "icon_paint.h"

enum {
    ONE = 4096,  /* a whole way */
    FAR = 32767, /* places beyond are as this one: squares fit 32 bits */
    FAR_LINEAR = 1 << 30
};

static uint32_t root_of(uint32_t v)
{
    uint32_t root = 0;
    for (uint32_t bit = UINT32_C(1) << 30; bit > 0; bit >>= 2) {
        const bool over = v >= root + bit;
        v -= over ? root + bit : 0;
        root = (root >> 1) + (over ? bit : 0);
    }
    return root;
}

static int32_t cut(uint64_t v, int32_t most)
{
    const int64_t n = (int64_t)v >> 12;
    return n < -most ? -most : n > most ? most : (int32_t)n;
}

/* The place of a pixel, 0 to ONE, by the spread; -1 before the first stop, of
 * which there may be more at 0. */
static int32_t place_of(const struct pel_icon_paint *p, uint64_t u, uint64_t v)
{
    const struct pel_icon_gradient *const g = p->gradient;
    int32_t t = cut(u, g->radial ? FAR : FAR_LINEAR);
    if (g->radial) {
        const int32_t w = cut(v, FAR);
        const uint32_t square = (uint32_t)(t * t) + (uint32_t)(w * w);
        t = (int32_t)root_of(square) + (t * (int32_t)(g->focus >> 1) >> 15);
    }
    if (g->spread == PEL_ICON_REPEAT)
        return t & (ONE - 1);
    if (g->spread == PEL_ICON_REFLECT) {
        t &= 2 * ONE - 1;
        return pel_min(t, 2 * ONE - t);
    }
    return pel_max(-1, pel_min(t, ONE));
}

/* a and b by 256 - w and w, channel by channel, alpha too. */
static pel_color mixed(pel_color a, pel_color b, uint32_t w)
{
    const uint32_t mask = UINT32_C(0xFF00FF), half = UINT32_C(0x800080);
    const uint32_t low = (a & mask) * (256 - w) + (b & mask) * w + half;
    const uint32_t high =
        (a >> 8 & mask) * (256 - w) + (b >> 8 & mask) * w + half;
    return (low >> 8 & mask) | (high & ~mask);
}

static pel_color color_at(const struct pel_icon_paint *p, int32_t place)
{
    const struct pel_icon_stop *s = p->stop;
    const struct pel_icon_stop *const last = s + p->gradient->stops - 1;
    while (s < last && s[1].at <= place)
        s++;
    if (s == last || place <= s->at)
        return s->color;
    const uint32_t part = (uint32_t)(place - s->at);
    return mixed(s->color, s[1].color,
                 part * 256 / (uint32_t)(s[1].at - s->at));
}

static PEL_NOINLINE void begin_row(const struct pel_icon_paint *p,
                                   const struct pel_span *span, int32_t y)
{
    p->run->x = span->x0;
    p->run->end = span->x1;
    p->run->u = pel_plane_at(&p->u, span->x0, y);
    p->run->v = pel_plane_at(&p->v, span->x0, y);
}

/* Sets the colors of the next pixels: how many. */
static PEL_NOINLINE int32_t next_colors(const struct pel_icon_paint *p)
{
    struct pel_icon_run *const run = p->run;
    const int32_t most = pel_min(run->end - run->x, PEL_ICON_RUN);
    for (int32_t i = 0; i < most; i++) {
        run->colors[i] = color_at(p, place_of(p, run->u, run->v));
        run->u += p->u.dx;
        run->v += p->v.dx;
    }
    run->x += most;
    return most;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_icon_paint *const p = (const void *)paint;
    for (int32_t i = 0; i < spans->n; i++) {
        const int32_t y = spans->y + i * spans->step;
        int32_t n;
        begin_row(p, &spans->span[i], y);
        while ((n = next_colors(p)) > 0)
            pel_put_colors(spans->surface, p->run->x - n, y, n, p->run->colors);
    }
}

/* b / area in 2^-24 for each px, where |b| < 2^25 and area is in square
 * sub-pixels. */
static uint64_t step_of(int32_t b, int64_t area)
{
    int64_t rest = b * INT64_C(4294967296);
    return (uint64_t)pel_divide_64(&rest, area);
}

/* (p - from) x d / area of the centre of a pixel p, in steps of x and y. */
static void set_axis(struct pel_plane *axis, struct pel_point from,
                     struct pel_point d, int64_t area)
{
    axis->dx = step_of(d.y, area);
    axis->dy = step_of(-d.x, area);
    const uint64_t at =
        pel_times(axis->dx, 128 - from.x) + pel_times(axis->dy, 128 - from.y);
    axis->at = (uint64_t)((int64_t)at >> 8);
}

/* u is (p - from) x b / (a x b), v is (p - from) x a / (a x b), whose sign does
 * not matter: it is squared. */
static bool make(struct pel_icon_paint *paint,
                 const struct pel_icon_gradient *gradient,
                 const struct pel_icon_shape *shape)
{
    struct pel_point p[3];
    for (int i = 0; i < 3; i++)
        if (!pel_transform_point(&shape->transform, gradient->frame[i].x,
                                 gradient->frame[i].y, &p[i]))
            return false;
    struct pel_point a = {p[1].x - p[0].x, p[1].y - p[0].y};
    struct pel_point b = {p[2].x - p[0].x, p[2].y - p[0].y};
    int64_t area = pel_product(a.x, b.y) - pel_product(a.y, b.x);
    if (area < 0) { /* the other way around, which only turns v */
        b = (struct pel_point){-b.x, -b.y};
        area = -area;
    }
    area = area ? area : 1;
    paint->paint = (struct pel_paint)PEL_PAINT(fill, NULL);
    paint->gradient = gradient;
    paint->stop = &shape->icon->stop[gradient->stop];
    set_axis(&paint->u, p[0], b, area);
    set_axis(&paint->v, p[0], a, area);
    return true;
}

const struct pel_icon_gradients pel_icon_gradients = {make};
