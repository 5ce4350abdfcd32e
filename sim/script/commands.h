/* The commands of scripts, one row of a table each. Only for script*.c. */
#ifndef SIM_SCRIPT_COMMANDS_H
#define SIM_SCRIPT_COMMANDS_H

#include "core/asset/font_asset.h"
#include "core/paint/color_ramp.h"
#include "core/paint/paint_texture.h"
#include "core/pel.h"
#include "sim/script/script.h"

struct script_meshes;
struct script_paints;
struct script_pen;
struct script_scene;

/* Makes the paint in force, in the pen's memory. */
typedef const struct pel_paint *script_make_paint(const struct script_pen *pen);

/* What commands change and shapes use, while a script is drawn. */
struct script_pen {
    struct pel_surface *surface;
    struct pel_flat flat;
    pel_color corner[3]; /* of paint vertex */
    bool by_vertex;      /* paint vertex is in force */
    bool collinear_line; /* a triangle without area is a line */
    script_make_paint
        *make; /* of any other paint, from these values; or NULL */
    const int32_t *values;
    size_t value_count;
    enum pel_spread spread;
    enum pel_wrap wrap;
    uint16_t phase; /* of radial gradients */
    bool bilinear, dither;
    struct script_paints *paints; /* memory for a paint */
    struct pel_rect clip;
    const struct script_assets *assets;
    const struct pel_font_asset *font; /* in force, or NULL */
    bool failed; /* a mesh was short of memory, or a light one too many */
    struct script_scene *scene; /* of commands that SCRIPT_SCENE marks */
    void *scratch;              /* for the largest polygon of the script */
    size_t scratch_size;
};

enum script_role {
    SCRIPT_CANVAS,       /* first, and once */
    SCRIPT_BANDS,        /* splits the drawing */
    SCRIPT_STATE,        /* anything else that is no shape */
    SCRIPT_WHOLE,        /* reads pixels of any place: not in bands */
    SCRIPT_SCENE,        /* what meshes need: done while the script is read */
    SCRIPT_MESH,         /* a shape that takes no paint */
    SCRIPT_PAINT,        /* a paint that every shape takes */
    SCRIPT_PAINT_VERTEX, /* a paint that triangles alone take */
    SCRIPT_TRIANGLE,
    SCRIPT_SHAPE,
    SCRIPT_FONT, /* what text needs */
    SCRIPT_TEXT
};

/* Kinds of arguments, one letter each in script_command.kinds; `*` at the end
 * repeats the last two any number of times, `+` the last three. */
enum script_kind {
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
    KIND_FONT = 'F',       /* a file; its index in script_assets */
    KIND_PICTURE = 'P',    /* a file; its index there */
    KIND_TEXT = 'T',       /* in quotes; its index there */
    KIND_FORMAT = 'f'      /* a name; its index in format_names */
};

struct script_command {
    const char *name;  /* one word or more */
    const char *kinds; /* of the arguments after it */
    const char *usage; /* the same for people */
    enum script_role role;
    void (*draw)(struct script_pen *pen, const int32_t *v, size_t n);
    /* What is wrong with these arguments, or NULL. May be NULL itself. */
    const char *(*check)(const int32_t *v, size_t n);
};

/* The paint in force, dithered when that is; good until the next call. */
const struct pel_paint *script_paint(const struct script_pen *pen);

/* Another paint, dithered when that is in force. */
const struct pel_paint *script_dithered(const struct script_pen *pen,
                                        const struct pel_paint *paint);

/* All commands, in tables that end with the name NULL; the last table is NULL.
 */
extern const struct script_command script_commands[], script_shapes[],
    script_images[], script_paint_commands[], script_mesh_commands[];
extern const struct script_command *const script_tables[];

/* One argument of a kind, from its word. False, with a message, when it is not
 * one. */
struct script_place {
    const char *path;
    long line;
    const struct script_command *command;
    struct script_assets *assets;
    const struct script_scene *scene;
};
bool script_argument(const struct script_place *place, enum script_kind kind,
                     const char *word, int32_t *value);

#endif
