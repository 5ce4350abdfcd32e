/* Triangle meshes on the host, in world units, right-handed, y up. */
#ifndef SIM_MESH_MESH_H
#define SIM_MESH_MESH_H

#include <stdbool.h>
#include <stddef.h>

#include "core/paint/paint_texture.h"

struct mesh_vertex {
    double position[3]; /* world units, at most MESH_LIMIT in size */
    double normal[3];   /* unit length, or all 0 where there is no direction */
    double uv[2];       /* of the texture; v = 0 is its first row */
    pel_color color;    /* opaque */
};

/* What the alpha of a texture means. */
enum mesh_alpha { MESH_OPAQUE, MESH_CUT_OUT, MESH_BLENDED };

struct mesh_material {
    char name[64];
    pel_color color;       /* where no texture lies; its alpha is that of all */
    pel_color tint;        /* multiplies the texture, alpha too */
    uint32_t texture;      /* 0: none; else its number in the mesh, from 1 on */
    bool is_linear;        /* in light, not in bytes: by factor, not by tint */
    bool is_colored;       /* the vertices' colours multiply it too */
    bool is_unlit;         /* shows its colours without light */
    double factor[4];      /* red, green, blue, alpha, linear */
    double glow[3];        /* is added, linear */
    uint32_t glow_texture; /* multiplies it; 0: none */
    enum mesh_alpha alpha;
    uint16_t cutoff; /* MESH_CUT_OUT: the least alpha drawn; 256: none is */
    enum pel_wrap wrap_u, wrap_v;
    bool is_placed;  /* uv of the file are multiplied and moved: */
    double place[4]; /* scale of u and v, and offset; done to the vertices */
};

struct mesh_part {
    uint32_t vertices, triangles; /* where it ends: struct pel_mesh_part */
    bool has_uv;
    struct mesh_material material;
};

/* The path of a picture file; or, where there are bytes, a file inside the mesh
 * file and a name for it. */
struct mesh_texture {
    char *path;
    void *bytes;
    size_t size;
};

/* Owns everything it points to; {0} is an empty mesh. */
struct mesh {
    struct mesh_vertex *vertex;
    uint32_t (*triangle)[3]; /* indices of vertices, from 0 */
    struct mesh_part *part;
    struct mesh_texture *texture;
    uint32_t vertices, triangles, parts;
    uint32_t joined; /* vertices of the file that were the same as others */
    size_t textures;
    bool has_normals, made_normals, has_uv;
    bool has_colors; /* per vertex in the file, not those of a material */
    bool multiplies; /* as glTF does it: colours of the vertices by texels */
};

/* Coordinates beyond this are refused: nothing can be projected there. */
#define MESH_LIMIT 1e15

/* The prefix of the names of built-in meshes, the one to take where none is
 * named, and all: a vase of 8,448 triangles and one of 220. */
#define MESH_BUILTIN_PREFIX "builtin:"
#define MESH_BUILTIN MESH_BUILTIN_PREFIX "vase"
#define MESH_BUILTINS MESH_BUILTIN ", " MESH_BUILTIN "-small"

bool mesh_is_builtin(const char *path);

/* A mesh of that many zeroed vertices and triangles, 1..2^28 each, and parts of
 * an opaque, white material that end where it does. False, with a message on
 * standard error, when memory is short. */
bool mesh_init(struct mesh *mesh, uint32_t vertices, uint32_t triangles,
               uint32_t parts);
void mesh_free(struct mesh *mesh);

/* Reads any format that assimp reads, or a built-in one: node transforms
 * applied, triangles only, vertices that are the same in all they have joined.
 * Normals of the file are brought to unit length; where it has none, they are
 * made from the faces. A message counts what is left out: points, lines,
 * polygons that cannot be cut into triangles. False, with a message on standard
 * error, when the file cannot be read, is malformed, or assimp was missing at
 * build time.
 */
bool mesh_load(struct mesh *mesh, const char *path);

/* True when assimp reads files with the ending of this name, the name has none,
 * or this build has no assimp. */
bool mesh_ending_known(const char *path);

/* True when this build reads mesh files, not only MESH_BUILTIN. */
bool mesh_files_supported(void);

/* True when indices, coordinates and uv are legal; false with a message that
 * names `path`, the triangle and its index, or the vertex. */
bool mesh_check(const struct mesh *mesh, const char *path);

/* The box around its vertices. */
void mesh_box(const struct mesh *mesh, double low[3], double high[3]);

/* Makes normals: at each corner of a triangle the mean of the faces at that
 * place, weighted by area, but for those that are turned from the triangle's
 * own by more than `crease` degrees; 0 where it has no direction. So a seam of
 * the texture is no edge of the mesh, and the two sides of a sheet do not
 * cancel out. Of places with more than 4,096 corners it is the mean of all.
 * Vertices whose corners differ become several. False, with a message, when
 * memory is short. */
#define MESH_CREASE 120.0 /* where nobody says another */
bool mesh_normals(struct mesh *mesh, double crease);

/* The normal of a triangle, as long as twice its area. */
void mesh_facet(const struct mesh *mesh, const uint32_t index[3],
                double normal[3]);

/* Joins vertices of a part that are the same in all they have; the first of
 * each stays. False, with a message, when memory is short. */
bool mesh_weld(struct mesh *mesh);

/* Parts of mesh_load, in files of their own. */
bool mesh_load_file(struct mesh *mesh, const char *path);
bool mesh_load_builtin(struct mesh *mesh, const char *path);

/* Of a channel that is linear, 0..1, the byte by the curve of sRGB; and back.
 */
unsigned mesh_byte(double linear);
double mesh_linear(unsigned byte);

/* The materials of mesh files, as assimp reads them. */
struct aiColor4D;
struct aiMaterial;
struct aiScene;

pel_color material_byte_color(const struct aiColor4D *color);

/* Sets the material, and adds its texture to the mesh unless it is there:
 * `path` is that of the mesh file. False, with a message, when memory is short.
 */
bool material_read(struct mesh_material *to, struct mesh *mesh,
                   const struct aiScene *scene, const struct aiMaterial *from,
                   const char *path);

#endif
