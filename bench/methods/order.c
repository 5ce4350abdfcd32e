#include "order.h"

#include <math.h>
#include <stddef.h>

static double mean(const double z[3])
{
    return (z[0] + z[1] + z[2]) / 3;
}

static double nearest(const double z[3])
{
    return fmin(z[0], fmin(z[1], z[2]));
}

static double farthest(const double z[3])
{
    return fmax(z[0], fmax(z[1], z[2]));
}

const struct order_method order_methods[] = {
    {"painter", mean},
    {"sorted by nearest", nearest},
    {"sorted by farthest", farthest},
    {NULL, NULL},
};
