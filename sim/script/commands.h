/* The commands of scripts, one row of a table each. For sim/script and
 * sim/view.
 *
 * A new one is a row in shapes.c, strokes.c, images.c, paints.c or
 * mesh_commands.c, with the function that it names, and a line of
 * sim/scenes/README.md; a new form of shape is a row of explain.c too. */
#ifndef SIM_SCRIPT_COMMANDS_H
#define SIM_SCRIPT_COMMANDS_H

#include "core/asset/outline_font_asset.h"
#include "core/paint/paint_texture.h"
#include "core/pel.h"
#include "core/raster/polygon.h"
#include "sim/script/script.h"

struct script_paints;
struct script_scene;

/* The state that commands change and shapes use, while a script is drawn. */
struct script_pen {
    struct pel_surface *surface;
    const struct script *script;
    const struct script_item *item;  /* that is drawn */
    const struct script_item *paint; /* in force; NULL: white */
    struct script_paints *paints;    /* memory for it */
    enum pel_spread spread;
    enum pel_wrap wrap;
    uint16_t phase; /* of radial gradients */
    uint8_t fewer;  /* cells of a gradient with stops: halved so often */
    bool bilinear, dither;
    uint8_t blend;       /* 0, or enum pel_blend_mode + 1 */
    bool collinear_line; /* a triangle without area is a line */
    bool smooth;         /* shapes that have a smooth twin */
    uint8_t cap, join;   /* of strokes: enum pel_cap, pel_join */
    int32_t dash[3];     /* its length, the gap, the phase; 0 0: none */
    struct pel_rect clip;
    const struct pel_font_asset *font;             /* in force, or NULL */
    const struct pel_outline_font_asset *outlines; /* the same */
    uint8_t align; /* of text of outlines: enum pel_text_align */
    bool failed;   /* there was too little memory, or a light is one too many */
    struct script_scene *scene; /* of commands that SCRIPT_SCENE marks, which
                                   do nothing when it is NULL */
    void *scratch;              /* for the largest polygon of the script */
    size_t scratch_size;
};

enum script_role {
    SCRIPT_CANVAS,       /* first, and once */
    SCRIPT_BANDS,        /* splits the drawing */
    SCRIPT_STATE,        /* anything else that is no shape */
    SCRIPT_SCENE,        /* settings of meshes: made while the script is read */
    SCRIPT_FONT,         /* what text needs */
    SCRIPT_PAINT,        /* a paint that every shape takes */
    SCRIPT_PAINT_VERTEX, /* a paint that triangles alone take */
    /* Those that follow draw. */
    SCRIPT_CLEAR,
    SCRIPT_WHOLE,    /* reads pixels anywhere: not in bands */
    SCRIPT_PICTURE,  /* what takes no paint: images, meshes */
    SCRIPT_TRIANGLE, /* what takes one: triangles even paint vertex */
    SCRIPT_SHAPE,
    SCRIPT_TEXT
};

/* What the values of a shape mean. */
enum script_form {
    FORM_NONE, /* it is no shape */
    FORM_TRIANGLE,
    FORM_POLYGON,
    FORM_ROUND, /* circle, ring, sector, arc: centre, radii, angles */
    FORM_ELLIPSE,
    FORM_RECTANGLE, /* with round corners, too */
    FORM_LINE,
    FORM_THICK_LINE
};

/* Kinds of arguments, one letter each in script_command.kinds; `*` at the end
 * repeats the last two any number of times, `+` the last three. Ranges are in
 * arguments.c. */
enum script_kind {
    KIND_COORDINATE = 'p', /* decimal pixels, as sub-pixels */
    KIND_LENGTH = 'l',     /* the same, not negative */
    KIND_PIXEL = 'i',
    KIND_COUNT = 'n',
    KIND_SIZE = 's',
    KIND_COLOR = 'c',
    KIND_POSITION = 'w', /* of a stop, 0 to 1, in 65,536ths */
    KIND_TURN = 't',     /* in 65,536ths */
    KIND_BYTE = 'b',
    KIND_PLACE = 'x',   /* world units, in 65,536ths */
    KIND_FACTOR = 'k',  /* in 65,536ths */
    KIND_MEASURE = 'm', /* above 0, in 65,536ths */
    KIND_TEXELS = 'u',  /* in 65,536ths */
    KIND_SHININESS = 'e',
    KIND_CHOICE = 'o', /* a name of the usage A|B|C; its index there */
    KIND_FORMAT = 'f', /* a name; its index in format_names */
    /* These are indices of the script's assets. */
    KIND_FONT = 'F',    /* a file */
    KIND_PICTURE = 'P', /* a file */
    KIND_ICON = 'I',    /* a file */
    KIND_MESH = 'M',    /* a file or one of MESH_BUILTINS */
    KIND_FILE = 'Q',    /* a file, whose path is kept as a text */
    KIND_TEXT = 'T'     /* in quotes */
};

struct script_command {
    const char *name;  /* one word or more */
    const char *kinds; /* of the arguments after it */
    const char *usage; /* the same for people */
    enum script_role role;
    void (*draw)(struct script_pen *pen, const int32_t *v); /* or NULL */
    /* Says what is wrong with these arguments, or returns NULL. May be NULL. */
    const char *(*check)(const int32_t *v, size_t n);
    /* Makes a paint of a paint command in the pen's memory. */
    void (*make)(const struct script_pen *pen, const int32_t *values);
    /* A setting, which the values are written to before `draw`: where it lies
     * in struct script_pen, or struct script_scene for SCRIPT_SCENE; bytes of
     * each value, 8 for doubles of 65,536ths, 0 for no setting; where the flag
     * lies that becomes true, 0 for none. */
    size_t offset, size, flag;
    enum script_form form;
    enum pel_fill_rule rule; /* of a polygon */
    bool closed;             /* of a stroke */
    bool outline;            /* draws the outline instead of the shape */
    const struct script_command *next; /* table, in the last row */
};

/* The part of a row that names a member of `values` values. */
#define SCRIPT_SETTING(type, member, values) \
    .offset = offsetof(type, member),        \
    .size = sizeof(((type *)NULL)->member) / (values)

/* A pen as scripts begin with it, on a surface. False, with a message, when
 * memory is short. */
bool script_pen_init(struct script_pen *pen, const struct script *script,
                     struct pel_surface *surface);
void script_pen_free(struct script_pen *pen);

/* Runs a command: makes its setting, chooses its paint, draws. */
void script_perform(struct script_pen *pen, const struct script_item *item);

/* The kind of a command's value i. */
char script_kind_of(const struct script_command *command, size_t i);

/* Adds an item; or the command of that name, with n values, which are legal: in
 * the units of their kinds. False, with a message, when memory is short. */
bool script_add_item(struct script *script, const struct script_item *item);
bool script_add(struct script *script, const char *name, const int32_t *values,
                size_t n);

/* Does the item draw with the paint in force? */
static inline bool script_is_painted(const struct script_item *item)
{
    return item->command->role >= SCRIPT_TRIANGLE;
}

/* The values of an item of the pen's script. */
static inline const int32_t *script_values(const struct script_pen *pen,
                                           const struct script_item *item)
{
    return pen->script->values + item->first;
}

/* Is the pixel (x, y) within the clip in force? */
bool script_clip_holds(const struct script_pen *pen, const int pixel[2]);

/* True when the item, a command that draws, covers the pixel (x, y) whatever
 * the clip. *color is the color there before, and then the one that the item
 * brings, with its alpha. `pen` holds the settings before the command. */
bool script_covers(const struct script_pen *pen, const struct script_item *item,
                   const int pixel[2], pel_color *color);

/* How much of the pixel the item covers whatever the clip, 0 to 255. */
uint32_t script_coverage(const struct script_pen *pen,
                         const struct script_item *item, const int pixel[2]);

/* The paint in force, blended and dithered when that is; good until the next
 * call. */
const struct pel_paint *script_paint(const struct script_pen *pen);

/* Of a path, a stroke, a text of outlines or an icon: tells, once, where a row
 * had more sides than there is room for. Other errors were found when it was
 * read. */
void script_finish(struct script_pen *pen, enum pel_status status);

/* Bytes of struct script_paints, memory for any paint. */
size_t script_paint_size(void);

/* All commands, the first of script_shapes first. The name NULL ends a table,
 * whose last row says which one is `next`. script_next(the last one) is NULL.
 */
extern const struct script_command script_shapes[], script_strokes[],
    script_images[], script_paint_commands[], script_mesh_commands[];
const struct script_command *script_next(const struct script_command *command);

#endif
