#include "circle.h"

#include <math.h>

static void widen(int half[], int row, int x)
{
    if (half[row] < x)
        half[row] = x;
}

static void clear(int half[], int r)
{
    for (int i = 0; i <= r; i++)
        half[i] = -1;
}

/* Spans of the outline's points: x falls as y grows, decided at the point
 * between two pixels. */
static void midpoint(int r, int half[CIRCLE_MAX + 1])
{
    int x = r, d = 1 - r;
    clear(half, r);
    for (int y = 0; y <= x; y++) {
        widen(half, y, x);
        widen(half, x, y);
        if (d < 0) {
            d += 2 * y + 3;
        } else {
            d += 2 * (y - x) + 5;
            x--;
        }
    }
}

/* The same with the start 3 - 2 r, in steps of 4. */
static void bresenham(int r, int half[CIRCLE_MAX + 1])
{
    int x = r, d = 3 - 2 * r;
    clear(half, r);
    for (int y = 0; y <= x; y++) {
        widen(half, y, x);
        widen(half, x, y);
        if (d > 0) {
            d += 4 * (y - x) + 10;
            x--;
        } else {
            d += 4 * y + 6;
        }
    }
}

static void root_truncated(int r, int half[CIRCLE_MAX + 1])
{
    for (int y = 0; y <= r; y++)
        half[y] = (int)sqrtf((float)(r * r - y * y));
}

static void root_rounded(int r, int half[CIRCLE_MAX + 1])
{
    for (int y = 0; y <= r; y++)
        half[y] = (int)(sqrtf((float)(r * r - y * y)) + 0.5f);
}

/* Angles in 360 steps, as code that knows sines alone has them. */
static void sines(int r, int half[CIRCLE_MAX + 1])
{
    clear(half, r);
    for (int i = 0; i <= 360; i++) {
        const double a = i * (1.5707963267948966 / 360);
        widen(half, (int)(r * sin(a) + .5), (int)(r * cos(a) + .5));
    }
}

const struct circle_method circle_methods[] = {
    {"midpoint", midpoint},
    {"3 - 2 r", bresenham},
    {"float32 root truncated", root_truncated},
    {"float32 root rounded", root_rounded},
    {"360 sines", sines},
    {0, 0},
};

int cell_by_root(int x, int y, int radius, int n)
{
    const float fx = (float)x, fy = (float)y;
    return (int)(sqrtf(fx * fx + fy * fy) * (float)n / (float)radius);
}

int cell_by_table(int x, int y, int radius, int n)
{
    const double square = (double)x * x + (double)y * y;
    const double share = square / ((double)radius * radius);
    if (share >= 1)
        return n;
    return (int)(sqrt(floor(share * 256) / 256) * n);
}
