#include "mesh_clip.h"

#include <string.h>

#define GUARD                                                      \
    32000.0 /* px; the canvas ends at 32,767 and the range as well \
             */

void clip_planes_init(struct clip_planes *planes,
                      const struct camera_view *view)
{
    const double *scale = view->scale, *middle = view->middle;
    const double plane[CLIP_PLANES][4] = {
        {0, 0, 1, -view->near},
        {scale[0], 0, GUARD + middle[0], 0},
        {-scale[0], 0, GUARD - middle[0], 0},
        {0, -scale[1], GUARD + middle[1], 0},
        {0, scale[1], GUARD - middle[1], 0},
    };
    memcpy(planes->plane, plane, sizeof(plane));
}

static double side_of(const double plane[4], const double point[3])
{
    return camera_dot(plane, point) + plane[3];
}

unsigned clip_outside(const struct clip_planes *planes, const double point[3])
{
    unsigned outside = 0;
    for (int i = 0; i < CLIP_PLANES; i++)
        if (side_of(planes->plane[i], point) < 0)
            outside |= 1u << i;
    return outside;
}

static double between(double a, double b, double t)
{
    return a + (b - a) * t;
}

/* Where the plane cuts the side from `in`, which lies inside, to `out`. */
static struct clip_corner cut(const double plane[4],
                              const struct clip_corner *in,
                              const struct clip_corner *out)
{
    struct clip_corner c;
    double from = side_of(plane, in->point), to = side_of(plane, out->point);
    double t = from / (from - to);
    for (int k = 0; k < 3; k++) {
        c.point[k] = between(in->point[k], out->point[k], t);
        c.color[k] = between(in->color[k], out->color[k], t);
    }
    for (int k = 0; k < 2; k++)
        c.uv[k] = between(in->uv[k], out->uv[k], t);
    return c;
}

/* A convex polygon gains at most one corner. */
static int clip_to_plane(const double plane[4], struct clip_corner *corner,
                         int n)
{
    struct clip_corner from[CLIP_CORNERS_MAX];
    int count = 0;
    memcpy(from, corner, (size_t)n * sizeof(*from));
    for (int i = 0; i < n; i++) {
        const struct clip_corner *a = &from[i], *b = &from[(i + 1) % n];
        bool a_in = side_of(plane, a->point) >= 0;
        bool b_in = side_of(plane, b->point) >= 0;
        if (a_in)
            corner[count++] = *a;
        if (a_in != b_in && count < CLIP_CORNERS_MAX)
            corner[count++] = a_in ? cut(plane, a, b) : cut(plane, b, a);
    }
    return count;
}

int clip_polygon(const struct clip_planes *planes, struct clip_corner *corner,
                 int n)
{
    for (int i = 0; i < CLIP_PLANES && n > 0; i++)
        n = clip_to_plane(planes->plane[i], corner, n);
    return n;
}
