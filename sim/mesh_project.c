#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "camera.h"
#include "mesh_clip.h"
#include "message.h"

struct projection {
    const struct mesh *mesh;
    struct camera_view view;
    struct clip_planes planes;
    double (*point)[3]; /* of each vertex, in camera space */
    uint32_t *index;    /* of each vertex in `flat`, NOT_YET before its use */
    struct pel2d *flat;
    uint32_t clipped;
};

#define NOT_YET UINT32_MAX

/* The nearest 1/256 px. Inside the planes: at most 32,000 px, but for the last
 * bits of a double. */
static int32_t to_subpixels(double px)
{
    return (int32_t)floor(px * 256 + 0.5);
}

static bool add_corner(struct projection *p, const struct clip_corner *corner)
{
    const struct camera_view *view = &p->view;
    const double *c = corner->point;
    double x = view->middle[0] + view->scale[0] * c[0] / c[2];
    double y = view->middle[1] - view->scale[1] * c[1] / c[2];
    const struct pel2d_vertex v = {
        {to_subpixels(x), to_subpixels(y)},
        PEL_RGB(lround(corner->color[0]), lround(corner->color[1]),
                lround(corner->color[2])),
        mesh_depth_of(c[2]),
        corner->uv[0],
        corner->uv[1],
    };
    return pel2d_add_vertex(p->flat, &v);
}

static struct clip_corner corner_of(const struct projection *p, uint32_t i)
{
    const struct mesh_vertex *v = &p->mesh->vertex[i];
    struct clip_corner c = {
        .color = {pel_red(v->color), pel_green(v->color), pel_blue(v->color)},
        .uv = {v->uv[0], v->uv[1]},
    };
    memcpy(c.point, p->point[i], sizeof(c.point));
    return c;
}

/* A triangle that no plane cuts shares its vertices with others. */
static bool add_whole(struct projection *p, const uint32_t index[3])
{
    uint32_t to[3];
    for (int k = 0; k < 3; k++) {
        uint32_t i = index[k];
        if (p->index[i] == NOT_YET) {
            struct clip_corner corner = corner_of(p, i);
            p->index[i] = p->flat->vertices;
            if (!add_corner(p, &corner))
                return false;
        }
        to[k] = p->index[i];
    }
    return pel2d_add_triangle(p->flat, to);
}

/* The others have vertices of their own, as a fan. */
static bool add_clipped(struct projection *p, const uint32_t index[3])
{
    struct clip_corner corner[CLIP_CORNERS_MAX];
    uint32_t first = p->flat->vertices;
    for (int k = 0; k < 3; k++)
        corner[k] = corner_of(p, index[k]);
    int n = clip_polygon(&p->planes, corner, 3);
    for (int i = 0; i < n; i++)
        if (!add_corner(p, &corner[i]))
            return false;
    for (uint32_t i = 2; (int)i < n; i++) {
        const uint32_t to[3] = {first, first + i - 1, first + i};
        if (!pel2d_add_triangle(p->flat, to))
            return false;
    }
    return true;
}

static bool add_triangle(struct projection *p, const uint32_t index[3])
{
    unsigned outside = 0;
    for (int k = 0; k < 3; k++)
        outside |= clip_outside(&p->planes, p->point[index[k]]);
    if (outside == 0)
        return add_whole(p, index);
    p->clipped++;
    return add_clipped(p, index);
}

static bool project_all(struct projection *p)
{
    const struct mesh *mesh = p->mesh;
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        camera_view_point(&p->view, mesh->vertex[i].position, p->point[i]);
        p->index[i] = NOT_YET;
    }
    for (uint32_t i = 0; i < mesh->triangles; i++)
        if (!add_triangle(p, mesh->triangle[i]))
            return false;
    return true;
}

bool mesh_project(const struct mesh *mesh, const struct camera *camera,
                  struct pel2d *flat, uint32_t *clipped)
{
    struct projection p = {.mesh = mesh, .flat = flat};
    memset(flat, 0, sizeof(*flat));
    if (!camera_view_init(&p.view, camera))
        return message_error("a camera that camera_frame has not completed");
    clip_planes_init(&p.planes, &p.view);
    p.point = malloc(mesh->vertices * sizeof(*p.point));
    p.index = malloc(mesh->vertices * sizeof(*p.index));
    bool done = p.point && p.index ? project_all(&p)
                                   : message_error("no memory to project %u "
                                                   "vertices",
                                                   mesh->vertices);
    free(p.point);
    free(p.index);
    *clipped = p.clipped;
    if (!done)
        pel2d_free(flat);
    return done;
}
