#include "sim/mesh/mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "sim/cli/child.h"
#include "sim/cli/message.h"
#include "sim/cli/text_line.h"
#include "sim/mesh/gltf.h"
#include "sim/mesh/vector.h"

bool mesh_init(struct mesh *mesh, uint32_t vertices, uint32_t triangles,
               uint32_t parts)
{
    static const struct mesh_material plain = {.color = PEL_RGB(255, 255, 255),
                                               .tint = PEL_RGB(255, 255, 255),
                                               .wrap_u = PEL_WRAP_REPEAT,
                                               .wrap_v = PEL_WRAP_REPEAT};
    memset(mesh, 0, sizeof(*mesh));
    mesh->vertex = calloc(vertices, sizeof(*mesh->vertex));
    mesh->triangle = calloc(triangles, sizeof(*mesh->triangle));
    mesh->part = calloc(parts, sizeof(*mesh->part));
    if (!mesh->vertex || !mesh->triangle || !mesh->part) {
        mesh_free(mesh);
        return message_error("no memory for a mesh of %u vertices and %u "
                             "triangles",
                             vertices, triangles);
    }
    mesh->vertices = vertices;
    mesh->triangles = triangles;
    mesh->parts = parts;
    for (uint32_t i = 0; i < parts; i++)
        mesh->part[i] = (struct mesh_part){vertices, triangles, true, plain};
    return true;
}

void mesh_free(struct mesh *mesh)
{
    free(mesh->vertex);
    free(mesh->triangle);
    free(mesh->part);
    for (size_t i = 0; i < mesh->textures; i++) {
        free(mesh->texture[i].path);
        free(mesh->texture[i].bytes);
    }
    free(mesh->texture);
    memset(mesh, 0, sizeof(*mesh));
}

/* Also false for a NaN. */
static bool within(const double *value, int n, double limit)
{
    for (int i = 0; i < n; i++)
        if (!(fabs(value[i]) <= limit))
            return false;
    return true;
}

bool mesh_check(const struct mesh *mesh, const char *path)
{
    for (uint32_t i = 0; i < mesh->triangles; i++)
        for (int k = 0; k < 3; k++)
            if (mesh->triangle[i][k] >= mesh->vertices)
                return message_error_at(path, 0,
                                        "triangle %u names vertex %u; the mesh "
                                        "has %u, counted from 0",
                                        i, mesh->triangle[i][k],
                                        mesh->vertices);
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        const double *at = mesh->vertex[i].position, *uv = mesh->vertex[i].uv;
        if (!within(at, 3, MESH_LIMIT))
            return message_error_at(path, 0,
                                    "vertex %u lies at (%g, %g, %g); legal "
                                    "are coordinates up to %g",
                                    i, at[0], at[1], at[2], MESH_LIMIT);
        if (!within(uv, 2, 1e6))
            return message_error_at(path, 0,
                                    "vertex %u has uv (%g, %g); legal is -1e6 "
                                    "to 1e6",
                                    i, uv[0], uv[1]);
    }
    return true;
}

void mesh_box(const struct mesh *mesh, double low[3], double high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (uint32_t i = 0; i < mesh->vertices; i++) {
            low[k] = fmin(low[k], mesh->vertex[i].position[k]);
            high[k] = fmax(high[k], mesh->vertex[i].position[k]);
        }
    }
}

unsigned mesh_byte(double linear)
{
    const double v = linear <= 0.0031308 ? linear * 12.92
                                         : 1.055 * pow(linear, 1 / 2.4) - 0.055;
    return v > 0 ? v < 1 ? (unsigned)(v * 255 + 0.5) : 255 : 0;
}

double mesh_linear(unsigned byte)
{
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

bool mesh_is_builtin(const char *path)
{
    const char prefix[] = MESH_BUILTIN_PREFIX;
    return strncmp(path, prefix, sizeof(prefix) - 1) == 0;
}

/* Of assimp's readers only those of XML and .x skip a mark of UTF-8; that of
 * .obj leaves out the first line without a message. Only XML may be UTF-16. */
static bool check_mark(const char *path)
{
    char start[8];
    const size_t n = text_start(path, start, sizeof(start));
    const char *text = start + byte_order_mark(start);
    const bool little = n > 3 && memcmp(start, "\xFF\xFE", 2) == 0;
    const bool big = n > 3 && memcmp(start, "\xFE\xFF", 2) == 0;
    if ((little && start[2] != '<') || (big && start[3] != '<'))
        return message_error_at(path, 0,
                                "is text of UTF-16: expected UTF-8 (`iconv -f "
                                "UTF-16 -t UTF-8`)");
    return n == 0 || text == start || *text == '<' ||
           strncmp(text, "xof ", 4) == 0 ||
           message_error_at(path, 0,
                            "begins with a UTF-8 byte order mark, which its "
                            "format does not have: expected the same without "
                            "it (`sed -i '1s/^\\xEF\\xBB\\xBF//' %s`)",
                            path);
}

/* Readers look at the beginning first, some open files again: what a pipe has
 * would be gone. */
static bool check_kind(const char *path)
{
    struct stat about;
    return stat(path, &about) != 0 || S_ISREG(about.st_mode) ||
           S_ISDIR(about.st_mode) ||
           message_error_at(path, 0,
                            "is a pipe or a device: expected a regular file, "
                            "since meshes are read in parts");
}

static bool put_mesh(const void *path, FILE *out)
{
    struct mesh mesh = {0};
    if (!check_kind(path) || !check_mark(path) ||
        !(gltf_is_file(path) ? gltf_load : mesh_load_file)(&mesh, path))
        return false;
    child_put(out, &mesh, sizeof(mesh));
    child_put(out, mesh.vertex, mesh.vertices * sizeof(*mesh.vertex));
    child_put(out, mesh.triangle, mesh.triangles * sizeof(*mesh.triangle));
    child_put(out, mesh.part, mesh.parts * sizeof(*mesh.part));
    child_put(out, mesh.texture, mesh.textures * sizeof(*mesh.texture));
    for (size_t i = 0; i < mesh.textures; i++) {
        const struct mesh_texture *t = &mesh.texture[i];
        child_put(out, t->path, strlen(t->path) + 1);
        child_put(out, t->bytes, t->size);
    }
    mesh_free(&mesh);
    return true;
}

static bool get_mesh(struct mesh *mesh, FILE *in)
{
    size_t size;
    bool good = true;
    struct mesh *counts = child_get(in, &size, &good);
    if (!counts)
        return false;
    *mesh = *counts;
    free(counts);
    mesh->vertex = child_get(in, &size, &good);
    mesh->triangle = child_get(in, &size, &good);
    mesh->part = child_get(in, &size, &good);
    mesh->texture = child_get(in, &size, &good);
    for (size_t i = 0; good && i < mesh->textures; i++) {
        struct mesh_texture *t = &mesh->texture[i];
        t->path = child_get(in, &size, &good);
        t->bytes = child_get(in, &t->size, &good);
    }
    if (!good) /* what they point to was the child's */
        mesh->textures = 0;
    return good;
}

/* Nothing would be shown, mostly as the file was not understood. */
static bool check_area(const struct mesh *mesh, const char *path)
{
    for (uint32_t i = 0; i < mesh->triangles; i++) {
        double normal[3];
        mesh_facet(mesh, mesh->triangle[i], normal);
        if (normal[0] != 0 || normal[1] != 0 || normal[2] != 0)
            return true;
    }
    return message_error_at(path, 0, "none of %u triangles has an area",
                            mesh->triangles);
}

bool mesh_load(struct mesh *mesh, const char *path)
{
    memset(mesh, 0, sizeof(*mesh));
    FILE *in = mesh_is_builtin(path) ? NULL : child_run(path, put_mesh, path);
    const bool read = mesh_is_builtin(path) ? mesh_load_builtin(mesh, path)
                                            : in && get_mesh(mesh, in);
    if (in)
        fclose(in);
    const bool done = read && mesh_check(mesh, path) &&
                      check_area(mesh, path) && mesh_weld(mesh) &&
                      (mesh->has_normals || mesh_normals(mesh, MESH_CREASE));
    for (uint32_t i = 0; done && i < mesh->vertices; i++)
        vector_normalise(mesh->vertex[i].normal);
    if (!done)
        mesh_free(mesh);
    return done;
}
