/* The commands of scene scripts, one row of a table each. Only for scene*.c. */
#ifndef SIM_SCENE_COMMANDS_H
#define SIM_SCENE_COMMANDS_H

#include "core/asset/font_asset.h"
#include "core/paint/color_ramp.h"
#include "core/paint/paint_texture.h"
#include "core/pel.h"
#include "scene.h"

struct scene_meshes;
struct scene_paints;
struct scene_pen;
struct scene_stage;

/* Makes the paint in force, in the pen's memory. */
typedef const struct pel_paint *scene_make_paint(const struct scene_pen *pen);

/* What commands change and shapes use, while a scene is drawn. */
struct scene_pen {
    struct pel_surface *surface;
    struct pel_flat flat;
    pel_color corner[3];    /* of paint vertex */
    bool by_vertex;         /* paint vertex is in force */
    bool collinear_line;    /* a triangle without area is a line */
    scene_make_paint *make; /* of any other paint, from these values; or NULL */
    const int32_t *values;
    size_t value_count;
    enum pel_spread spread;
    enum pel_wrap wrap;
    uint16_t phase; /* of radial gradients */
    bool bilinear, dither;
    struct scene_paints *paints; /* memory for a paint */
    struct pel_rect clip;
    const struct scene_assets *assets;
    const struct pel_font_asset *font; /* in force, or NULL */
    bool failed; /* a mesh was short of memory, or a light one too many */
    struct scene_stage *stage; /* of commands that SCENE_STAGE marks */
    void *scratch;             /* for the largest polygon of the scene */
    size_t scratch_size;
};

enum scene_role {
    SCENE_CANVAS,       /* first, and once */
    SCENE_BANDS,        /* splits the drawing */
    SCENE_STATE,        /* anything else that is no shape */
    SCENE_WHOLE,        /* reads pixels of any place: not in bands */
    SCENE_STAGE,        /* what meshes need: done while the script is read */
    SCENE_MESH,         /* a shape that takes no paint */
    SCENE_PAINT,        /* a paint that every shape takes */
    SCENE_PAINT_VERTEX, /* a paint that triangles alone take */
    SCENE_TRIANGLE,
    SCENE_SHAPE,
    SCENE_FONT, /* what text needs */
    SCENE_TEXT
};

/* Kinds of arguments, one letter each in scene_command.kinds; `*` at the end
 * repeats the last two any number of times, `+` the last three. */
enum scene_kind {
    KIND_COORDINATE = 'p', /* decimal pixels, to sub-pixels */
    KIND_LENGTH = 'l',     /* the same, 0 to 32,767 px */
    KIND_PIXEL = 'i',      /* whole, -32,768 to 32,767 */
    KIND_COUNT = 'n',      /* whole, 0 to 32,767 */
    KIND_SIZE = 's',       /* whole, 1 to 32,767 */
    KIND_COLOR = 'c',      /* #rrggbb or #rrggbbaa */
    KIND_WAY = 'w',        /* decimal, 0 to 1, to 65,536ths */
    KIND_TURN = 't',       /* decimal turns, 0 to 1, to turns / 65,536 */
    KIND_BYTE = 'b',       /* whole, 0 to 255 */
    KIND_PLACE = 'x',      /* decimal, -16,384 to 16,384, to 65,536ths */
    KIND_FACTOR = 'k',     /* decimal, 0 to less than 16, to 65,536ths */
    KIND_MEASURE = 'm',    /* decimal, above 0 to 16,384, to 65,536ths */
    KIND_SHININESS = 'e',  /* whole, 1 to 256 */
    KIND_CHOICE = 'o',     /* a name of the usage A|B|C; its index there */
    KIND_FILE = 'Q',       /* its path's index among the texts */
    KIND_MESH = 'M',       /* a file or MESH_BUILTIN; its index in assets */
    KIND_FONT = 'F',       /* a file; its index in scene_assets */
    KIND_PICTURE = 'P',    /* a file; its index there */
    KIND_TEXT = 'T',       /* in quotes; its index there */
    KIND_FORMAT = 'f'      /* a name; its index in format_names */
};

struct scene_command {
    const char *name;  /* one word or more */
    const char *kinds; /* of the arguments after it */
    const char *usage; /* the same for people */
    enum scene_role role;
    void (*draw)(struct scene_pen *pen, const int32_t *v, size_t n);
    /* What is wrong with these arguments, or NULL. May be NULL itself. */
    const char *(*check)(const int32_t *v, size_t n);
};

/* The paint in force, dithered when that is; good until the next call. */
const struct pel_paint *scene_paint(const struct scene_pen *pen);

/* Another paint, dithered when that is in force. */
const struct pel_paint *scene_dithered(const struct scene_pen *pen,
                                       const struct pel_paint *paint);

/* All commands, in tables that end with the name NULL; the last table is NULL.
 */
extern const struct scene_command scene_commands[], scene_shapes[],
    scene_images[], scene_paint_commands[], scene_mesh_commands[];
extern const struct scene_command *const scene_tables[];

/* One argument of a kind, from its word. False, with a message, when it is not
 * one. */
struct scene_place {
    const char *path;
    long line;
    const struct scene_command *command;
    struct scene_assets *assets;
    const struct scene_stage *stage;
};
bool scene_argument(const struct scene_place *place, enum scene_kind kind,
                    const char *word, int32_t *value);

#endif
