/* pel import: makes assets for firmware, and pel2d files. */
#include "sim/asset/import.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "core/format/argb8888.h"
#include "sim/image/format_names.h"
#include "sim/cli/message.h"
#include "sim/render/scene_options.h"
#include "sim/render/scene_pel2d.h"
#include "sim/image/texture.h"

struct import_command {
    struct scene_options scene;
    struct import_options options;
    const struct pel_format *format; /* NULL: not given */
    char name[128];                  /* made from the output's */
};

static bool has_ending(const char *path, const char *const *ending)
{
    const char *dot = strrchr(path, '.');
    for (; dot && *ending; ending++)
        if (strcasecmp(dot, *ending) == 0)
            return true;
    return false;
}

static bool is_picture(const char *path)
{
    static const char *const ending[] = {".png", ".jpg", ".jpeg", ".tga",
                                         ".bmp", ".ppm", ".pgm",  NULL};
    return has_ending(path, ending);
}

static bool is_font(const char *path)
{
    static const char *const ending[] = {".bdf", ".psf", ".psfu", NULL};
    return has_ending(path, ending);
}

static bool is_pel2d(const char *path)
{
    static const char *const ending[] = {".pel2d", NULL};
    return has_ending(path, ending);
}

static bool parse_format(const char *option, const char *text, void *input)
{
    struct import_command *c = input;
    c->format = strcmp(text, IMPORT_ALPHA_FORMAT) == 0 ? &pel_argb8888
                                                       : format_find(text);
    return c->format ||
           message_error(
               "--%s is '%s': expected one of %s, " IMPORT_ALPHA_FORMAT, option,
               text, format_list());
}

static bool parse_normals(const char *option, const char *text, void *input)
{
    const int choice = choice_find("8|16", text);
    ((struct import_command *)input)->options.normal_bits = choice ? 16 : 8;
    return choice >= 0 || option_refuse(option, text, "8 or 16");
}

static bool parse_codes(const char *option, const char *text, void *input)
{
    (void)option;
    ((struct import_command *)input)->options.codes = text;
    return import_codes_legal(text);
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
    {"format", "NAME",
     "pixel format of a picture (default: rgb565_le); " IMPORT_ALPHA_FORMAT
     " keeps its alpha for pel_copy_alpha, others blend it onto --background "
     "(default: #000000)",
     OPTION_CALL, .parse = parse_format},
    {"normals", "BITS", "8 (default) or 16", OPTION_CALL,
     .parse = parse_normals},
    {"codes", "RANGES",
     "of a font, these alone, numbers or characters: 32-126,0x20AC,\xC3\xA4; "
     "what a font lacks of them is named, and an error outside of ranges",
     OPTION_CALL, .parse = parse_codes},
    {.help = NULL},
};

static const char about[] =
    "Makes an asset for firmware: a C file with one const struct, and the "
    "header that declares it, of a mesh (core/asset/mesh_asset.h), a picture "
    "(core/asset/image_asset.h) or a font (core/asset/font_asset.h); or an "
    "output .pel2d, a mesh projected already.\nOf the options under the "
    "headings below, a C asset of a mesh takes --texture-file and "
    "--normals-from alone; a .pel2d takes also --color, --turn, --texture, "
    "--wrap, --size and those that place camera and light. What has no meaning "
    "is refused.\v"
    "The colours of a mesh's asset are texels at its vertices: firmware draws "
    "what `pel render --texture nearest --mapping vertices` draws, with the "
    "same --normals 16 where there is light.\n"
    "MESH is a file that assimp reads, or " MESH_BUILTIN
    "; PICTURE is a .png, .jpg, .tga, .bmp, .ppm or .pgm file; FONT is a .bdf "
    "or .psf file. The same input gives the same bytes.";

/* Base name of the output up to the first dot, what C does not take as _. */
static void make_name(struct import_command *c)
{
    const char *slash = strrchr(c->options.output, '/');
    const char *base = slash ? slash + 1 : c->options.output;
    size_t n = strcspn(base, ".");
    if (strcmp(base, "-") == 0 || n == 0)
        base = "asset", n = 5;
    snprintf(c->name, sizeof(c->name), "%s%.*s",
             isdigit((unsigned char)*base) ? "_" : "", (int)n, base);
    for (char *p = c->name; *p; p++)
        if (!isalnum((unsigned char)*p))
            *p = '_';
    c->options.name = c->name;
}

static bool check_name(const char *name)
{
    static const char words[] =
        " auto break case char const continue default do double else enum "
        "extern float for goto if inline int long register restrict return "
        "short signed sizeof static struct switch typedef union unsigned void "
        "volatile while ";
    char padded[160];
    size_t n = strspn(name, "abcdefghijklmnopqrstuvwxyz"
                            "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    snprintf(padded, sizeof(padded), " %s ", name);
    return (n > 0 && n < 128 && name[n] == '\0' &&
            !isdigit((unsigned char)*name) && !strstr(words, padded)) ||
           message_error("the name '%s' is no identifier of C; --name such as "
                         "duck would be right",
                         name);
}

/* By its name's ending, when it is there: assimp's own messages would not tell
 * of pictures and fonts. */
static bool check_kind(const char *path)
{
    static const char *const packed[] = {".gz", NULL}, *const pcf[] = {".pcf",
                                                                       NULL};
    if (access(path, R_OK) != 0 || mesh_ending_known(path) || is_pel2d(path))
        return true;
    if (has_ending(path, packed))
        return message_error_at(path, 0,
                                "is packed; `gunzip -k` first, and of a font "
                                ".pcf then `pcf2bdf -o FONT.bdf`, would be "
                                "right");
    if (has_ending(path, pcf))
        return message_error_at(path, 0,
                                "is a font of another kind; `pcf2bdf -o "
                                "FONT.bdf` first would be right");
    return message_error_at(path, 0,
                            "neither mesh, picture nor font by its "
                            "ending");
}

static bool check(struct import_command *c)
{
    static const char *const ending[] = {".c", NULL};
    const char *input = c->scene.source.path, *output = c->options.output;
    if (!input || !output)
        return message_error("%s is missing; `pel import MESH|PICTURE|FONT -o "
                             "ASSET.c` would be right",
                             input ? "-o ASSET.c" : "an input");
    if (strcmp(input, "-") == 0)
        return message_error("import does not read standard input: a file "
                             "would be right");
    if (is_pel2d(output) && (is_picture(input) || is_font(input)))
        return message_error_at(input, 0,
                                "a pel2d file holds a mesh; an "
                                "output .c would be right");
    if (is_pel2d(output))
        return import_check(&c->scene.given, IMPORT_PEL2D);
    if (strcmp(output, "-") != 0 && !has_ending(output, ending))
        return message_error_at(output, 0,
                                "an output .c or .pel2d would be right");
    if (!is_picture(input) && !is_font(input) && !check_kind(input))
        return false;
    if (!c->options.name)
        make_name(c);
    return check_name(c->options.name) &&
           import_check(&c->scene.given, is_picture(input) ? IMPORT_PICTURE
                                         : is_font(input)  ? IMPORT_FONT
                                                           : IMPORT_MESH);
}

/* Gouraud's colours at the vertices, whatever draws them. */
static bool project(const struct scene_options *o, const struct model *model,
                    struct pel2d *flat)
{
    struct scene scene;
    struct scene_settings settings = o->settings;
    uint32_t clipped = 0;
    settings.shade = SCENE_GOURAUD;
    settings.mapping = SCENE_MAP_VERTICES;
    const bool done = scene_init(&scene, model) &&
                      scene_prepare(&scene, &settings) &&
                      scene_project(&scene, flat, &clipped);
    scene_free(&scene);
    if (clipped > 0)
        fprintf(stderr,
                "pel: %s: %u of %u triangles reach behind the camera or far "
                "out of the picture and were clipped\n",
                o->source.path, clipped, model->mesh.triangles);
    return done;
}

static bool import_as_pel2d(struct import_command *c)
{
    struct pel2d flat;
    struct model model;
    const char *path = c->scene.source.path;
    if (pel2d_is_file(path))
        return message_error_at(path, 0,
                                "is projected already; a mesh would be right");
    if (!model_load(&model, &c->scene.source))
        return false;
    const bool projected = project(&c->scene, &model, &flat);
    const bool done = projected && pel2d_save(&flat, c->options.output);
    if (projected)
        pel2d_free(&flat);
    model_free(&model);
    return done;
}

static bool import_as_picture(struct import_command *c)
{
    struct picture picture;
    const pel_color background = c->scene.settings.camera.background;
    if (c->format == &pel_argb8888 && background != 0)
        return message_error(
            "--background is for formats without alpha; " IMPORT_ALPHA_FORMAT
            " keeps it");
    if (!texture_load(&picture, c->scene.source.path))
        return false;
    c->options.background = background | PEL_RGB(0, 0, 0);
    bool done =
        import_picture(&c->options, &picture,
                       c->format ? c->format : format_find("rgb565_le"));
    picture_free(&picture);
    return done;
}

static bool import_as_mesh(struct import_command *c)
{
    struct mesh mesh;
    const char *path = c->scene.source.path;
    if (pel2d_is_file(path))
        return message_error_at(path, 0,
                                "is projected already; a mesh would be right");
    if (!mesh_load(&mesh, path))
        return false;
    bool done = (!c->scene.source.smooth_normals || mesh_normals(&mesh)) &&
                mesh_paint(&mesh, path, c->scene.source.texture) &&
                import_mesh(&c->options, &mesh);
    mesh_free(&mesh);
    return done;
}

static bool import_as_font(const struct import_command *c)
{
    return import_font(&c->options);
}

int command_import(int argc, char **argv)
{
    struct import_command c = {
        .scene = {.settings = scene_default},
        .options = {.normal_bits = 8},
    };
    c.scene.settings.texture = SCENE_TEXTURE_NEAREST;
    c.scene.settings.camera.background = 0; /* no option gives that */
    const struct command_line line = {
        .arguments = "MESH|PICTURE|FONT",
        .least = 1,
        .most = 1,
        .about = about,
        .tables = {{output_options, &c, NULL},
                   {options, &c, &c.scene.given},
                   {scene_option_table, &c.scene, &c.scene.given}}};
    c.scene.source.path = *arguments_parse(&line, argc, argv);
    c.options.source = c.scene.source.path;
    if (!check(&c))
        return STATUS_ERROR;
    bool done = is_pel2d(c.options.output)        ? import_as_pel2d(&c)
                : is_picture(c.scene.source.path) ? import_as_picture(&c)
                : is_font(c.scene.source.path)    ? import_as_font(&c)
                                                  : import_as_mesh(&c);
    return done ? STATUS_OK : STATUS_ERROR;
}
