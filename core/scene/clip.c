#include "clip.h"

#include <string.h>

enum { PLANES = 5 };

/* How far inside plane 0 (near) or 1..4 (guard band: right, left, bottom, top)
 * a place is. The sub-pixel is at most limit: center + x 2^spread / z <= limit;
 * below 2^55. */
static int64_t depth_inside(const struct pel_projector *p,
                            const int32_t place[3], int plane)
{
    if (plane == 0)
        return (int64_t)place[2] - p->near;
    const int k = plane > 2;
    const int64_t z = p->one ? p->one : place[2];
    const int64_t at =
        (int64_t)place[k] * (int32_t)(UINT32_C(1) << p->spread[k]);
    if (plane & 1)
        return (PEL_GUARD_MAX - p->center[k]) * z - at;
    return at - (PEL_GUARD_MIN - p->center[k]) * z;
}

/* n / d in 2^-30, n <= d < 2^57, both cut to d's first 32 bits. */
static int32_t part_of(uint64_t n, uint64_t d)
{
    for (; d >> 32; d >>= 1)
        n >>= 1;
    return (int32_t)((n << 30) / d);
}

/* From a corner inside towards one outside. */
static int32_t between(int32_t inside, int32_t outside, int32_t part)
{
    return inside +
           (int32_t)pel_scale_down(((int64_t)outside - inside) * part, 30);
}

static void cut_edge(const struct pel_clip_corner *in,
                     const struct pel_clip_corner *out, int32_t part,
                     struct pel_clip_corner *cut)
{
    for (int k = 0; k < 3; k++) {
        cut->place[k] = between(in->place[k], out->place[k], part);
        cut->weight[k] = between(in->weight[k], out->weight[k], part);
    }
}

/* The part of polygon `from` inside one plane (Sutherland and Hodgman). */
static int32_t cut_polygon(const struct pel_projector *p, int plane,
                           const struct pel_clip_corner *from, int32_t n,
                           struct pel_clip_corner *to)
{
    const struct pel_clip_corner *a = &from[n - 1];
    struct pel_clip_corner *const first = to;
    int64_t inside_a = depth_inside(p, a->place, plane);
    for (int32_t i = 0; i < n; i++) {
        const struct pel_clip_corner *b = &from[i];
        int64_t inside_b = depth_inside(p, b->place, plane);
        if (inside_a >= 0 && inside_b < 0)
            cut_edge(
                a, b,
                part_of((uint64_t)inside_a, (uint64_t)(inside_a - inside_b)),
                to++);
        if (inside_a < 0 && inside_b >= 0)
            cut_edge(
                b, a,
                part_of((uint64_t)inside_b, (uint64_t)(inside_b - inside_a)),
                to++);
        if (inside_b >= 0)
            *to++ = *b;
        a = b;
        inside_a = inside_b;
    }
    if (plane == 0) /* what rounding took */
        for (a = first; a < to; a++)
            first[a - first].place[2] = pel_max(a->place[2], p->near);
    return (int32_t)(to - first);
}

int32_t pel_clip_triangle(const struct pel_projector *projector,
                          struct pel_clip *clip)
{
    struct pel_clip_corner *from = clip->spare, *to = clip->corner;
    int32_t n = 3;
    for (int i = 0; i < 9; i++)
        from[i / 3].weight[i % 3] = i % 4 ? 0 : PEL_COSINE_ONE;
    /* The last of an odd number of cuts ends in clip->corner. */
    for (int plane = 0; plane < PLANES && n; plane++) {
        struct pel_clip_corner *const swap = from;
        n = cut_polygon(projector, plane, from, n, to);
        from = to;
        to = swap;
    }
    return n;
}
