#include <pel/pel.h>

#include "color.h"

static int pel(int s, int d, int a)
{
    return (int)pel_blue(pel_mix((pel_color)d, (pel_color)s, (uint32_t)a));
}

static int shifted(int s, int d, int a)
{
    return (s * a + d * (255 - a)) >> 8;
}

static int shifted_up(int s, int d, int a)
{
    return (s * a + d * (255 - a) + 255) >> 8;
}

static int of_257(int s, int d, int a)
{
    return (s * (a + 1) + d * (255 - a)) >> 8;
}

/* alpha in 0..256 by its highest bit. */
static int of_256(int s, int d, int a)
{
    const int wide = a + (a >> 7);
    return (s * wide + d * (256 - wide)) >> 8;
}

static int by_difference(int s, int d, int a)
{
    return d + (((s - d) * a) >> 8);
}

static int divided(int s, int d, int a)
{
    return (s * a + d * (255 - a)) / 255;
}

const struct blend_method blend_methods[] = {
    {"pel", pel},
    {">> 8", shifted},
    {"+ 255 >> 8", shifted_up},
    {"alpha + 1 >> 8", of_257},
    {"alpha + (alpha >> 7) >> 8", of_256},
    {"d + ((s - d) a >> 8)", by_difference},
    {"/ 255", divided},
    {0, 0},
};
