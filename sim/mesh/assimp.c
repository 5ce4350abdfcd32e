#include "sim/mesh/mesh.h"

#include "sim/cli/message.h"
#include "sim/mesh/mend.h"

#ifdef HAVE_ASSIMP
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <errno.h>
#include <inttypes.h>
#include <string.h>
#include <unistd.h>

/* Triangles, v from the first row down. */
enum { IMPORT_FLAGS = aiProcess_Triangulate | aiProcess_FlipUVs };

bool mesh_files_supported(void)
{
    return true;
}

/* The contents of a scene: vertices are those of parts with triangles, and a
 * polygon counts as the triangles that it takes. */
struct counts {
    uint64_t vertices, triangles, lines, points;
};

static uint64_t triangles_of(const struct aiMesh *from)
{
    uint64_t n = 0;
    for (unsigned i = 0; i < from->mNumFaces; i++)
        if (from->mFaces[i].mNumIndices >= 3)
            n += from->mFaces[i].mNumIndices - 2;
    return n;
}

typedef void visit_mesh(const struct aiMesh *from,
                        const struct aiMatrix4x4 *to_world, void *context);

/* Visits meshes as often as nodes show them, a node before those below it. */
static void walk(const struct aiScene *scene, const struct aiNode *node,
                 const struct aiMatrix4x4 *above, visit_mesh *visit,
                 void *context)
{
    struct aiMatrix4x4 to_world = *above;
    aiMultiplyMatrix4(&to_world, &node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; i++)
        visit(scene->mMeshes[node->mMeshes[i]], &to_world, context);
    for (unsigned i = 0; i < node->mNumChildren; i++)
        walk(scene, node->mChildren[i], &to_world, visit, context);
}

static void walk_all(const struct aiScene *scene, visit_mesh *visit,
                     void *context)
{
    struct aiMatrix4x4 world;
    aiIdentityMatrix4(&world);
    if (scene->mRootNode)
        walk(scene, scene->mRootNode, &world, visit, context);
}

static void count_mesh(const struct aiMesh *from,
                       const struct aiMatrix4x4 *to_world, void *context)
{
    struct counts *c = context;
    const uint64_t triangles = triangles_of(from);
    (void)to_world;
    c->triangles += triangles;
    c->vertices += triangles ? from->mNumVertices : 0;
    for (unsigned i = 0; i < from->mNumFaces; i++) {
        c->lines += from->mFaces[i].mNumIndices == 2;
        c->points += from->mFaces[i].mNumIndices == 1;
    }
}

static struct counts count(const struct aiScene *scene)
{
    struct counts c = {0, 0, 0, 0};
    walk_all(scene, count_mesh, &c);
    return c;
}

/* Files have -0 and 0 for the same number: with 0 added it has no sign. */
static void set3(double to[3], const struct aiVector3D *from)
{
    to[0] = (double)from->x + 0.0;
    to[1] = (double)from->y + 0.0;
    to[2] = (double)from->z + 0.0;
}

/* The part that is being made: of the meshes of a material with or without
 * uv. */
struct making {
    const struct aiScene *scene;
    const char *path;
    struct mesh *mesh;
    struct mesh_part *part;
    unsigned material;
    bool uv, failed;
};

/* In the file v grows upward. */
static void place_uv(const double place[4], double uv[2])
{
    uv[0] = uv[0] * place[0] + place[2];
    uv[1] = 1 - ((1 - uv[1]) * place[1] + place[3]);
}

static void copy_vertices(const struct making *m, const struct aiMesh *from,
                          const struct aiMatrix4x4 *to_world)
{
    struct mesh_vertex *to = m->mesh->vertex + m->part->vertices;
    const bool moved = !aiMatrix4IsIdentity(to_world);
    struct aiMatrix3x3 turn;
    aiMatrix3FromMatrix4(&turn, to_world);
    aiMatrix3Inverse(&turn);
    aiTransposeMatrix3(&turn);
    for (unsigned i = 0; i < from->mNumVertices; i++, to++) {
        struct aiVector3D at = from->mVertices[i];
        if (moved)
            aiTransformVecByMatrix4(&at, to_world);
        set3(to->position, &at);
        if (from->mNormals) {
            at = from->mNormals[i];
            if (moved) {
                aiTransformVecByMatrix3(&at, &turn);
                aiVector3NormalizeSafe(&at);
            }
            set3(to->normal, &at);
        }
        if (m->uv) {
            to->uv[0] = (double)from->mTextureCoords[0][i].x + 0.0;
            to->uv[1] = (double)from->mTextureCoords[0][i].y + 0.0;
            if (m->part->material.is_placed)
                place_uv(m->part->material.place, to->uv);
        }
        to->color = from->mColors[0] && from->mColors[0][i].r >= 0
                        ? material_byte_color(&from->mColors[0][i])
                        : m->part->material.color | PEL_RGB(0, 0, 0);
    }
}

/* Mirrored triangles are turned round. */
static void copy_triangles(const struct making *m, const struct aiMesh *from,
                           bool mirrored)
{
    for (unsigned i = 0; i < from->mNumFaces; i++) {
        const struct aiFace *face = &from->mFaces[i];
        if (face->mNumIndices != 3)
            continue;
        uint32_t *to = m->mesh->triangle[m->part->triangles++];
        for (int k = 0; k < 3; k++)
            to[mirrored ? 2 - k : k] = face->mIndices[k] + m->part->vertices;
    }
}

static bool start_part(struct making *m)
{
    const struct aiMaterial none = {NULL, 0, 0};
    const struct aiMaterial *from = m->material < m->scene->mNumMaterials
                                        ? m->scene->mMaterials[m->material]
                                        : &none;
    struct mesh_part *part = &m->mesh->part[m->mesh->parts++];
    part->vertices = m->mesh->parts > 1 ? part[-1].vertices : 0;
    part->triangles = m->mesh->parts > 1 ? part[-1].triangles : 0;
    part->has_uv = m->uv;
    m->part = part;
    return material_read(&part->material, m->mesh, m->scene, from, m->path);
}

static void copy_mesh(const struct aiMesh *from,
                      const struct aiMatrix4x4 *to_world, void *context)
{
    struct making *m = context;
    struct mesh *mesh = m->mesh;
    const bool has_uv = from->mTextureCoords[0];
    const unsigned materials = m->scene->mNumMaterials;
    const unsigned material =
        from->mMaterialIndex < materials ? from->mMaterialIndex : materials;
    if (material != m->material || has_uv != m->uv || !triangles_of(from))
        return;
    if (!m->part && !start_part(m))
        m->failed = true;
    if (m->failed)
        return;
    copy_vertices(m, from, to_world);
    copy_triangles(m, from, aiMatrix4Determinant(to_world) < 0);
    m->part->vertices += from->mNumVertices;
    mesh->has_normals = mesh->has_normals && from->mNormals;
    mesh->has_uv = mesh->has_uv || has_uv;
    mesh->has_colors = mesh->has_colors || from->mColors[0];
}

static bool copy_parts(const struct aiScene *scene, const char *path,
                       struct mesh *mesh)
{
    struct making m = {.scene = scene, .path = path, .mesh = mesh};
    mesh->has_normals = true;
    mesh->parts = 0;
    for (unsigned i = 0; i < 2 * (scene->mNumMaterials + 1); i++) {
        m.material = i / 2;
        m.uv = i % 2;
        m.part = NULL;
        walk_all(scene, copy_mesh, &m);
    }
    return !m.failed;
}

/* assimp's own steps fail on a scene without faces. */
static bool check_counts(const struct counts *n, const char *path)
{
    if (n->triangles == 0)
        return message_error_at(path, 0, "a mesh file without triangles");
    return (n->vertices <= 1u << 28 && n->triangles <= 1u << 28) ||
           message_error_at(path, 0, "more than 2^28 vertices or triangles");
}

/* Some of assimp's readers put another vertex in the place of an index that is
 * out of range, and only log it. */
static void note_bad_index(const char *text, char *user)
{
    if (strstr(text, "ndex") && strstr(text, "out of range"))
        *user = 1;
}

/* Before anything is done with them: assimp's own steps trust the indices, and
 * a face without any ends them. */
static bool check_faces(const struct aiMesh *part, unsigned m, const char *path)
{
    for (unsigned i = 0; i < part->mNumFaces; i++) {
        const struct aiFace *face = &part->mFaces[i];
        if (face->mNumIndices == 0)
            return message_error_at(path, 0,
                                    "face %u of part %u has no vertices", i, m);
        for (unsigned k = 0; k < face->mNumIndices; k++)
            if (face->mIndices[k] >= part->mNumVertices)
                return message_error_at(
                    path, 0,
                    "face %u of part %u names vertex %u; the part has %u, "
                    "counted from 0",
                    i, m, face->mIndices[k], part->mNumVertices);
    }
    return true;
}

static bool check_indices(const struct aiScene *scene, const char *path)
{
    for (unsigned m = 0; m < scene->mNumMeshes; m++)
        if (!check_faces(scene->mMeshes[m], m, path))
            return false;
    return true;
}

/* The file as it is, and its counts; NULL, with a message, when it is not
 * right. */
static const struct aiScene *read_scene(const char *path, struct counts *n)
{
    char bad_index = 0;
    const struct aiLogStream log = {note_bad_index, &bad_index};
    aiAttachLogStream(&log);
    bool told;
    const struct aiScene *scene = mend_import(path, &told);
    aiDetachLogStream(&log);
    if (!scene) {
        if (!told)
            message_error_at(path, 0, "no mesh that can be read (%s)",
                             aiGetErrorString());
        return NULL;
    }
    if (bad_index)
        message_error_at(path, 0, "a face names a vertex that is out of range");
    *n = count(scene);
    if (!bad_index && check_indices(scene, path) && check_counts(n, path))
        return scene;
    aiReleaseImport(scene);
    return NULL;
}

bool mesh_ending_known(const char *path)
{
    const char *dot = strrchr(path, '.');
    return !dot || strchr(dot, '/') || aiIsExtensionSupported(dot);
}

bool mesh_load_file(struct mesh *mesh, const char *path)
{
    if (access(path, R_OK) != 0)
        return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    struct counts file;
    const struct aiScene *scene = read_scene(path, &file);
    if (!scene)
        return false;
    scene = aiApplyPostProcessing(scene, IMPORT_FLAGS); /* frees a wrong one */
    if (!scene)
        return message_error_at(path, 0, "no mesh that can be drawn (%s)",
                                aiGetErrorString());
    const struct counts drawn = count(scene);
    if (file.points || file.lines)
        message_error_at(path, 0,
                         "%" PRIu64 " points and %" PRIu64
                         " lines are left out: a mesh has triangles",
                         file.points, file.lines);
    if (drawn.triangles < file.triangles)
        message_error_at(path, 0,
                         "%" PRIu64 " of %" PRIu64
                         " triangles are lost where polygons were cut",
                         file.triangles - drawn.triangles, file.triangles);
    const bool done =
        check_counts(&drawn, path) &&
        mesh_init(mesh, (uint32_t)drawn.vertices, (uint32_t)drawn.triangles,
                  2 * (scene->mNumMaterials + 1)) &&
        copy_parts(scene, path, mesh);
    aiReleaseImport(scene);
    return done;
}

#else

bool mesh_files_supported(void)
{
    return false;
}

bool mesh_ending_known(const char *path)
{
    (void)path;
    return true;
}

bool mesh_load_file(struct mesh *mesh, const char *path)
{
    (void)mesh;
    return message_error_at(
        path, 0,
        "this pel was built without assimp, which the package libassimp-dev "
        "brings: expected " MESH_BUILTIN " and pel2d files");
}

#endif
