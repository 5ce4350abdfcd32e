/* Primitives (chapter 3.7): vertices at rest, in their colours, as triangles.
 */
#include "sim/mesh/gltf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

enum mode { POINTS, LINES, LOOP, LINE_STRIP, TRIANGLES, STRIP, FAN };

/* What the file has for the vertices; without numbers, nothing. */
struct attributes {
    struct gltf_array position, normal, uv, color, joint[2], weight[2];
    bool one_color; /* of all vertices, where they have colours */
};

static void free_attributes(struct attributes *a)
{
    struct gltf_array *const arrays[] = {
        &a->position, &a->normal,   &a->uv,        &a->color,
        &a->joint[0], &a->joint[1], &a->weight[0], &a->weight[1]};
    for (int i = 0; i < 8; i++)
        free(arrays[i]->number);
}

/* One that is not there is none; but for the position all are as long as it. */
static bool read(struct gltf *g, const json_t *attributes, const char *name,
                 int components, struct gltf_array *to)
{
    if (!json_object_get(attributes, name))
        return true;
    const size_t count = to->count;
    if (!gltf_accessor(g, gltf_index(g, attributes, name), to))
        return false;
    if (components && to->components != components)
        return gltf_refuse_in(g, attributes, "%s has %d numbers: expected %d",
                              name, to->components, components);
    return to->count >= count ||
           gltf_refuse_in(g, attributes,
                          "%s has %zu elements: expected %zu as POSITION has",
                          name, to->count, count);
}

/* Of the shapes that it can take each has a weight. */
static bool add_morphs(struct gltf *g, const struct gltf_primitive *p,
                       const char *name, struct gltf_array *to)
{
    const json_t *targets = gltf_list(g, p->json, "targets");
    const json_t *weights = gltf_list(g, p->node, "weights");
    if (!weights)
        weights = gltf_list(g, p->mesh, "weights");
    for (size_t i = 0; i < json_array_size(targets) && to->number; i++) {
        const json_t *target = json_array_get(targets, i);
        const double w = json_number_value(json_array_get(weights, i));
        struct gltf_array delta = {.count = to->count};
        if (w == 0)
            continue;
        if (!read(g, target, name, 3, &delta))
            return false;
        for (size_t k = 0; delta.number && k < 3 * to->count; k++)
            to->number[k] += w * delta.number[k];
        free(delta.number);
    }
    return g->good;
}

static bool read_all(struct gltf *g, const struct gltf_primitive *p,
                     const struct gltf_material *m, struct attributes *a)
{
    const json_t *from = gltf_member(g, p->json, "attributes");
    char uv[32];
    snprintf(uv, sizeof(uv), "TEXCOORD_%lld", (long long)m->place.set);
    if (!read(g, from, "POSITION", 3, &a->position) || !a->position.number)
        return gltf_refuse_in(g, p->json,
                              "a primitive has no POSITION: expected one");
    a->normal.count = a->uv.count = a->color.count = a->position.count;
    for (int i = 0; i < 2; i++)
        a->joint[i].count = a->weight[i].count = a->position.count;
    return read(g, from, "NORMAL", 3, &a->normal) &&
           (!p->has_uv || read(g, from, uv, 2, &a->uv)) &&
           read(g, from, "COLOR_0", 0, &a->color) &&
           read(g, from, "JOINTS_0", 4, &a->joint[0]) &&
           read(g, from, "JOINTS_1", 4, &a->joint[1]) &&
           read(g, from, "WEIGHTS_0", 4, &a->weight[0]) &&
           read(g, from, "WEIGHTS_1", 4, &a->weight[1]) &&
           add_morphs(g, p, "POSITION", &a->position) &&
           add_morphs(g, p, "NORMAL", &a->normal) &&
           (!a->color.number || a->color.components == 3 ||
            a->color.components == 4 ||
            gltf_refuse_in(g, from, "COLOR_0 has %d numbers: expected 3 or 4",
                           a->color.components));
}

static bool is_one_color(const struct gltf_array *c)
{
    const size_t size = (size_t)c->components * sizeof(double);
    for (size_t i = 1; i < c->count; i++)
        if (memcmp(c->number, c->number + i * (size_t)c->components, size) != 0)
            return false;
    return true;
}

static pel_color encode(const double factor[3], const double glow[3])
{
    unsigned byte[3];
    for (int k = 0; k < 3; k++)
        byte[k] = mesh_byte(factor[k] + glow[k]);
    return PEL_RGB(byte[0], byte[1], byte[2]);
}

/* The material of a part: a colour that all vertices have is in its factor,
 * others are the vertices'. */
static void set_material(const struct gltf_material *from,
                         const struct attributes *a, struct mesh_material *m)
{
    const struct gltf_array *c = &a->color;
    const bool one = a->one_color;
    *m = from->material;
    memcpy(m->factor, from->color, sizeof(m->factor));
    for (int k = 0; one && k < c->components; k++)
        m->factor[k] *= c->number[k];
    m->is_colored =
        c->number && !one && a->uv.number && (m->texture || m->glow_texture);
    const double alpha = fmin(fmax(m->factor[3], 0), 1);
    m->color = encode(m->factor, m->glow);
    if (m->alpha == MESH_BLENDED)
        m->color = (m->color & 0xFFFFFFu) | (pel_color)(alpha * 255 + 0.5)
                                                << 24;
    m->factor[3] = m->alpha == MESH_CUT_OUT ? alpha : 1;
    m->tint = m->color | PEL_RGB(0, 0, 0);
}

static pel_color color_of(const struct mesh_material *m,
                          const struct attributes *a, size_t i)
{
    static const double none[3] = {0, 0, 0};
    const struct gltf_array *c = &a->color;
    const double *own = c->number + i * (size_t)c->components;
    double v[3];
    if (!c->number || a->one_color)
        return m->color | PEL_RGB(0, 0, 0);
    for (int k = 0; k < 3; k++)
        v[k] = own[k] * (m->is_colored ? 1 : m->factor[k]);
    return encode(v, m->is_colored ? none : m->glow);
}

/* Room for n more, of what is there the double when it is full. */
static bool make_room(struct gltf *g, struct mesh *mesh, size_t vertices,
                      size_t triangles)
{
    const size_t v = mesh->vertices + vertices, t = mesh->triangles + triangles;
    if (v > 1u << 28 || t > 1u << 28)
        return gltf_refuse(
            g, "more than 2^28 vertices or triangles: expected no more");
    if (v > g->room[0]) {
        g->room[0] = v + v / 2;
        void *to = realloc(mesh->vertex, g->room[0] * sizeof(*mesh->vertex));
        mesh->vertex = to ? to : mesh->vertex;
        g->good = g->good && to;
    }
    if (t > g->room[1]) {
        g->room[1] = t + t / 2;
        void *to =
            realloc(mesh->triangle, g->room[1] * sizeof(*mesh->triangle));
        mesh->triangle = to ? to : mesh->triangle;
        g->good = g->good && to;
    }
    return g->good || message_error("no memory for %zu vertices", v);
}

/* The part that the primitive goes on with, or a new one. */
static struct mesh_part *part_for(struct gltf *g, struct mesh *mesh,
                                  const struct gltf_primitive *p,
                                  const struct mesh_material *m)
{
    struct mesh_part *last = mesh->parts ? &mesh->part[mesh->parts - 1] : NULL;
    if (last && g->material == p->material && last->has_uv == p->has_uv &&
        last->material.is_colored == m->is_colored &&
        last->material.color == m->color &&
        memcmp(last->material.factor, m->factor, sizeof(m->factor)) == 0)
        return last;
    struct mesh_part *to =
        realloc(mesh->part, (mesh->parts + 1) * sizeof(*mesh->part));
    if (!to) {
        message_error("no memory for %u parts", mesh->parts);
        return NULL;
    }
    mesh->part = to;
    g->material = p->material;
    to[mesh->parts] =
        (struct mesh_part){mesh->vertices, mesh->triangles, p->has_uv, *m};
    return &to[mesh->parts++];
}

/* The nodes of a skin as they stand, for each vertex weighted: the node that
 * shows the mesh does not count. */
static bool read_skin(struct gltf *g, const struct gltf_primitive *p,
                      struct gltf_skin *to)
{
    const json_int_t index = gltf_index(g, p->node, "skin");
    if (index < 0)
        return g->good;
    return gltf_skin(g, gltf_at(g, "skins", index), to);
}

/* The matrix of a vertex; false where a joint is not there. */
static bool matrix_of(const struct gltf_primitive *p,
                      const struct attributes *a, const struct gltf_skin *skin,
                      size_t i, double to[16])
{
    double sum = 0;
    memcpy(to, p->world, 16 * sizeof(*to));
    if (!skin->matrix || !a->joint[0].number || !a->weight[0].number)
        return true;
    memset(to, 0, 16 * sizeof(*to));
    for (int set = 0; set < 2; set++)
        for (size_t k = 4 * i;
             a->joint[set].number && a->weight[set].number && k < 4 * i + 4;
             k++) {
            const double joint = a->joint[set].number[k];
            const double w = a->weight[set].number[k];
            if (!(joint >= 0 && joint < (double)skin->count))
                return false;
            for (int e = 0; e < 16; e++)
                to[e] += w * skin->matrix[(size_t)joint][e];
            sum += w;
        }
    for (int e = 0; e < 16 && sum > 0; e++)
        to[e] /= sum;
    return true;
}

static void put_vertex(const struct attributes *a, const double m[16], size_t i,
                       struct mesh_vertex *to)
{
    const double *at = a->position.number + 3 * i;
    memset(to, 0, sizeof(*to));
    for (int k = 0; k < 3; k++)
        to->position[k] = m[k] * at[0] + m[k + 4] * at[1] + m[k + 8] * at[2] +
                          m[k + 12] + 0.0;
    if (a->normal.number)
        gltf_turn_normal(m, a->normal.number + 3 * i, to->normal);
}

static bool put_vertices(struct gltf *g, struct mesh *mesh,
                         const struct gltf_primitive *p,
                         const struct gltf_material *from,
                         const struct attributes *a)
{
    struct mesh_material m;
    struct gltf_skin skin = {NULL, 0};
    set_material(from, a, &m);
    struct mesh_part *part = part_for(g, mesh, p, &m);
    if (!part || !read_skin(g, p, &skin))
        return false;
    for (size_t i = 0; i < a->position.count; i++) {
        struct mesh_vertex *v = &mesh->vertex[mesh->vertices + i];
        double matrix[16];
        if (!matrix_of(p, a, &skin, i, matrix))
            return gltf_refuse_in(g, p->json,
                                  "JOINTS_0 or JOINTS_1 has a joint that is "
                                  "not there: expected less than %zu",
                                  skin.count);
        put_vertex(a, matrix, i, v);
        for (int k = 0; k < 2 && a->uv.number; k++)
            v->uv[k] = from->place.uv[k][0] * a->uv.number[2 * i] +
                       from->place.uv[k][1] * a->uv.number[2 * i + 1] +
                       from->place.uv[k][2] + 0.0;
        v->color = color_of(&m, a, i);
    }
    mesh->vertices += (uint32_t)a->position.count;
    part->vertices = mesh->vertices;
    mesh->has_uv = mesh->has_uv || a->uv.number;
    mesh->has_normals = mesh->has_normals && a->normal.number;
    mesh->multiplies = true;
    if (a->color.number && !(p->has_uv && (m.texture || m.glow_texture)))
        mesh->has_colors = true;
    free(skin.matrix);
    return true;
}

/* Corner k of triangle i; strips turn every second one round. */
static size_t corner(int mode, size_t i, size_t k)
{
    if (mode == FAN)
        return k == 0 ? i + 1 : k == 1 ? i + 2 : 0;
    if (mode == STRIP)
        return i + (k && i % 2 ? 3 - k : k);
    return 3 * i + k;
}

struct drawn {
    const json_t *json;
    int mode;
    size_t vertices; /* the last of the mesh */
    bool mirrored;
};

static bool put_triangles(struct gltf *g, struct mesh *mesh,
                          const struct drawn *d, const struct gltf_array *index)
{
    const size_t count = d->mode == TRIANGLES ? index->count / 3
                         : index->count > 2   ? index->count - 2
                                              : 0;
    const size_t first = mesh->vertices - d->vertices;
    for (size_t i = 0; i < count; i++) {
        uint32_t *to = mesh->triangle[mesh->triangles++];
        for (size_t k = 0; k < 3; k++) {
            const size_t n = corner(d->mode, i, k);
            const double v = index->number ? index->number[n] : (double)n;
            if (v >= (double)d->vertices)
                return gltf_refuse_in(g, d->json,
                                      "index %.0f is out of range: the "
                                      "primitive has %zu vertices",
                                      v, d->vertices);
            to[d->mirrored ? 2 - k : k] = (uint32_t)(first + (size_t)v);
        }
    }
    mesh->part[mesh->parts - 1].triangles = mesh->triangles;
    return true;
}

/* Is all of it below the cutoff of its material? No texture makes it more. */
static bool is_cut_away(const struct gltf_material *m,
                        const struct attributes *a)
{
    const struct gltf_array *c = &a->color;
    double most = c->number && c->components == 4 ? 0 : 1;
    for (size_t i = 0; most < 1 && i < c->count; i++)
        most = fmax(most, c->number[4 * i + 3]);
    const double alpha = fmin(fmax(most * m->color[3], 0), 1);
    return m->material.alpha == MESH_CUT_OUT &&
           (int)(alpha * 255 + 0.5) < m->material.cutoff;
}

static bool add(struct gltf *g, struct mesh *mesh,
                const struct gltf_primitive *p, struct gltf_material *material,
                struct attributes *a)
{
    const json_int_t own = gltf_index(g, p->json, "mode");
    const int mode = own < 0 ? TRIANGLES : own > FAN ? FAN + 1 : (int)own;
    const json_int_t indices = gltf_index(g, p->json, "indices");
    struct gltf_array index = {NULL, 0, 1};
    if (!read_all(g, p, material, a))
        return false;
    a->one_color = a->color.number && is_one_color(&a->color);
    index.count = a->position.count;
    if (mode > FAN)
        return gltf_refuse_in(g, p->json,
                              "a primitive has the mode %lld: expected 0 to 6",
                              (long long)own);
    if (indices >= 0 && !gltf_indices(g, indices, &index))
        return false;
    if (is_cut_away(material, a)) {
        g->is_cut_away = true;
        free(index.number);
        return g->good;
    }
    if (mode < TRIANGLES) {
        const unsigned long n = index.count;
        g->points += mode == POINTS ? n : 0;
        g->lines += mode == LINES        ? n / 2
                    : mode == LOOP       ? n
                    : mode == LINE_STRIP ? n - 1
                                         : 0;
        free(index.number);
        return true;
    }
    const struct drawn drawn = {p->json, mode, a->position.count,
                                gltf_determinant(p->world) < 0};
    const bool done = make_room(g, mesh, a->position.count, index.count) &&
                      put_vertices(g, mesh, p, material, a) &&
                      put_triangles(g, mesh, &drawn, &index);
    free(index.number);
    return done;
}

bool gltf_add(struct gltf *g, struct mesh *mesh, const struct gltf_primitive *p,
              struct gltf_material *material)
{
    struct attributes a;
    memset(&a, 0, sizeof(a));
    const bool done = add(g, mesh, p, material, &a);
    free_attributes(&a);
    return done && g->good;
}
