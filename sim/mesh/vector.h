/* Vectors in space. */
#ifndef SIM_MESH_VECTOR_H
#define SIM_MESH_VECTOR_H

#include <math.h>

static inline double vector_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vector_length(const double v[3])
{
    return sqrt(vector_dot(v, v));
}

static inline void vector_subtract(const double a[3], const double b[3],
                                   double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - b[k];
}

static inline void vector_cross(const double a[3], const double b[3],
                                double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* To unit length; 0 where it is infinite or no number. Returns the length
 * before. */
static inline double vector_normalise(double v[3])
{
    const double length = vector_length(v);
    for (int k = 0; k < 3; k++)
        v[k] = length > 0 && length < INFINITY ? v[k] / length : 0;
    return length;
}

#endif
