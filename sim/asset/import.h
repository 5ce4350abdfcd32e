/* The assets that `pel import` writes. */
#ifndef SIM_ASSET_IMPORT_H
#define SIM_ASSET_IMPORT_H

#include "core/format/palette.h"
#include "sim/cli/arguments.h"
#include "sim/font/font.h"
#include "sim/image/reduce.h"
#include "sim/mesh/model.h"

struct measure;

/* The name of the format that keeps the alpha of pictures; no display has it,
 * so format_find does not find it. */
#define IMPORT_ALPHA_FORMAT "argb8888"

/* Those of palette4 and palette8; the colors are the picture's. */
extern const struct pel_palette import_palettes[2];

static inline bool import_has_palette(const struct pel_format *format)
{
    return format->id == PEL_FORMAT_PALETTE4 ||
           format->id == PEL_FORMAT_PALETTE8;
}

static inline bool import_has_alpha(const struct pel_format *format)
{
    return format->id == PEL_FORMAT_ARGB8888 || import_has_palette(format);
}

/* What is done to a picture, in this order. */
struct import_changes {
    pel_color key; /* pixels of that color become clear */
    int size[2];
    int colors; /* of the palette that is chosen; 0: those that it has */
    enum picture_dither dither;
    enum import_alpha { ALPHA_NONE, ALPHA_8, ALPHA_4, ALPHA_1 } alpha;
    bool has_key, has_size, own_palette;
    bool compress; /* at the end: into runs */
};

struct import_options {
    const char *source; /* file, for the comment: its base name is shown */
    const char *output; /* file or "-" */
    const char *name;   /* of the C object */
    struct font_options font;
    const char *next;     /* the C object of a font that is asked next; NULL */
    const char *codes;    /* of a font: code points to keep, or NULL ... */
    const char *chars;    /* ... and characters; without either all */
    int icon_size;        /* px of an icon's picture; 0: its paths */
    bool symbolic;        /* an icon takes the program's color */
    pel_color background; /* of a picture's transparent parts, opaque */
    struct import_changes changes;
    const struct measure *measure; /* of a mesh; NULL: nothing was measured */
};

/* The options of struct import_changes. */
extern const struct option_row import_change_options[];
#define IMPORT_CHANGE_OPTIONS "key|resize|palette|dither|alpha|compress"

/* Those of a font: codes, chars, next and struct font_options. */
extern const struct option_row import_font_options[];
#define IMPORT_FONT_OPTIONS \
    "codes|chars|encoding|font-size|bits|hinting|next|outline"

/* Those of an icon: icon_size and symbolic. */
extern const struct option_row import_icon_options[];
#define IMPORT_ICON_OPTIONS "icon-size|symbolic"

/* Write a C file with one const struct and its arrays, and its header beside
 * it, the same for the same input: no date, no path. The textures of a mesh are
 * written in that format, or in pel_argb8888 where they have alpha; not at all
 * where it is NULL. False, with a message on standard error, when that failed.
 */
bool import_mesh(const struct import_options *options,
                 const struct model *model, const struct pel_format *format);
bool import_font(const struct import_options *options);
bool import_icon(const struct import_options *options);

/* Reads a picture, or an icon as one where the options name its size. False,
 * with a message. */
bool import_picture_load(struct picture *picture,
                         const struct import_options *options);

/* The picture is changed as the options say, and made opaque, with a note on
 * standard error when it was not, unless the format is pel_argb8888 or a
 * palette; of a palette it may have 16 or 256 colors. */
bool import_picture(const struct import_options *options,
                    struct picture *picture, const struct pel_format *format);

/* Writes NAME_texture_NUMBER, an image asset, into the text of a mesh. */
struct import_text;
bool import_texture(struct import_text *text, unsigned number,
                    struct picture *picture, const struct pel_format *format);

/* True for legal codes and chars; false with a message. */
bool import_codes_check(const struct import_options *options);

#endif
