#include "clip.h"

#include <string.h>

#include "../base/divide.h"

enum { PLANES = 5 };

void pel_clip_start(struct pel_clip *clip)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            clip->corner[i].weight[k] = (i == k) * PEL_COSINE_ONE;
}

static PEL_NOINLINE int32_t coarse_of(const struct pel_projector *p, int64_t v)
{
    return (int32_t)(v >> p->coarse);
}

/* The distance of a place to plane 0 (near) or 1..4 (guard band: right, left,
 * bottom, top), below 0 outside. The sub-pixel is at most limit: center + x
 * 2^spread / z <= limit; below 2^62. */
static PEL_NOINLINE_32 int64_t depth_inside(const struct pel_projector *p,
                                            const int64_t at[3], int plane)
{
    const int k = plane > 2;
    const int32_t limit = (plane & 1 ? PEL_GUARD_MAX : PEL_GUARD_MIN);
    const int32_t z = p->one ? p->one : coarse_of(p, at[2]);
    const int64_t inside =
        pel_minor(limit - p->center[k], z, coarse_of(p, at[k]),
                  (int32_t)(UINT32_C(1) << p->spread[k]));
    if (plane == 0)
        return at[2] - pel_scale_down(p->near_coarse, -p->coarse);
    return plane & 1 ? inside : -inside;
}

/* The point of an edge where it meets the plane, or up to 2^-29 of the edge
 * inside: n / d of the edge from its corner inside, both below 2^63, cut to
 * 31 bits and rounded down. It stays on the edge to a fine step. */
static PEL_NOINLINE_32 void cut_edge(const struct pel_projector *p, int plane,
                                     const struct pel_clip_corner *a,
                                     const struct pel_clip_corner *b,
                                     struct pel_clip_corner *cut)
{
    if (a->z < 0) {
        const struct pel_clip_corner *swap = a;
        a = b;
        b = swap;
    }
    uint64_t n = (uint64_t)depth_inside(p, a->at, plane);
    uint64_t d = n - (uint64_t)depth_inside(p, b->at, plane);
    for (; d >> 31; d >>= 1)
        n >>= 1;
    const int32_t part = (int32_t)pel_divide(n << 30, (uint32_t)d + 1);
    for (int k = 0; k < 3; k++) {
        const int64_t way = b->at[k] - a->at[k];
        cut->at[k] = a->at[k] +
                     (int64_t)pel_times((uint64_t)(way >> 30), part) +
                     (int64_t)(pel_multiply((uint32_t)way & 0x3FFFFFFFu,
                                            (uint32_t)part) >>
                               30);
        cut->weight[k] =
            a->weight[k] + pel_scaled(b->weight[k] - a->weight[k], part, 30);
    }
    const int64_t near = pel_scale_down(p->near_coarse, -p->coarse);
    if (cut->at[2] < near)
        cut->at[2] = near;
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
    for (int32_t i = 0; i < n; i++) {
        const int64_t *at = from[i]->at;
        from[i]->z = depth_inside(p, at, plane) < 0 ? -1 : 0;
    }
    for (; n > 0 && to < first + PEL_CLIP_CORNERS - 1; n--) {
        struct pel_clip_corner *b = *from++;
        if ((a->z < 0) != (b->z < 0) && *made < clip->corner + PEL_CLIP_MADE) {
            cut_edge(p, plane, a, b, *made);
            *to++ = (*made)++;
        }
        if (b->z >= 0)
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
    for (int32_t i = 0; i < n; i++)
        clip->polygon[0][i]->z =
            coarse_of(projector, clip->polygon[0][i]->at[2]);
    return n;
}
