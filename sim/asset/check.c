#include "sim/asset/import.h"

#include <string.h>

#include "sim/cli/message.h"

/* The kinds that an option is for; those that the table leaves out place,
 * light and colour what a pel2d file holds. */
static const struct use {
    const char *option;
    unsigned kinds; /* of enum import_kind */
    const char *what;
} uses[] = {
    {"name", IMPORT_MESH | IMPORT_PICTURE | IMPORT_FONT, "C assets"},
    {"format", IMPORT_PICTURE, "pictures"},
    {"normals", IMPORT_MESH, "C assets of meshes"},
    {"codes", IMPORT_FONT, "fonts"},
    {"texture-file", IMPORT_MESH | IMPORT_PEL2D, "meshes"},
    {"normals-from", IMPORT_MESH | IMPORT_PEL2D, "meshes"},
    {"shade", 0, "pel render"},
    {"transparency", 0, "pel render"},
    {"order", 0, "pel render"},
    {"cull", 0, "pel render"},
    {"mapping", 0, "pel render"},
    {"span", 0, "pel render"},
    {"background", IMPORT_PICTURE, "pictures"},
    {NULL, IMPORT_PEL2D, "an output .pel2d"},
};

static const char *name_of(enum import_kind kind)
{
    switch (kind) {
    case IMPORT_MESH:
        return "a C asset of a mesh holds the mesh itself";
    case IMPORT_PICTURE:
        return "this is a picture";
    case IMPORT_FONT:
        return "this is a font";
    default:
        return "a pel2d file holds triangles with Gouraud's colours";
    }
}

bool import_check(const struct options_given *given, enum import_kind kind)
{
    for (int i = 0; i < given->count; i++) {
        const struct use *use = uses;
        while (use->option && strcmp(use->option, given->names[i]) != 0)
            use++;
        if (!(use->kinds & (unsigned)kind))
            return message_error("--%s is for %s; %s", given->names[i],
                                 use->what, name_of(kind));
    }
    return true;
}
