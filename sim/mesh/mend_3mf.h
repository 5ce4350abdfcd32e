/* The parts of reading 3MF. Only for sim/mesh/mend_3mf*.c. */
#ifndef SIM_MESH_MEND_3MF_H
#define SIM_MESH_MEND_3MF_H

#include <expat.h>

#include "sim/mesh/mend.h"

struct texture {
    long id;
    char part[200]; /* of the package */
    bool is_clamped;
};

/* Of colors, or of places in a texture. */
struct group {
    long id, texture;  /* texture -1: none */
    size_t first, end; /* of the entries */
};

struct entry {
    double v[3]; /* red, green, blue; or u, v upward */
};

struct triangle {
    unsigned long vertex[3];
    long group;    /* -1: the object's */
    long color[3]; /* -1: none; the second and third: as the first */
};

struct component {
    long object;
    double place[12];
};

struct object {
    long id, group, color;
    size_t vertices, triangles, components; /* where they end */
};

struct package {
    struct mend *m;
    XML_Parser parser;
    char model[256]; /* the name of its part */
    double (*vertex)[3];
    struct texture *texture;
    struct group *group;
    struct entry *entry;
    struct triangle *triangle;
    struct component *component, *item;
    struct object *object;
    size_t vertices, textures, groups, entries, triangles, components, items,
        objects;
    size_t instances;        /* of objects */
    long material;           /* of the last triangle: a texture's id, or -1 */
    unsigned long colorless; /* triangles whose property is neither color nor
                                texture */
    bool bad;
};

/* Writes all that the build places. False, with a message. */
bool mend_3mf_put(struct package *p);

#endif
