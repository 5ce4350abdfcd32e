/* pel render: draws a mesh. */
#include <errno.h>
#include <string.h>

#include "arguments.h"
#include "canvas.h"
#include "commands.h"
#include "core/raster/rectangle.h"
#include "device.h"
#include "format_names.h"
#include "mesh_input.h"
#include "message.h"
#include "number.h"
#include "render_painter.h"

struct render_options {
    struct device_options device;
    struct mesh_input input;
    const char *output;
    const struct pel_format *format;
    enum painter_shade shade;
    int bands;
    bool lines;
};

enum {
    OPTION_SHADE = 0x200,
    OPTION_TEXTURE,
    OPTION_FORMAT,
    OPTION_BANDS,
    OPTION_COLLINEAR
};

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0,
     "the picture: .ppm, .png or .bmp; standard output when left out", 0},
    {"shade", OPTION_SHADE, "MODE", 0, "flat or gouraud (default)", 0},
    {"texture", OPTION_TEXTURE, "FILE", 0,
     "take the vertices' colours from this picture", 0},
    {"format", OPTION_FORMAT, "NAME", 0,
     "draw in this pixel format (default: xrgb8888)", 0},
    {"bands", OPTION_BANDS, "ROWS", 0, "draw in bands of so many rows", 0},
    {"collinear", OPTION_COLLINEAR, "WHAT", 0,
     "a triangle without area is nothing (default) or a line", 0},
    {0},
};

static bool parse_shade(const char *text, struct render_options *o)
{
    o->shade = strcmp(text, "flat") == 0 ? PAINTER_FLAT : PAINTER_GOURAUD;
    return o->shade == PAINTER_FLAT || strcmp(text, "gouraud") == 0 ||
           message_error("unknown shading mode '%s': flat or gouraud would be "
                         "right",
                         text);
}

static bool parse_collinear(const char *text, struct render_options *o)
{
    o->lines = strcmp(text, "line") == 0;
    return o->lines || strcmp(text, "nothing") == 0 ||
           message_error("--collinear is '%s'; nothing or line would be right",
                         text);
}

static bool parse_format(const char *text, struct render_options *o)
{
    o->format = format_find(text);
    return o->format || message_error("unknown format '%s': valid are %s", text,
                                      format_list());
}

static bool parse_bands(const char *text, struct render_options *o)
{
    int64_t rows = 0;
    if (number_integer(text, 0, 32767, &rows) != NUMBER_OK)
        return message_error("--bands is '%s'; rows from 0 (none) to 32767 "
                             "would be right",
                             text);
    o->bands = (int)rows;
    return true;
}

static bool parse_mesh(const char *text, struct render_options *o)
{
    if (o->input.path)
        return message_error("'%s' is a second mesh; one would be right", text);
    o->input.path = text;
    return true;
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct render_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[1] = &o->device;
        state->child_inputs[0] = &o->input.camera;
        return 0;
    case ARGP_KEY_ARG:
        return parse_mesh(text, o) ? 0 : EINVAL;
    case 'o':
        o->output = text;
        return 0;
    case OPTION_TEXTURE:
        o->input.texture = text;
        return 0;
    case OPTION_SHADE:
        return parse_shade(text, o) ? 0 : EINVAL;
    case OPTION_FORMAT:
        return parse_format(text, o) ? 0 : EINVAL;
    case OPTION_BANDS:
        return parse_bands(text, o) ? 0 : EINVAL;
    case OPTION_COLLINEAR:
        return parse_collinear(text, o) ? 0 : EINVAL;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = {
    {&camera_argp, 0, "Camera:", 2}, {&device_argp, 0, NULL, 0}, {0}};

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "MESH",
    .doc = "Draws a mesh, the farthest triangle first.\v"
           "MESH is a file that assimp reads, a pel2d file (- is one on "
           "standard input), or " MESH_BUILTIN ".",
    .children = children,
};

static bool check(const struct render_options *o)
{
    if (!o->input.path)
        return message_error("a mesh is missing; `pel render MESH -o OUT.ppm` "
                             "would be right");
    if (!canvas_bands_legal(o->format, o->bands))
        return message_error("--bands is %d; in mono1_pages a multiple of 8 "
                             "would be right",
                             o->bands);
    return picture_path_check(o->output) &&
           device_check_output(&o->device, o->output);
}

struct drawing {
    const struct render_options *options;
    struct painter *painter; /* only read while it draws */
};

static bool draw_mesh(struct canvas *canvas, const void *context)
{
    const struct drawing *drawing = context;
    const struct render_options *o = drawing->options;
    pel_clear(&canvas->surface, o->input.camera.background);
    return canvas_draw(canvas, o->bands, painter_draw, drawing->painter);
}

static bool show(const struct drawing *drawing)
{
    const struct camera *camera = &drawing->options->input.camera;
    const struct device_picture picture = {.width = camera->width,
                                           .height = camera->height,
                                           .draw = draw_mesh,
                                           .context = drawing};
    return device_show(&drawing->options->device, &picture);
}

static bool save(const struct drawing *drawing)
{
    const struct render_options *o = drawing->options;
    const struct camera *camera = &o->input.camera;
    struct picture picture = {0};
    struct canvas canvas;
    if (!canvas_init(&canvas, o->format, camera->width, camera->height))
        return false;
    const bool done =
        device_draw_canvas(&o->device, &canvas, draw_mesh, drawing) &&
        canvas_picture(&canvas, &picture) && picture_save(&picture, o->output);
    canvas_free(&canvas);
    picture_free(&picture);
    return done;
}

static bool render(struct render_options *o)
{
    struct pel2d flat;
    struct painter painter = {.shade = o->shade, .lines = o->lines};
    const struct drawing drawing = {o, &painter};
    if (!mesh_input_load(&o->input, &flat))
        return false;
    const bool done = painter_init(&painter, &flat) &&
                      (o->device.name ? show(&drawing) : save(&drawing));
    painter_free(&painter);
    pel2d_free(&flat);
    return done;
}

int command_render(int argc, char **argv)
{
    struct render_options o = {
        .device = {.jobs = 1},
        .input = {.camera = camera_default},
        .output = "-",
        .format = format_find("xrgb8888"),
        .shade = PAINTER_GOURAUD,
    };
    arguments_parse(&parser, argc, argv, &o);
    return check(&o) && render(&o) ? STATUS_OK : STATUS_ERROR;
}
