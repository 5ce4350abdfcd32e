/* glTF 2.0: JSON by jansson; what the numbers and the materials mean is here,
 * by the chapters of the specification that the files name. */
#ifndef SIM_MESH_GLTF_H
#define SIM_MESH_GLTF_H

#include "sim/mesh/mesh.h"

#ifdef HAVE_JANSSON
#include <jansson.h>

struct gltf_bytes {
    const uint8_t *at; /* NULL: not read yet */
    size_t size;
};

/* What a node has that is no other one's child. */
enum { GLTF_NO_PARENT = -1, GLTF_IN_SCENE = -2 };

/* As many nodes may be above another one. */
enum { GLTF_DEPTH = 1000 };

struct gltf {
    const char *path;
    json_t *root;
    struct gltf_bytes chunk; /* the binary one of a .glb */
    struct gltf_bytes *buffer;
    json_int_t *parent;          /* of each node */
    bool good;                   /* false after the first message */
    bool is_old;                 /* of version 1 */
    bool is_cut_away;            /* something, by its alpha */
    unsigned long points, lines; /* elements that are left out */
    size_t room[2];              /* vertices and triangles of the mesh */
    json_int_t material;         /* of its last part */
};

/* Reads a file, its version and its extensions; buffers when they are asked
 * for. False, with a message. */
bool gltf_open(struct gltf *g, const char *path);

/* What is said first is said alone; g->good becomes false. NULL. */
__attribute__((format(printf, 2, 3))) void *gltf_refuse(struct gltf *g,
                                                        const char *format,
                                                        ...);

/* The same, with where the object is in the file. */
__attribute__((format(printf, 3, 4))) void *gltf_refuse_in(struct gltf *g,
                                                           const json_t *object,
                                                           const char *format,
                                                           ...);

/* An object of the array of that name; NULL, with a message, when it is not
 * there. */
json_t *gltf_at(struct gltf *g, const char *array, json_int_t index);

/* Members: a number; a number of bytes or elements, whole and from 0 on; an
 * index from 0 on; the numbers of an array, n of them; without the member
 * nothing happens, the fallback, 0 or -1. */
double gltf_number(struct gltf *g, const json_t *object, const char *key,
                   double fallback);
double gltf_size(struct gltf *g, const json_t *object, const char *key);
json_int_t gltf_index(struct gltf *g, const json_t *object, const char *key);
bool gltf_numbers(struct gltf *g, const json_t *object, const char *key,
                  double *number, size_t n);

/* A member that is an array; NULL, and a message where it is something else. */
const json_t *gltf_list(struct gltf *g, const json_t *object, const char *key);

/* The object that is a member of a member, ..., whose names have points
 * between; NULL, and a message where it is something else. */
const json_t *gltf_member(struct gltf *g, const json_t *object,
                          const char *path);

/* Bytes of a buffer view, `offset` on from its first. NULL, with a message. */
const uint8_t *gltf_view(struct gltf *g, json_int_t view, double offset,
                         double size);
struct gltf_bytes gltf_whole_view(struct gltf *g, json_int_t view);

/* A URI: the bytes of data:, or the name of a file beside `path`, %20 and the
 * like decoded. malloc'ed. False: neither. */
bool gltf_uri(const char *path, const char *uri, struct gltf_bytes *bytes,
              char **file);

/* Numbers of an accessor, `components` each, count of them: normalized ones are
 * 0..1 or -1..1. NULL, with a message. */
struct gltf_array {
    double *number;
    size_t count;
    int components;
};
bool gltf_accessor(struct gltf *g, json_int_t index, struct gltf_array *array);

/* The same, of whole numbers from 0 on, one each. */
bool gltf_indices(struct gltf *g, json_int_t index, struct gltf_array *array);

/* How a texture lies on a mesh. */
struct gltf_place {
    json_int_t set;  /* of uv: TEXCOORD_n */
    double uv[2][3]; /* u, v, 1 -> u, v */
};

struct gltf_material {
    struct mesh_material material;
    struct gltf_place place;
    double color[4]; /* base color, linear */
};

/* Material -1 is the default. Adds its textures to the mesh. */
bool gltf_material(struct gltf *g, struct mesh *mesh, json_int_t index,
                   struct gltf_material *to);

/* Says that a node has more above it than GLTF_DEPTH. NULL. */
void *gltf_refuse_depth(struct gltf *g, json_int_t node);

/* 4 x 4 matrices, column by column as in the file. */
void gltf_multiply(const double a[16], const double b[16], double to[16]);
bool gltf_node_matrix(struct gltf *g, const json_t *node, double to[16]);

double gltf_determinant(const double m[16]);

/* A normal is turned by the matrix of the cofactors. */
void gltf_turn_normal(const double m[16], const double from[3], double to[3]);

/* A primitive where a node shows it. */
struct gltf_primitive {
    const json_t *json, *mesh, *node;
    double world[16];
    json_int_t material;
    bool has_uv;
};

/* What the joints of a skin do to vertices. */
struct gltf_skin {
    double (*matrix)[16]; /* malloc'ed; NULL: no skin */
    size_t count;
};
bool gltf_skin(struct gltf *g, const json_t *skin, struct gltf_skin *to);

/* Adds the vertices and triangles of one to the mesh. */
bool gltf_add(struct gltf *g, struct mesh *mesh, const struct gltf_primitive *p,
              struct gltf_material *material);
#endif

/* By its name's ending. */
bool gltf_is_file(const char *path);

/* As mesh_load_file; files of version 1 are assimp's. */
bool gltf_load(struct mesh *mesh, const char *path);

#endif
