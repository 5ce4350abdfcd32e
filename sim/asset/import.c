/* pel import: makes assets for firmware, and pel2d files. */
#include "sim/asset/import.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "sim/asset/measure.h"
#include "sim/asset/text.h"
#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "core/format/argb8888.h"
#include "core/format/formats.h"
#include "sim/image/format_names.h"
#include "sim/cli/message.h"
#include "sim/render/scene_options.h"
#include "sim/render/scene_pel2d.h"

/* The kinds of output, as the bits of a set. */
enum import_kind {
    IMPORT_MESH = 1,
    IMPORT_PICTURE = 2,
    IMPORT_FONT = 4,
    IMPORT_PEL2D = 8,
    IMPORT_VIEWS = 16, /* with IMPORT_MESH: --view is given */
    IMPORT_ICON = 32   /* with IMPORT_PICTURE: --icon-size is given */
};

struct import_command {
    struct scene_options scene;
    struct import_options options;
    const struct pel_format *format; /* NULL: not given */
    bool normals16;                  /* else 8 bits */
    const char *views;               /* NULL: nothing is measured */
    enum import_kind kind;
    char name[128]; /* made from the output's */
};

static bool is_picture(const char *path)
{
    return path_has_ending(path, " .png .jpg .jpeg .tga .bmp .gif .ppm .pgm "
                                 ".pbm .pnm .pam ");
}

/* Packed ones are .bdf.gz and so on. */
static bool is_font(const char *path)
{
    char name[4096];
    const char *dot = strrchr(path, '.');
    if (dot && strcasecmp(dot, ".gz") == 0) {
        snprintf(name, sizeof name, "%.*s", (int)(dot - path), path);
        path = name;
    }
    return path_has_ending(path, " .bdf .psf .psfu .pcf .ttf .otf .ttc .woff "
                                 ".woff2 .pfa .pfb .t1 .fnt ");
}

static bool is_icon(const char *path)
{
    return path_has_ending(path, " .svg ");
}

static bool is_pel2d(const char *path)
{
    return path_has_ending(path, " .pel2d ");
}

static bool parse_format(const char *option, const char *text, void *input)
{
    struct import_command *c = input;
    c->format = strcmp(text, IMPORT_ALPHA_FORMAT) == 0 ? &pel_argb8888
                : strcmp(text, "palette4") == 0 ? &import_palettes[0].format
                : strcmp(text, "palette8") == 0 ? &import_palettes[1].format
                                                : format_find(text);
    return c->format ||
           message_error("--%s is '%s': expected one of %s, "
                         "palette4, palette8, " IMPORT_ALPHA_FORMAT,
                         option, text, format_list());
}

static const struct option_row output_options[] = {
    {"output", "FILE",
     "the asset: .c, with a .h beside it that declares it, or .pel2d for a "
     "projected mesh; - is C on standard output, without a header",
     OPTION_TEXT, .offset = offsetof(struct import_command, options.output),
     .letter = 'o'},
    {.help = NULL},
};

static const struct option_row options[] = {
    {"name", "NAME", "of the C object (default: the output's base name)",
     OPTION_TEXT, .offset = offsetof(struct import_command, options.name)},
    {.help = NULL},
};

static const struct option_row picture_options[] = {
    {.help = "Pictures, and the textures of meshes:", .kind = OPTION_HEADING},
    {"format", "NAME",
     "pixel format of a picture (default: rgb565_le), or of a mesh's textures, "
     "which are written where it is given; " IMPORT_ALPHA_FORMAT
     " keeps its alpha for pel_copy_alpha, as palette4 and palette8 do with at "
     "most 16 and 256 colours; others blend it onto --background (default: "
     "#000000)",
     OPTION_CALL, .parse = parse_format},
    {.help = NULL},
};

static const struct option_row mesh_options[] = {
    {.help = "Meshes:", .kind = OPTION_HEADING},
    {"normals", "BITS", "8 (default) or 16", OPTION_CHOICE,
     .offset = offsetof(struct import_command, normals16), .n = sizeof(bool),
     .expected = "8|16"},
    {"view", "NUMBER|FILE",
     "also write the cheapest shading of each part and mapping of each texture "
     "that stay within --tolerance (default: 0) of what is exact at every "
     "pixel, in so many views from all sides, or those of a file: lines of the "
     "mesh's turn X,Y,Z and, where they move, of the eye and the target. With "
     "all options below that place camera and light, --size (240x240), "
     "--texture of firmware",
     OPTION_TEXT, .offset = offsetof(struct import_command, views)},
    {.help = NULL},
};

static const char about[] =
    "Makes an asset for firmware: a C file with one const struct, and the "
    "header that declares it, of a mesh (pel/asset/mesh_asset.h), a "
    "picture (pel/asset/image_asset.h), an icon (pel/asset/icon_asset.h) or "
    "a font (pel/asset/font_asset.h); or an output .pel2d, a mesh projected "
    "already.\nOf the options under the headings from Shading on, a C asset of "
    "a mesh takes --texture-file, --normals-from and --crease alone, and with "
    "--view all but those of pel render; a .pel2d "
    "takes also --color, --turn, --texture, --wrap, --size and those that "
    "place camera and light. What has no meaning is refused.\v"
    "The colours of a mesh's asset are texels at its vertices: firmware "
    "draws what `pel render --texture nearest --mapping vertices` draws, "
    "with the same --normals 16 where there is light.\n"
    "MESH is a file that assimp reads, or one of " MESH_BUILTINS
    "; PICTURE is a .png, .jpg, .tga, .bmp, .gif, .ppm, .pgm, .pbm "
    "or .pam file; ICON is a .svg file of shapes, groups and gradients: what "
    "it holds beside, as text, filters, masks, <use> or rules of CSS, is "
    "refused by its name; FONT is a "
    ".bdf, .psf, .pcf, .ttf, .otf, .woff or .pfb file, packed (.gz) or not: "
    "characters and their pairs, without ligatures, from the left. The same "
    "input gives the same bytes.";

/* The kinds that options are for; those that the table leaves out place, light
 * and color what a pel2d file holds. */
static const struct use {
    const char *options;
    unsigned kinds; /* of enum import_kind */
    const char *what;
} uses[] = {
    {"name", IMPORT_MESH | IMPORT_PICTURE | IMPORT_FONT | IMPORT_ICON,
     "C assets"},
    {IMPORT_ICON_OPTIONS, IMPORT_ICON, "icons"},
    {"format", IMPORT_PICTURE | IMPORT_MESH, "pictures and textures"},
    {"normals|view", IMPORT_MESH, "C assets of meshes"},
    {IMPORT_FONT_OPTIONS, IMPORT_FONT, "fonts"},
    {"texture-file|normals-from|crease", IMPORT_MESH | IMPORT_PEL2D, "meshes"},
    {"shade|transparency|order|cull|mapping|span|texel-tolerance", 0,
     "pel render"},
    {"tolerance", IMPORT_VIEWS, "--view"},
    {"background|" IMPORT_CHANGE_OPTIONS, IMPORT_PICTURE, "pictures"},
    {NULL, IMPORT_PEL2D | IMPORT_VIEWS, "an output .pel2d and --view"},
};

static bool check_options(const struct options_given *given, unsigned kinds)
{
    const char *name =
        kinds & IMPORT_MESH      ? "a C asset of a mesh holds the mesh itself"
        : kinds & IMPORT_PICTURE ? "this is a picture"
        : kinds & IMPORT_FONT    ? "this is a font"
        : kinds & IMPORT_ICON
            ? "this is an icon: --icon-size makes it a picture"
            : "a pel2d file holds triangles with Gouraud's colours";
    for (int i = 0; i < given->count; i++) {
        const struct use *use = uses;
        while (use->options && choice_find(use->options, given->names[i]) < 0)
            use++;
        if (!(use->kinds & kinds))
            return message_error("--%s is for %s; %s", given->names[i],
                                 use->what, name);
    }
    return true;
}

/* What makes pictures of glyphs has no meaning for outlines. */
static bool check_outline(const struct import_command *c)
{
    const struct options_given *given = &c->scene.given;
    for (int i = 0; c->options.font.outline && i < given->count; i++)
        if (choice_find("font-size|bits|hinting|next", given->names[i]) >= 0)
            return message_error("--%s is for pictures of glyphs, --outline "
                                 "for none: expected one of the two",
                                 given->names[i]);
    return true;
}

/* By its name's ending, when it is there: assimp's own messages do not
 * speak of pictures and fonts. */
static bool check_mesh(const char *path)
{
    if (pel2d_is_file(path))
        return message_error_at(path, 0,
                                "is projected already: expected a mesh");
    if (access(path, R_OK) != 0 || mesh_ending_known(path))
        return true;
    return message_error_at(path, 0,
                            "neither mesh, picture, icon nor font by its "
                            "ending: expected a font .bdf, .psf, .pcf or .ttf, "
                            "a picture .png, .ppm, .jpg, an icon .svg, or a "
                            "mesh that assimp "
                            "reads");
}

static bool check(struct import_command *c)
{
    struct import_options *o = &c->options;
    const char *input = o->source, *output = o->output;
    const bool icon = is_icon(input), font = is_font(input);
    const bool picture = is_picture(input) || (icon && o->icon_size);
    const unsigned more =
        (c->views ? IMPORT_VIEWS : 0u) | (icon ? IMPORT_ICON : 0u);
    if (!output)
        return message_error("-o ASSET.c is missing: expected `pel import "
                             "MESH|PICTURE|ICON|FONT -o ASSET.c`");
    if (strcmp(input, "-") == 0)
        return message_error(
            "import does not read standard input: expected a file");
    c->kind = is_pel2d(output) ? IMPORT_PEL2D
              : picture        ? IMPORT_PICTURE
              : font           ? IMPORT_FONT
              : icon           ? IMPORT_ICON
                               : IMPORT_MESH;
    if (c->kind == IMPORT_PEL2D && (picture || font || icon))
        return message_error_at(
            input, 0, "a pel2d file holds a mesh: expected an output .c");
    if (c->kind != IMPORT_PEL2D && strcmp(output, "-") != 0 &&
        !path_has_ending(output, " .c "))
        return message_error_at(output, 0, "expected an output .c or .pel2d");
    if (c->kind == IMPORT_MESH && c->format && import_has_palette(c->format))
        return message_error("--format of textures is a palette: expected "
                             "another");
    if (!o->name)
        o->name = import_name(output, c->name);
    return (picture || font || icon || check_mesh(input)) &&
           check_options(&c->scene.given, (unsigned)c->kind | more) &&
           check_outline(c) &&
           (c->kind == IMPORT_PEL2D || import_name_check(o->name)) &&
           (!o->next || import_name_check(o->next)) && import_codes_check(o);
}

/* With Gouraud's colors at the vertices, whatever draws them. */
static bool import_as_pel2d(struct import_command *c)
{
    struct scene scene = {0};
    struct scene_settings settings = c->scene.settings;
    struct pel2d flat = {0};
    struct model model;
    uint32_t clipped = 0;
    settings.shade = SCENE_GOURAUD;
    settings.mapping = SCENE_MAP_VERTICES;
    c->scene.source.without_texture = settings.texture == SCENE_TEXTURE_NONE;
    if (!model_load(&model, &c->scene.source))
        return false;
    const bool projected = scene_init(&scene, &model) &&
                           scene_prepare(&scene, &settings) &&
                           scene_project(&scene, &flat, &clipped);
    if (clipped > 0)
        message_error_at(c->scene.source.path, 0,
                         "%u of %u triangles reach behind the camera or far "
                         "out of the picture and were clipped",
                         clipped, model.mesh.triangles);
    const bool done = projected && pel2d_save(&flat, c->options.output);
    scene_free(&scene);
    pel2d_free(&flat);
    model_free(&model);
    return done;
}

static bool check_mask(const struct import_options *o,
                       const struct pel_format *format)
{
    const bool grey =
        format == &pel_gray8 || format == &pel_gray4 || format == &pel_mono1;
    return (grey && !o->changes.alpha) ||
           message_error("--icon-size with --symbolic makes a mask: expected "
                         "--format gray8, gray4 or mono1, without --alpha");
}

static bool import_as_picture(struct import_command *c)
{
    struct picture picture;
    const pel_color background = c->scene.settings.camera.background;
    const struct pel_format *format = c->format             ? c->format
                                      : c->options.symbolic ? &pel_gray4
                                      : c->options.icon_size
                                          ? &pel_argb8888
                                          : format_find("rgb565_le");
    if (c->options.symbolic && !check_mask(&c->options, format))
        return false;
    if (import_has_alpha(format) && background != 0)
        return message_error(
            "--background is for formats without alpha; " IMPORT_ALPHA_FORMAT
            " and palettes keep it");
    c->options.background = background | PEL_RGB(0, 0, 0);
    const bool done = import_picture_load(&picture, &c->options) &&
                      import_picture(&c->options, &picture, format);
    picture_free(&picture);
    return done;
}

/* Those of the views: textures are drawn where they are written. */
static const struct scene_settings *view_settings(struct import_command *c)
{
    struct scene_settings *s = &c->scene.settings;
    if (!c->format)
        s->texture = SCENE_TEXTURE_NONE;
    if (!options_has(&c->scene.given, "size"))
        s->camera.width = s->camera.height = 240;
    return s;
}

static bool import_as_mesh(struct import_command *c)
{
    struct mesh mesh;
    struct model model = {0};
    struct model_source *source = &c->scene.source;
    if (!model_read(&mesh, source))
        return false;
    const bool own_colors =
        mesh.has_colors && !mesh.multiplies && !source->texture;
    source->without_texture = own_colors && !c->format;
    bool done = model_make(&model, &mesh, c->normals16 ? 16 : 8) &&
                model_add_textures(&model, &mesh, source);
    if (done && !own_colors)
        model_paint(&model);
    struct measure measure = {.views = c->views,
                              .tolerance = c->scene.settings.tolerance};
    if (done && c->views) {
        c->options.measure = &measure;
        done = measure_model(&measure, &model, view_settings(c));
    }
    done = done && import_mesh(&c->options, &model, c->format);
    measure_free(&measure);
    model_free(&model);
    mesh_free(&mesh);
    return done;
}

int command_import(int argc, char **argv)
{
    struct import_command c = {.scene = {.settings = scene_default},
                               .options = {.font = {.size = FONT_SIZE}}};
    c.scene.settings.texture = SCENE_TEXTURE_NEAREST;
    c.scene.settings.camera.background = 0; /* no option gives that */
    const struct command_line line = {
        .arguments = "MESH|PICTURE|ICON|FONT",
        .least = 1,
        .most = 1,
        .about = about,
        .tables = {{output_options, &c, NULL},
                   {options, &c, &c.scene.given},
                   {import_font_options, &c.options, &c.scene.given},
                   {picture_options, &c, &c.scene.given},
                   {import_change_options, &c.options.changes, &c.scene.given},
                   {import_icon_options, &c.options, &c.scene.given},
                   {mesh_options, &c, &c.scene.given},
                   {scene_option_table, &c.scene, &c.scene.given}}};
    c.scene.source.path = *arguments_parse(&line, argc, argv);
    c.options.source = c.scene.source.path;
    if (!check(&c))
        return STATUS_ERROR;
    const bool done = c.kind == IMPORT_PEL2D     ? import_as_pel2d(&c)
                      : c.kind == IMPORT_PICTURE ? import_as_picture(&c)
                      : c.kind == IMPORT_FONT    ? import_font(&c.options)
                      : c.kind == IMPORT_ICON    ? import_icon(&c.options)
                                                 : import_as_mesh(&c);
    return done ? STATUS_OK : STATUS_ERROR;
}
