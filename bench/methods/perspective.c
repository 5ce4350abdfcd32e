#include "perspective.h"

#include <math.h>

static double inverse_z(const struct lane *l, double x)
{
    const double t = x / l->length;
    return (1 - t) / l->z[0] + t / l->z[1];
}

double lane_exact(const struct lane *l, double x)
{
    const double t = x / l->length;
    return ((1 - t) * l->u[0] / l->z[0] + t * l->u[1] / l->z[1]) /
           inverse_z(l, x);
}

double lane_affine(const struct lane *l, double x)
{
    return l->u[0] + x / l->length * (l->u[1] - l->u[0]);
}

double lane_span(const struct lane *l, double x, int span)
{
    const double begin = floor((x - .5) / span) * span + .5;
    const double end = fmin(begin + span, l->length);
    const double a = lane_exact(l, begin), b = lane_exact(l, end);
    return a + (x - begin) / (end - begin) * (b - a);
}

double lane_float(const struct lane *l, double x)
{
    const float w0 = 1 / (float)l->z[0], w1 = 1 / (float)l->z[1];
    const float u0 = (float)l->u[0] * w0, u1 = (float)l->u[1] * w1;
    const float right = 1 / (float)l->length, at = (float)x;
    return (u0 + at * ((u1 - u0) * right)) / (w0 + at * ((w1 - w0) * right));
}

double lane_bound(const struct lane *l, double x0, double x1)
{
    const double w0 = inverse_z(l, x0), w1 = inverse_z(l, x1);
    const double r = fmax(w0, w1) / fmin(w0, w1);
    return r > 0 ? fabs(lane_exact(l, x1) - lane_exact(l, x0)) * (r - 1) / 4
                 : 0;
}
