#define _DEFAULT_SOURCE
#include "smooth.h"

#include <math.h>

static double clamped(double v, double low, double high)
{
    return fmin(fmax(v, low), high);
}

/* How far a point lies inside, px: from the nearest side's line, or from the
 * circle. */
static double depth_at(const struct smooth_shape *s, double x, double y)
{
    double depth = INFINITY;
    if (s->is_disc)
        return s->radius - hypot(x - s->x[0], y - s->y[0]);
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        const double dx = s->x[next] - s->x[k], dy = s->y[next] - s->y[k];
        const double cross = dx * (y - s->y[k]) - dy * (x - s->x[k]);
        depth = fmin(depth, cross / hypot(dx, dy));
    }
    return depth;
}

/* As if every side ran along the pixel's own. */
static double ramp(const struct smooth_shape *s, int n, int x, int y)
{
    (void)n;
    return clamped(depth_at(s, x + .5, y + .5) + .5, 0, 1);
}

static double samples(const struct smooth_shape *s, int n, int x, int y)
{
    int inside = 0;
    for (int i = 0; i < n * n; i++)
        inside += depth_at(s, x + (i % n + .5) / n, y + (i / n + .5) / n) >= 0;
    return (double)inside / (n * n);
}

/* The part of [x, x + 1] inside at a height. */
static double inside_of_row(const struct smooth_shape *s, double x, double y)
{
    double from = x, to = x + 1;
    if (s->is_disc) {
        const double dy = y - s->y[0];
        const double half = sqrt(fmax(s->radius * s->radius - dy * dy, 0));
        from = fmax(from, s->x[0] - half);
        to = fmin(to, s->x[0] + half);
    }
    for (int k = 0; k < 3 && !s->is_disc; k++) {
        const int next = (k + 1) % 3;
        const double dx = s->x[next] - s->x[k], dy = s->y[next] - s->y[k];
        const double at = s->x[k] + (y - s->y[k]) * dx / dy;
        if (dy > 0)
            to = fmin(to, at);
        else if (dy < 0)
            from = fmax(from, at);
        else if (dx * (y - s->y[k]) < 0)
            return 0;
    }
    return fmax(to - from, 0);
}

static double rows(const struct smooth_shape *s, int n, int x, int y)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += inside_of_row(s, x, y + (i + .5) / n);
    return sum / n;
}

const struct smooth_method smooth_methods[] = {
    {"ramp by distance", 0, ramp},
    {"4 x 4 samples", 4, samples},
    {"16 x 16 samples", 16, samples},
    {"4 sub-scanlines", 4, rows},
    {"16 sub-scanlines", 16, rows},
    {"64 sub-scanlines", 64, rows},
    {0, 0, 0},
};
