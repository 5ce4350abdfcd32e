#include "gradient.h"

const struct gradient_method gradient_methods[] = {
    {"8.8", 8, false},     {"16.16", 16, false}, {"16.16 saturated", 16, true},
    {"float32", 0, false}, {NULL, 0, false},
};

/* The nearest whole number to n / d. */
static int64_t rounded(int64_t n, int64_t d)
{
    if (d < 0) {
        n = -n;
        d = -d;
    }
    const int64_t twice = 2 * n + d;
    return twice / (2 * d) - (twice % (2 * d) < 0);
}

static int64_t saturated(int64_t v)
{
    return v < INT32_MIN ? INT32_MIN : v > INT32_MAX ? INT32_MAX : v;
}

/* Bounds: value differences below 2^8, coordinates below 2^20 in size, 256 and
 * 2^16 more for the fraction: below 2^54. */
void gradient_set(struct gradient *g, const struct gradient_method *m,
                  const struct pel_point v[3], const int32_t value[3])
{
    const int64_t bx = v[1].x - v[0].x, by = v[1].y - v[0].y;
    const int64_t cx = v[2].x - v[0].x, cy = v[2].y - v[0].y;
    const int64_t b = value[1] - value[0], c = value[2] - value[0];
    const int64_t area = bx * cy - cx * by, one = (int64_t)1 << m->bits;
    g->x = pel_pixel_of(v[0].x);
    g->y = pel_pixel_of(v[0].y);
    g->dx = rounded((b * cy - c * by) * 256 * one, area);
    g->dy = rounded((c * bx - b * cx) * 256 * one, area);
    if (m->saturates) {
        g->dx = saturated(g->dx);
        g->dy = saturated(g->dy);
    }
    const int64_t ox = pel_pixel_center(g->x) - v[0].x;
    const int64_t oy = pel_pixel_center(g->y) - v[0].y;
    const int64_t first = (b * cy - c * by) * ox + (c * bx - b * cx) * oy;
    g->at = value[0] * one + rounded(first * one, area);
    g->right = (float)((b * cy - c * by) * 256) / (float)area;
    g->down = (float)((c * bx - b * cx) * 256) / (float)area;
    g->base = (float)value[0] + (float)first / (float)area;
}

int32_t gradient_at(const struct gradient *g, const struct gradient_method *m,
                    int32_t x, int32_t y)
{
    const int64_t right = x - g->x, down = y - g->y;
    int64_t v;
    if (m->bits == 0) {
        const float f =
            g->base + (float)right * g->right + (float)down * g->down + 0.5f;
        v = f < 0 ? 0 : (int64_t)f;
    } else {
        v = g->at + right * g->dx + down * g->dy;
        v = (v + (1 << m->bits) / 2) >> m->bits;
    }
    return v < 0 ? 0 : v > 255 ? 255 : (int32_t)v;
}
