/* Scenes and nodes (chapter 3.5): every primitive where a node shows it. */
#include "sim/mesh/gltf.h"

#include "sim/cli/message.h"
#include "sim/image/picture.h"

#ifdef HAVE_JANSSON
#include <stdlib.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/mesh/vector.h"

void gltf_multiply(const double a[16], const double b[16], double to[16])
{
    for (int i = 0; i < 16; i++) {
        to[i] = 0;
        for (int k = 0; k < 4; k++)
            to[i] += a[i % 4 + 4 * k] * b[i / 4 * 4 + k];
    }
}

double gltf_determinant(const double m[16])
{
    double a[3] = {m[0], m[1], m[2]}, b[3] = {m[4], m[5], m[6]}, c[3];
    vector_cross(a, b, c);
    return c[0] * m[8] + c[1] * m[9] + c[2] * m[10];
}

void gltf_turn_normal(const double m[16], const double from[3], double to[3])
{
    const double sign = gltf_determinant(m) < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++) {
        to[k] = 0;
        for (int i = 0; i < 3; i++) {
            const int r = (k + 1) % 3, s = (k + 2) % 3;
            const int c = (i + 1) % 3 * 4, d = (i + 2) % 3 * 4;
            to[k] +=
                sign * from[i] * (m[r + c] * m[s + d] - m[r + d] * m[s + c]);
        }
    }
}

/* A translation, a turn by a quaternion, a scale; or all in one. */
bool gltf_node_matrix(struct gltf *g, const json_t *node, double to[16])
{
    double t[3] = {0, 0, 0}, q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
    if (gltf_numbers(g, node, "matrix", to, 16))
        return true;
    gltf_numbers(g, node, "translation", t, 3);
    gltf_numbers(g, node, "rotation", q, 4);
    gltf_numbers(g, node, "scale", s, 3);
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double turn[3][3] = {
        {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
        {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
        {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
    for (int i = 0; i < 16; i++)
        to[i] = i == 15     ? 1
                : i >= 12   ? t[i - 12]
                : i % 4 < 3 ? turn[i / 4][i % 4] * s[i / 4]
                            : 0;
    return g->good;
}

/* Of the whole file, in the order of the nodes. */
struct found {
    struct gltf *g;
    struct gltf_primitive *primitive;
    size_t count;
};

static bool find_in_mesh(struct found *f, const json_t *node, json_int_t mesh,
                         const double world[16])
{
    struct gltf *g = f->g;
    struct gltf_primitive p = {.mesh = gltf_at(g, "meshes", mesh),
                               .node = node};
    const json_t *list = gltf_list(g, p.mesh, "primitives");
    memcpy(p.world, world, sizeof(p.world));
    for (size_t i = 0; i < json_array_size(list) && g->good; i++) {
        p.json = json_array_get(list, i);
        p.material = gltf_index(g, p.json, "material");
        if (f->count >= 1 << 20)
            return gltf_refuse(g, "shows more than 2^20 primitives: expected "
                                  "no more");
        if (g->good && !list_add(&f->primitive, &f->count, &p, sizeof(p)))
            return false;
    }
    return g->good;
}

/* The number of a node in a list; -1, with a message, when there is none. */
static json_int_t node_of(struct gltf *g, const json_t *list, size_t i)
{
    const json_t *item = json_array_get(list, i);
    if (!json_is_integer(item))
        gltf_refuse(g,
                    "item %zu of a list of nodes is no whole number: "
                    "expected a list such as [0, 1]",
                    i);
    else if (gltf_at(g, "nodes", json_integer_value(item)))
        return json_integer_value(item);
    return -1;
}

/* A node has one parent: so none is shown twice, by a file that says so 2^40
 * times. */
static bool read_parents(struct gltf *g)
{
    const json_t *nodes = gltf_list(g, g->root, "nodes");
    const size_t count = json_array_size(nodes);
    g->parent = malloc((count + 1) * sizeof(*g->parent));
    if (!g->parent)
        return gltf_refuse(g, "no memory for %zu nodes", count);
    for (size_t i = 0; i < count; i++)
        g->parent[i] = GLTF_NO_PARENT;
    for (size_t i = 0; i < count; i++) {
        const json_t *children =
            gltf_list(g, json_array_get(nodes, i), "children");
        for (size_t k = 0; k < json_array_size(children); k++) {
            const json_int_t child = node_of(g, children, k);
            if (child < 0)
                return false;
            if (g->parent[child] != GLTF_NO_PARENT)
                return gltf_refuse(g,
                                   "nodes[%lld] is a child of nodes[%lld] "
                                   "and of nodes[%zu]: expected one parent",
                                   (long long)child,
                                   (long long)g->parent[child], i);
            g->parent[child] = (json_int_t)i;
        }
    }
    return g->good;
}

static bool find_below(struct found *f, json_int_t index,
                       const double above[16], int depth)
{
    struct gltf *g = f->g;
    const json_t *node = gltf_at(g, "nodes", index);
    const json_t *children = gltf_list(g, node, "children");
    double own[16], world[16];
    const json_int_t mesh = gltf_index(g, node, "mesh");
    if (depth > GLTF_DEPTH)
        return gltf_refuse_depth(g, index);
    if (!g->good || !gltf_node_matrix(g, node, own))
        return false;
    gltf_multiply(above, own, world);
    if (mesh >= 0 && !find_in_mesh(f, node, mesh, world))
        return false;
    for (size_t i = 0; i < json_array_size(children); i++)
        if (!find_below(f, node_of(g, children, i), world, depth + 1))
            return false;
    return true;
}

/* The nodes of the scene that is shown first. */
static bool find(struct found *f)
{
    static const double one[16] = {[0] = 1, [5] = 1, [10] = 1, [15] = 1};
    struct gltf *g = f->g;
    const json_int_t scene = gltf_index(g, g->root, "scene");
    if (!json_object_get(g->root, "scenes"))
        return gltf_refuse(g, "a mesh file without a scene: expected one");
    const json_t *shown = gltf_at(g, "scenes", scene < 0 ? 0 : scene);
    const json_t *nodes = gltf_list(g, shown, "nodes");
    for (size_t i = 0; i < json_array_size(nodes) && g->good; i++) {
        const json_int_t node = node_of(g, nodes, i);
        if (node < 0)
            return false;
        if (g->parent[node] != GLTF_NO_PARENT)
            return gltf_refuse(g,
                               "nodes[%lld] of the scene is a child, or "
                               "there twice: expected a root, once",
                               (long long)node);
        g->parent[node] = GLTF_IN_SCENE;
        if (!find_below(f, node, one, 0))
            return false;
    }
    return g->good;
}

static bool has_place(const struct gltf_primitive *p,
                      const struct gltf_material *m)
{
    char name[32];
    snprintf(name, sizeof(name), "TEXCOORD_%lld", (long long)m->place.set);
    return json_object_get(json_object_get(p->json, "attributes"), name);
}

/* The primitives of one material, with or without uv, are a part; those whose
 * texture is multiplied by a colour of their own are parts of their own. */
static bool add_parts(struct found *f, struct mesh *mesh, json_int_t material)
{
    struct gltf *g = f->g;
    struct gltf_material m;
    bool any = false;
    for (size_t i = 0; i < f->count; i++)
        any = any || f->primitive[i].material == material;
    if (!any)
        return true;
    if (!gltf_material(g, mesh, material, &m))
        return false;
    for (int uv = 0; uv < 2; uv++)
        for (size_t i = 0; i < f->count; i++) {
            struct gltf_primitive *p = &f->primitive[i];
            p->has_uv = has_place(p, &m);
            if (p->material == material && p->has_uv == uv &&
                !gltf_add(g, mesh, p, &m))
                return false;
        }
    return true;
}

static bool load(struct gltf *g, struct mesh *mesh)
{
    struct found f = {g, NULL, 0};
    const size_t materials =
        json_array_size(gltf_list(g, g->root, "materials"));
    if (!read_parents(g) || !find(&f))
        return false;
    mesh->has_normals = true;
    for (size_t i = 0; i < materials; i++)
        if (!add_parts(&f, mesh, (json_int_t)i))
            return false;
    if (!add_parts(&f, mesh, -1))
        return false;
    for (size_t i = 0; i < f.count; i++)
        if (f.primitive[i].material >= (json_int_t)materials)
            gltf_at(g, "materials", f.primitive[i].material);
    if (g->points || g->lines)
        message_error_at(g->path, 0,
                         "%lu points and %lu lines are left out: a mesh has "
                         "triangles",
                         g->points, g->lines);
    return g->good &&
           (mesh->triangles > 0 ||
            gltf_refuse(g, g->is_cut_away
                               ? "shows nothing: expected an alpha that is not "
                                 "below alphaCutoff"
                               : "a mesh file without triangles"));
}

bool gltf_load(struct mesh *mesh, const char *path)
{
    struct gltf g;
    memset(mesh, 0, sizeof(*mesh));
    if (!gltf_open(&g, path))
        return false;
    return g.is_old ? mesh_load_file(mesh, path) : load(&g, mesh);
}

#else

bool gltf_load(struct mesh *mesh, const char *path)
{
    (void)mesh;
    return message_error_at(
        path, 0,
        "this pel was built without jansson, which reads glTF: the package "
        "libjansson-dev brings it");
}

#endif

bool gltf_is_file(const char *path)
{
    return path_has_ending(path, " .gltf .glb ");
}
