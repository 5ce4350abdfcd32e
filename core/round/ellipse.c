#include "ellipse.h"

#include "../raster/collect.h"
#include "ellipse_walk.h"

/* Adds n; both remainders are below b2. */
static void add(struct pel_quotient *v, const struct pel_quotient *n,
                int64_t b2)
{
    const bool carry = v->r + n->r >= b2;
    v->q += n->q + carry;
    v->r += n->r - (carry ? b2 : 0);
}

/* product = v n for n >= 0, by doubling and adding from the highest bit of n
 * down: no wider products, no division. */
static void multiply(struct pel_quotient *product, const struct pel_quotient *v,
                     int64_t n, int64_t b2)
{
    product->q = product->r = 0;
    for (int bit = pel_bits_of((uint64_t)n) - 1; bit >= 0; bit--) {
        add(product, product, b2);
        if (n >> bit & 1)
            add(product, v, b2);
    }
}

/* Sets the quotients for the row at distance v. */
static void row_start(struct pel_ellipse_walk *w, struct pel_point radius,
                      int32_t v)
{
    const int64_t a2 = pel_square(radius.x), b2 = pel_square(radius.y);
    const struct pel_quotient zero = {0, 0}, unit = {b2 == 1, b2 != 1};
    struct pel_quotient ratio;
    w->half_width2 = (struct pel_quotient){a2, 0};
    w->delta = w->delta2 = zero;
    if (b2 == 0)
        return;
    multiply(&ratio, &unit, a2, b2);
    multiply(&w->half_width2, &ratio, b2 - pel_square(v), b2);
    if (radius.y < 128)
        return;
    const int64_t step = (int64_t)v * 512 + 65536; /* (v + 256)^2 - v^2 */
    if (step < 0)
        multiply(&w->delta, &ratio, -step, b2);
    ratio.q = -ratio.q - (ratio.r != 0);
    ratio.r = ratio.r ? b2 - ratio.r : 0;
    if (step > 0)
        multiply(&w->delta, &ratio, step, b2);
    multiply(&w->delta2, &ratio, 131072, b2);
}

bool pel_ellipse_start(struct pel_ellipse_walk *w,
                       const struct pel_ellipse_shape *e,
                       const struct pel_rect *clip)
{
    const struct pel_point center = e->center, radius = e->radius;
    bool legal = pel_points_legal(&center, 1) && pel_radius_legal(radius.x) &&
                 pel_radius_legal(radius.y);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){center, radius}, 2, 0));
    if (!legal)
        return false;
    const struct pel_rect visible = pel_rect_around(center, radius, clip);
    if (pel_rect_empty(&visible))
        return false;
    w->y = visible.y0;
    w->end = visible.y1;
    row_start(w, radius, pel_pixel_center(w->y) - center.y);
    pel_disc_center(&w->disc, center.x, center.x);
    pel_disc_start(&w->disc, clip, w->half_width2.q);
    return true;
}

void pel_ellipse_next(struct pel_ellipse_walk *w,
                      const struct pel_ellipse_shape *e)
{
    const int64_t half_width2 = w->half_width2.q, b2 = pel_square(e->radius.y);
    add(&w->half_width2, &w->delta, b2);
    add(&w->delta, &w->delta2, b2);
    pel_disc_change(&w->disc, half_width2, w->half_width2.q);
    w->y++;
}

void pel_ellipse(const struct pel_surface *surface,
                 const struct pel_ellipse_shape *ellipse,
                 const struct pel_paint *paint)
{
    struct pel_ellipse_walk w;
    struct pel_collector c;
    if (!pel_ellipse_start(&w, ellipse, &surface->clip))
        return;
    pel_collect_begin(&c, surface, paint);
    for (; w.y < w.end; pel_ellipse_next(&w, ellipse)) {
        struct pel_span span;
        pel_disc_row(&w.disc, &surface->clip, &span);
        if (span.x0 < span.x1)
            pel_collect(&c, w.y, span.x0, span.x1);
    }
    pel_collect_end(&c);
}
