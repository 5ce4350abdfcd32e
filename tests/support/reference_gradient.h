/* The cell that a pixel of a gradient shows, by exact arithmetic, and the color
 * of a cell. */
#ifndef TESTS_SUPPORT_REFERENCE_GRADIENT_H
#define TESTS_SUPPORT_REFERENCE_GRADIENT_H

#include "any_paint.h"
#include "cases.h"
#include "check.h"
#include "paint_math.h"

__extension__ typedef __int128 wide;

enum kind { LINEAR, RADIAL, CONIC, HUE, KINDS };

struct gradient {
    enum kind kind;
    struct pel_point at, to; /* from, or the centre */
    int32_t radius;
    uint16_t phase; /* or start */
    uint8_t s, v;   /* of a wheel */
    struct pel_ramp ramp;
    union any_paint u;
};

static inline wide floor_divide(wide n, wide d)
{
    return n / d - (n % d < 0);
}

static inline int32_t cells_of(const struct gradient *g)
{
    return g->kind == HUE ? 1536 : g->ramp.n == 2 ? 256 : g->ramp.n;
}

static inline wide linear_cell(const struct gradient *g, int32_t x, int32_t y)
{
    const wide dx = g->to.x - g->at.x, dy = g->to.y - g->at.y;
    const wide along = dx * (pel_pixel_center(x) - g->at.x) +
                       dy * (pel_pixel_center(y) - g->at.y);
    return floor_divide(along * cells_of(g), dx * dx + dy * dy);
}

/* The outer radius of ring k - 1. */
static inline wide ring_radius(const struct gradient *g, wide k)
{
    return k * g->radius / cells_of(g);
}

/* From a guess to the one ring that holds the pixel. */
static inline wide ring_at(const struct gradient *g, int32_t x, int32_t y)
{
    const wide u = pel_pixel_center(x) - g->at.x;
    const wide v = pel_pixel_center(y) - g->at.y, square = u * u + v * v;
    wide k = (wide)(real_root((real)square) * cells_of(g) / g->radius);
    while (k > 0 && square <= ring_radius(g, k) * ring_radius(g, k))
        k--;
    while (square > ring_radius(g, k + 1) * ring_radius(g, k + 1))
        k++;
    return k;
}

static inline int32_t sectors_of(const struct gradient *g)
{
    return g->kind == CONIC && g->ramp.spread == PEL_REFLECT ? 2 * cells_of(g)
                                                             : cells_of(g);
}

static inline uint16_t angle_of(const struct gradient *g, int64_t k)
{
    return (uint16_t)(g->phase + 65536 * k / sectors_of(g));
}

static inline wide cross(struct pel_point d, wide u, wide v)
{
    return d.x * v - d.y * u;
}

/* The rule of round/angle_range.h, for sectors of up to a half turn. */
static inline bool in_sector(const struct gradient *g, int64_t k, wide u,
                             wide v)
{
    const struct pel_point from = pel_direction(angle_of(g, k));
    const struct pel_point to = pel_direction(angle_of(g, k + 1));
    if (cross(from, u, v) == 0 && from.x * u + from.y * v > 0)
        return true;
    return cross(from, u, v) > 0 && cross(to, u, v) < 0;
}

static inline wide sector_at(const struct gradient *g, int32_t x, int32_t y)
{
    const int64_t n = sectors_of(g);
    int64_t u = pel_pixel_center(x) - g->at.x,
            v = pel_pixel_center(y) - g->at.y;
    if (u == 0 && v == 0)
        u = 1;
    if (n == 1)
        return 0;
    real turn = real_turn((real)u, (real)v) * 65536 - g->phase;
    int64_t k = (int64_t)((turn < 0 ? turn + 65536 : turn) * (real)n / 65536);
    for (int64_t i = k + 2 * n - 2; i <= k + 2 * n + 2; i++)
        if (in_sector(g, i % n, u, v))
            return i % n;
    fail_msg("no sector %ld of %ld; %s", (long)k, (long)n, cases_replay());
    return 0;
}

static inline wide number_at(const struct gradient *g, int32_t x, int32_t y)
{
    if (g->kind == LINEAR)
        return linear_cell(g, x, y);
    return g->kind == RADIAL ? ring_at(g, x, y) : sector_at(g, x, y);
}

static inline pel_color middle_color(pel_color a, pel_color b, uint32_t i)
{
    pel_color c = 0;
    for (int shift = 0; shift < 32; shift += 8)
        c |= ((a >> shift & 255) * (511 - 2 * i) +
              (b >> shift & 255) * (2 * i + 1) + 256) /
                 512
             << shift;
    return c;
}

static inline uint32_t hue_channel(const struct gradient *g, uint32_t part)
{
    const uint32_t whole = 255 * 512, s = g->s, v = g->v;
    return (v * (whole - s * part) + whole / 2) / whole;
}

static inline pel_color hue_color(const struct gradient *g, uint32_t cell)
{
    static const char order[6][4] = {"vtp", "tvp", "pvt", "ptv", "tpv", "vpt"};
    const uint32_t part = cell % 256 * 2 + 1, sixth = cell / 256;
    pel_color c = 255;
    for (int i = 0; i < 3; i++)
        c = c << 8 | (order[sixth][i] == 'v'   ? g->v
                      : order[sixth][i] == 'p' ? hue_channel(g, 512)
                      : sixth % 2              ? hue_channel(g, part)
                                               : hue_channel(g, 512 - part));
    return c;
}

static inline pel_color color_of(const struct gradient *g, wide k)
{
    const wide n = cells_of(g),
               period =
                   g->kind != HUE && g->ramp.spread == PEL_REFLECT ? 2 * n : n;
    if (g->kind == RADIAL)
        k += g->phase * n / 65536;
    if (g->kind < CONIC && g->ramp.spread == PEL_PAD)
        k = k < 0 ? 0 : k < n ? k : n - 1;
    k -= floor_divide(k, period) * period;
    k = k < n ? k : 2 * n - 1 - k;
    if (g->kind == HUE)
        return hue_color(g, (uint32_t)k);
    if (g->ramp.n == 2)
        return middle_color(g->ramp.colors[0], g->ramp.colors[1], (uint32_t)k);
    return g->ramp.colors[k];
}

#endif
