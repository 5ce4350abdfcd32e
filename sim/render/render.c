/* pel render: draws a mesh. */
#include <stdio.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/image/canvas.h"
#include "sim/cli/commands.h"
#include "core/raster/rectangle.h"
#include "sim/cli/device.h"
#include "sim/image/format_names.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"
#include "sim/cli/output.h"
#include "sim/render/painter.h"
#include "sim/render/scene_options.h"
#include "sim/image/texture.h"

struct render_options {
    struct device_options device;
    struct scene_options scene;
    const char *output; /* NULL: standard output */
    const struct pel_format *format;
    int bands;
    bool lines, timed, print_camera;
};

#define AT(member) offsetof(struct render_options, member)

static const struct option_row options[] = {
    {"format", "NAME", "draw in this pixel format (default: xrgb8888)",
     OPTION_FORMAT, .offset = AT(format)},
    {"bands", "ROWS", "draw in bands of so many rows", OPTION_INTEGER,
     .offset = AT(bands), .low = 0, .high = 32767},
    {"collinear", "WHAT",
     "of a pel2d file: a triangle without area is nothing (default) or a line",
     OPTION_CHOICE, .offset = AT(lines), .n = sizeof(bool),
     .expected = "nothing|line"},
    {"time", NULL,
     "print on standard error the milliseconds that the drawing took, and what "
     "decided who is in front",
     OPTION_FLAG, .offset = AT(timed)},
    {"stats", NULL,
     "for Phong: print the triangles and pixels that each method drew (flat, "
     "gouraud, phong; see --tolerance) on standard error; draws in one "
     "thread",
     OPTION_FLAG, .offset = AT(scene.settings.stats)},
    {"show-methods", NULL,
     "for Phong: instead of the picture the method of each triangle: flat "
     "grey, gouraud blue, phong red",
     OPTION_FLAG, .offset = AT(scene.settings.show_methods)},
    {"print-camera", NULL,
     "print an initialiser of struct pel_camera, for firmware that shows the "
     "same view; there is a picture only with -o or --device",
     OPTION_FLAG, .offset = AT(print_camera)},
    {.help = NULL},
};

static const char *output_of(const struct render_options *o)
{
    return o->output ? o->output : "-";
}

/* Options that would do nothing, or cannot be met. */
static bool check(const struct render_options *o)
{
    const struct scene_settings *s = &o->scene.settings;
    const struct {
        bool is_wrong;
        const char *message;
    } checks[] = {
        {o->print_camera && o->output && strcmp(o->output, "-") == 0,
         "--print-camera is for standard output, and the picture too: expected "
         "-o FILE"},
        {s->stats && s->shade != SCENE_PHONG, "--stats is about --shade phong"},
        {s->show_methods && s->shade != SCENE_PHONG,
         "--show-methods is about --shade phong"},
        {s->tolerance > 0 && s->shade != SCENE_PHONG,
         "--tolerance is about --shade phong"},
        {s->in_world && (s->stats || s->show_methods),
         "--stats and --show-methods are about methods that are linear on "
         "screen: expected --interpolation screen"},
        {s->stats && s->show_methods,
         "--stats counts what --show-methods does not draw: expected one of "
         "them"},
        {options_has(&o->scene.given, "span") &&
             s->mapping != SCENE_MAP_SUBDIVIDED,
         "--span divides a subdivided mapping: expected --mapping subdivided"},
        {s->texel_tolerance > 0 && s->mapping != SCENE_MAP_PERSPECTIVE,
         "--texel-tolerance chooses mappings instead of the one in "
         "perspective: expected --mapping perspective"},
    };
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++)
        if (checks[i].is_wrong)
            return message_error("%s", checks[i].message);
    if (!canvas_bands_legal(o->format, o->bands))
        return message_error("--bands is %d: expected a multiple of 8 for "
                             "mono1_pages",
                             o->bands);
    return picture_path_check(output_of(o)) &&
           device_check_output(&o->device, output_of(o));
}

/* A mesh on its scene, or a pel2d file's triangles: only read while parts of a
 * picture are drawn side by side. */
struct drawing {
    const struct render_options *options;
    const struct scene *scene; /* or NULL, and then: */
    struct painter *painter;
};

/* One part, which may fail. */
struct part {
    const struct scene *scene;
    bool failed;
};

static void draw_scene(struct pel_surface *surface, void *context)
{
    struct part *part = context;
    part->failed = part->failed || !scene_draw(part->scene, surface);
}

/* Several threads draw several parts, and each tells its time. */
static bool draw(struct canvas *canvas, const void *context)
{
    const struct drawing *drawing = context;
    const struct render_options *o = drawing->options;
    const double start = milliseconds();
    struct part part = {drawing->scene, false};
    pel_clear(&canvas->surface, o->scene.settings.camera.background);
    const bool done =
        drawing->scene
            ? canvas_draw(canvas, o->bands, draw_scene, &part) && !part.failed
            : canvas_draw(canvas, o->bands, painter_draw, drawing->painter);
    if (o->timed)
        fprintf(stderr, "drawn: %.3f ms\n", milliseconds() - start);
    return done;
}

static bool finish(const struct drawing *drawing)
{
    const struct render_options *o = drawing->options;
    const struct camera *camera = &o->scene.settings.camera;
    const struct pel_format *format = o->format;
    const struct device_picture picture = {.width = camera->width,
                                           .height = camera->height,
                                           .format = &format,
                                           .draw = draw,
                                           .context = drawing};
    return device_show(&o->device, &picture, output_of(o));
}

/* The first option that means nothing for a pel2d file, or NULL. */
static const char *mesh_option(const struct render_options *o)
{
    const struct options_given *given = &o->scene.given;
    for (int i = 0; i < given->count; i++)
        if (choice_find("size|background|shade|texture-file|texture|wrap",
                        given->names[i]) < 0)
            return given->names[i];
    return o->print_camera ? "print-camera" : NULL;
}

/* A pel2d file is projected and colored already: the painter draws it. */
static bool check_pel2d(const struct render_options *o)
{
    const struct scene_options *s = &o->scene;
    const char *wrong = mesh_option(o);
    if (wrong)
        return message_error_at(s->source.path, 0,
                                "is projected and lit already: --%s is for "
                                "mesh files",
                                wrong);
    if (s->settings.shade == SCENE_PHONG)
        return message_error_at(s->source.path, 0,
                                "has no normals: expected --shade flat or "
                                "gouraud");
    return s->source.texture || s->settings.texture == SCENE_TEXTURE_NONE ||
           (!options_has(&s->given, "texture") &&
            !options_has(&s->given, "wrap")) ||
           message_error_at(s->source.path, 0,
                            "names no texture: expected --texture-file");
}

static bool load_texture(struct painter_texture *texture,
                         const struct scene_options *o)
{
    if (!texture_load(&texture->picture, o->source.texture))
        return false;
    texture->opaque = texture_opaque(&texture->picture);
    texture->bilinear = o->settings.texture == SCENE_TEXTURE_BILINEAR;
    texture->wrap = o->settings.wrap == SCENE_WRAP_OWN
                        ? PEL_WRAP_REPEAT
                        : (enum pel_wrap)o->settings.wrap;
    return true;
}

static bool render_pel2d(const struct render_options *o)
{
    struct pel2d flat = {0};
    const struct scene_options *s = &o->scene;
    struct painter_texture texture = {.picture = {0}};
    const bool textured =
        s->source.texture && s->settings.texture != SCENE_TEXTURE_NONE;
    const bool is_flat = s->settings.shade == SCENE_FLAT;
    struct painter painter = {.texture = textured ? &texture : NULL,
                              .shade = is_flat ? PAINTER_FLAT : PAINTER_GOURAUD,
                              .lines = o->lines};
    const struct drawing drawing = {o, NULL, &painter};
    const bool done = check_pel2d(o) && pel2d_load(&flat, s->source.path) &&
                      (!textured || load_texture(&texture, s)) &&
                      painter_init(&painter, &flat) && finish(&drawing);
    painter_free(&painter);
    picture_free(&texture.picture);
    pel2d_free(&flat);
    return done;
}

static bool prepare(struct scene *scene, const struct scene_settings *settings,
                    bool timed)
{
    const double start = milliseconds();
    const bool done = scene_prepare(scene, settings);
    if (done && timed) {
        fprintf(stderr, "placed, lit and sorted: %.3f ms\n",
                milliseconds() - start);
        scene_print_order(stderr, scene);
    }
    return done;
}

static bool print(const struct scene *scene)
{
    struct output output;
    if (!output_open(&output, "-"))
        return false;
    scene_print_camera(output.stream, scene);
    return output_commit(&output);
}

static bool render_mesh(const struct render_options *o)
{
    struct model model;
    struct scene scene;
    struct model_source source = o->scene.source;
    const struct drawing drawing = {o, &scene, NULL};
    source.without_texture = o->scene.settings.texture == SCENE_TEXTURE_NONE;
    if (o->lines)
        return message_error_at(source.path, 0,
                                "--collinear is for pel2d files");
    if (!model_load(&model, &source))
        return false;
    const bool ready = scene_init(&scene, &model) &&
                       prepare(&scene, &o->scene.settings, o->timed);
    const bool printed = ready && (!o->print_camera || print(&scene));
    const bool only = o->print_camera && !o->output && !o->device.name;
    const bool done = printed && (only || finish(&drawing));
    if (done && o->scene.settings.stats)
        scene_methods_print(&scene.methods);
    scene_free(&scene);
    model_free(&model);
    return done;
}

int command_render(int argc, char **argv)
{
    struct render_options o = {
        .device = {.jobs = 1},
        .scene = {.settings = scene_default},
        .format = format_find("xrgb8888"),
    };
    const struct command_line line = {
        .arguments = "MESH",
        .least = 1,
        .most = 1,
        .about = "Draws a mesh.\v"
                 "MESH is a file that assimp reads, a pel2d file (- is one on "
                 "standard input), or one of " MESH_BUILTINS
                 ". The picture goes to standard output without -o.",
        .tables = {{output_option_table, &o.output, NULL},
                   {options, &o, NULL},
                   {device_option_table, &o.device, NULL},
                   {scene_option_table, &o.scene, &o.scene.given}}};
    o.scene.source.path = *arguments_parse(&line, argc, argv);
    if (o.scene.settings.stats)
        o.device.jobs = 1;
    const bool done =
        check(&o) && (pel2d_is_file(o.scene.source.path) ? render_pel2d(&o)
                                                         : render_mesh(&o));
    return done ? STATUS_OK : STATUS_ERROR;
}
