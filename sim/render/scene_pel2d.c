#include "sim/render/scene_pel2d.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/list.h"
#include "core/scene/work.h"

struct projection {
    const struct scene *scene;
    uint32_t *index; /* of each vertex in `flat`, NOT_YET before its use */
    struct pel2d *flat;
    uint32_t clipped;
};

#define NOT_YET UINT32_MAX

static double uv_of(const struct pel_mesh *mesh, uint32_t vertex, int axis)
{
    if (!mesh->uv)
        return 0;
    return ldexp(
        pel_quantization_value(&mesh->texture, axis, mesh->uv[vertex][axis]),
        -mesh->texture.shift);
}

static bool add(struct projection *p, struct pel2d_vertex *v, int32_t z)
{
    v->color |= PEL_RGB(0, 0, 0);
    v->depth = (struct mesh_depth){{z, 0, 0}};
    return list_add(&p->flat->vertex, &p->flat->vertices, v, sizeof *v);
}

static bool add_index(struct pel2d *flat, const uint32_t index[3])
{
    return list_add(&flat->triangle, &flat->triangles, index,
                    sizeof *flat->triangle);
}

/* A triangle that nothing cuts shares its vertices with others. */
static bool add_whole(struct projection *p, const uint32_t corner[3])
{
    const struct pel_mesh *mesh = &p->scene->mesh;
    uint32_t to[3];
    for (int k = 0; k < 3; k++) {
        const uint32_t i = corner[k];
        const struct pel_frame_vertex *from = &p->scene->frame.vertex[i];
        struct pel2d_vertex v = {.at = {from->at.x, from->at.y},
                                 .color = pel_frame_color(&p->scene->frame, i),
                                 .u = uv_of(mesh, i, 0),
                                 .v = uv_of(mesh, i, 1)};
        if (p->index[i] == NOT_YET) {
            p->index[i] = (uint32_t)p->flat->vertices;
            if (!add(p, &v, from->at.z))
                return false;
        }
        to[k] = p->index[i];
    }
    return add_index(p->flat, to);
}

/* A color between those of three vertices. */
static pel_color mix_colors(const struct pel_frame *frame,
                            const uint32_t vertex[3], const int32_t weight[3])
{
    pel_color mixed = 0;
    for (int shift = 0; shift < 32; shift += 8) {
        int32_t value[3];
        for (int k = 0; k < 3; k++)
            value[k] =
                (int32_t)(pel_frame_color(frame, vertex[k]) >> shift & 255);
        mixed |= (pel_color)pel_scale_down(pel_dot(weight, value), 30) << shift;
    }
    return mixed;
}

/* A place between three vertices. */
static bool add_corner(struct projection *p, const uint32_t vertex[3],
                       const struct pel_clip_corner *c)
{
    struct pel_frame frame = p->scene->frame;
    memcpy(frame.work->triangle.vertex, vertex, 3 * sizeof *vertex);
    struct pel2d_vertex v = {.at = pel_frame_corner_at(&frame, c),
                             .color = mix_colors(&frame, vertex, c->weight)};
    for (int k = 0; k < 3; k++) {
        const double weight = (double)c->weight[k] / PEL_COSINE_ONE;
        v.u += weight * uv_of(&p->scene->mesh, vertex[k], 0);
        v.v += weight * uv_of(&p->scene->mesh, vertex[k], 1);
    }
    return add(p, &v, c->z);
}

/* A clipped triangle becomes a fan with vertices of its own. */
static bool add_clipped(struct projection *p, const uint32_t corner[3])
{
    const struct pel_projector *projector = &p->scene->frame.projector;
    const uint32_t first = (uint32_t)p->flat->vertices;
    struct pel_clip clip;
    pel_clip_start(&clip);
    for (int k = 0; k < 3; k++) {
        clip.polygon[0][k] = &clip.corner[k];
        pel_project_fine(projector, p->scene->mesh.positions[corner[k]],
                         clip.corner[k].at);
    }
    const int32_t n = pel_clip_triangle(projector, &clip);
    p->clipped++;
    for (int32_t i = 0; i < n; i++)
        if (!add_corner(p, corner, clip.polygon[0][i]))
            return false;
    for (uint32_t i = 2; (int32_t)i < n; i++) {
        const uint32_t to[3] = {first, first + i - 1, first + i};
        if (!add_index(p->flat, to))
            return false;
    }
    return true;
}

bool scene_project(const struct scene *scene, struct pel2d *flat,
                   uint32_t *clipped)
{
    const struct pel_mesh *mesh = &scene->mesh;
    struct projection p = {.scene = scene, .flat = flat};
    memset(flat, 0, sizeof(*flat));
    p.index = malloc(mesh->vertices * sizeof(*p.index));
    bool done = p.index || message_error("no memory to project %u vertices",
                                         mesh->vertices);
    for (uint32_t i = 0; i < mesh->vertices && done; i++)
        p.index[i] = NOT_YET;
    for (uint32_t i = 0; i < mesh->triangles && done; i++) {
        uint32_t corner[3];
        bool on_screen = true;
        pel_mesh_corners(mesh, i, corner);
        for (int k = 0; k < 3; k++)
            on_screen &=
                scene->frame.vertex[corner[k]].at.x != PEL_NOT_ON_SCREEN;
        done = on_screen ? add_whole(&p, corner) : add_clipped(&p, corner);
    }
    free(p.index);
    *clipped = p.clipped;
    if (!done)
        pel2d_free(flat);
    return done;
}
