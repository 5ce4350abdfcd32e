/* Mesh files, written anew as the OBJ that assimp's reader gets right: numbers
 * and lines that it misses, colours of faces, options of textures. */
#ifndef SIM_MESH_MEND_H
#define SIM_MESH_MEND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* A file in memory, and what is written of it: vertices with colours have six
 * numbers, those without one in between MEND_NO_COLOR three times; materials
 * are all in one MTL. */
struct mend {
    const char *path;
    char *text; /* ended by a 0 */
    size_t size;
    long line; /* of the file, for messages; 0: it has none */
    FILE *obj, *mtl;
    bool colorless;    /* of all vertices */
    bool has_material; /* one has begun, of an MTL */
};

#define MEND_NO_COLOR (-1)

/* The name of a texture may begin with how it lies: four numbers that uv are
 * multiplied by, and that are added, u and v each, v upward. */
#define MEND_PLACE "\1%lf %lf %lf %lf\1"

/* One of these writes files of an ending, of PLY and STL those that are wanted:
 * that have colours of faces. False, with a message. A PLY is checked before:
 * what assimp would lose or not leave is refused. */
bool mend_obj(struct mend *m);
bool mend_off(struct mend *m);
bool mend_3mf(struct mend *m);
bool mend_ply(struct mend *m);
bool mend_ply_check(struct mend *m);
bool mend_ply_wanted(struct mend *m);
bool mend_stl(struct mend *m);
bool mend_stl_wanted(struct mend *m);

/* A corner of a face, a vertex of its own; and the face of the last of them,
 * which have what `like` has. */
struct mend_corner {
    double at[3], normal[3], uv[2];
    double color[3]; /* 0..1 or MEND_NO_COLOR */
    bool has_normal, has_uv;
};
void mend_white(struct mend *m); /* of what has no colour, as assimp has it */
void mend_corner(struct mend *m, const struct mend_corner *corner);
void mend_face(struct mend *m, long corners, const struct mend_corner *like);

/* The lines of a material file beside the mesh. */
bool mend_mtl(struct mend *m, const char *name);

/* The bytes of a part of a package of 3MF, malloc'ed; NULL: it cannot be read.
 */
unsigned char *mend_3mf_part(const char *path, const char *name, size_t *size);

/* Reads a file into text and size, within the limits. False without a message,
 * with errno for file_refuse. */
bool mend_read(struct mend *m, const char *path);

/* The same of a text, whose lines end as they do on any system. */
bool mend_read_lines(struct mend *m, const char *path);

/* Ends a line of text at its line feed; *at goes behind it, or becomes NULL at
 * the end of the text. Lines that end in a backslash are joined, comments,
 * blanks before and behind are left out; `names` holds the words whose lines
 * may have a # inside a name. */
char *mend_line(struct mend *m, char **at);

/* Reads n numbers at most. How many there were; -1 with a message when
 * something else was there, or a number that is not finite. */
int mend_numbers(const struct mend *m, const char *text, double *number, int n);

/* The bytes of the word that a text begins with, for a message: 80 at most. */
int mend_word(const char *text);

/* The path of a file that is named in another one: beside that, with the
 * folders of the name, or without those of another system. malloc'ed, or NULL.
 */
char *mend_path_beside(const char *path, const char *name);

/* Reads a mesh file, mended where that is known to be needed, and with all else
 * as aiImportFile does it. NULL: aiGetErrorString, or a message if *told. */
struct aiScene;
const struct aiScene *mend_import(const char *path, bool *told);

#endif
