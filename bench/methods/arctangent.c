#include "arctangent.h"

#include <math.h>
#include <stdlib.h>
#include <pel/pel.h>

static double pel(int x, int y)
{
    return pel_turn_of(x, y) / 4294967296.0;
}

/* The whole turn from that of the first eighth: of z, 0..1. */
static double unfold(int x, int y, double (*eighth)(double z))
{
    const double ax = abs(x), ay = abs(y);
    double turn = ay <= ax ? eighth(ay / ax) : .25 - eighth(ax / ay);
    if (x < 0)
        turn = .5 - turn;
    return y < 0 ? 1 - turn : turn;
}

/* Coefficients with the least largest error over 0..1, by Remez exchange. */
static double cubic(double z)
{
    return z * (.163473557 + z * (-.026460926 - z * .012221374));
}

static double degree_5(double z)
{
    const double q = z * z;
    return z * (.158416139 + q * (-.045946478 + q * .012627201));
}

static double degree_11(double z)
{
    static const double c[6] = {.159151317396,  -.052938567244, .030802907542,
                                -.018529850112, .008379086226,  -.001865158381};
    double sum = 0;
    for (int i = 5; i >= 0; i--)
        sum = sum * z * z + c[i];
    return z * sum;
}

enum { STEPS = 64 };

static double entry(int i)
{
    return atan((double)i / STEPS) / 6.283185307179586;
}

static double table_nearest(double z)
{
    return entry((int)(z * STEPS + .5));
}

static double table_linear(double z)
{
    const int i = (int)(z * STEPS);
    const double a = entry(i);
    return a + (z * STEPS - i) * (entry(i + 1) - a);
}

static double turn_cubic(int x, int y)
{
    return unfold(x, y, cubic);
}

static double turn_5(int x, int y)
{
    return unfold(x, y, degree_5);
}

static double turn_11(int x, int y)
{
    return unfold(x, y, degree_11);
}

static double turn_nearest(int x, int y)
{
    return unfold(x, y, table_nearest);
}

static double turn_linear(int x, int y)
{
    return unfold(x, y, table_linear);
}

static double turn_float(int x, int y)
{
    const float turn = atan2f((float)y, (float)x) / 6.2831853f;
    return turn < 0 ? turn + 1 : turn;
}

const struct arctangent_method arctangent_methods[] = {
    {"pel", 0, pel},
    {"cubic", 3, turn_cubic},
    {"degree 5", 5, turn_5},
    {"degree 11", 11, turn_11},
    {"table nearest", STEPS, turn_nearest},
    {"table linear", STEPS, turn_linear},
    {"float32 atan2f", 0, turn_float},
    {0, 0, 0},
};
