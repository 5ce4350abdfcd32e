#include "clip.h"

#include "../base/divide.h"

enum { PLANES = 5 };

void pel_clip_start(struct pel_clip *clip)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            clip->corner[i].weight[k] = (i == k) * PEL_COSINE_ONE;
}

/* The distance of a position to plane 0 (near) or 1..4 (guard band: right,
 * left, bottom, top), below 0 outside. The sub-pixel is at most limit: center +
 * x 2^spread / z <= limit; below 2^55. */
static PEL_NOINLINE_32 int64_t depth_inside(const struct pel_projector *p,
                                            const int32_t position[3],
                                            int plane)
{
    const int k = plane > 2;
    const int32_t z = p->one ? p->one : position[2];
    const int32_t limit = (plane & 1 ? PEL_GUARD_MAX : PEL_GUARD_MIN);
    const int64_t inside = pel_minor(limit - p->center[k], z, position[k],
                                     (int32_t)(UINT32_C(1) << p->spread[k]));
    if (plane == 0)
        return position[2] - p->near_coarse;
    return plane & 1 ? inside : -inside;
}

/* a + part (b - a). */
static void mix(const int32_t a[3], const int32_t b[3], int32_t part,
                int32_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] + pel_scaled(b[k] - a[k], part, 30);
}

/* The point where an edge meets the plane, n / d of the edge from its corner
 * inside: both below 2^57 and cut to d's first 32 bits. Rounding leaves it in
 * front of the near plane. */
static PEL_NOINLINE_32 void cut_edge(const struct pel_projector *p,
                                     const struct pel_clip_corner *a,
                                     const struct pel_clip_corner *b,
                                     struct pel_clip_corner *cut)
{
    if (a->inside < 0) {
        const struct pel_clip_corner *swap = a;
        a = b;
        b = swap;
    }
    uint64_t n = (uint64_t)a->inside, d = n - (uint64_t)b->inside;
    for (; d >> 32; d >>= 1)
        n >>= 1;
    const int32_t part = (int32_t)pel_divide(n << 30, (uint32_t)d);
    mix(a->position, b->position, part, cut->position);
    mix(a->weight, b->weight, part, cut->weight);
    cut->position[2] = pel_max(cut->position[2], p->near_coarse);
}

/* The part of a polygon inside one plane (Sutherland and Hodgman); `made` is
 * where new corners go. The number of its corners. */
static int32_t cut_polygon(const struct pel_projector *p, int plane,
                           struct pel_clip *clip, int32_t n,
                           struct pel_clip_corner **made)
{
    struct pel_clip_corner **from = clip->polygon[~plane & 1];
    struct pel_clip_corner **const first = clip->polygon[plane & 1];
    struct pel_clip_corner **to = first, *a = from[n - 1];
    for (int32_t i = 0; i < n; i++)
        from[i]->inside = depth_inside(p, from[i]->position, plane);
    for (; n > 0 && to < first + PEL_CLIP_CORNERS - 1; n--) {
        struct pel_clip_corner *b = *from++;
        if ((a->inside < 0) != (b->inside < 0) &&
            *made < clip->corner + PEL_CLIP_MADE) {
            cut_edge(p, a, b, *made);
            *to++ = (*made)++;
        }
        if (b->inside >= 0)
            *to++ = b;
        a = b;
    }
    return (int32_t)(to - first);
}

/* Polygon 1 first; five cuts later it is in polygon 0. */
int32_t pel_clip_triangle(const struct pel_projector *projector,
                          struct pel_clip *clip)
{
    struct pel_clip_corner *made = clip->corner;
    int32_t n = 0;
    for (; n < 3; n++)
        clip->polygon[1][n] = made++;
    for (int plane = 0; plane < PLANES && n; plane++)
        n = cut_polygon(projector, plane, clip, n, &made);
    return n;
}
