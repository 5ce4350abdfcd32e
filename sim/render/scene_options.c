#include "sim/render/scene_options.h"

#include <errno.h>
#include <math.h>

#include "sim/cli/message.h"
#include "sim/cli/number.h"
#include "sim/cli/option_text.h"

enum {
    KEY_SHADE = 0x300,
    KEY_COLOR,
    KEY_TRANSPARENCY,
    KEY_NORMALS,
    KEY_TURN,
    KEY_ORDER,
    KEY_CULL,
    KEY_TEXTURE,
    KEY_TEXTURE_FILE,
    KEY_MAPPING,
    KEY_SPAN,
    KEY_WRAP
};

static const struct argp_option options[] = {
    {0, 0, 0, 0, "Shading:", 1},
    {"shade", KEY_SHADE, "MODE", 0, "flat, gouraud (default) or phong", 0},
    {"color", KEY_COLOR, "COLOUR", 0,
     "#rrggbb for the whole mesh, instead of its colours", 0},
    {"transparency", KEY_TRANSPARENCY, "0..255", 0,
     "0 (default) is opaque, 255 draws nothing", 0},
    {"normals-from", KEY_NORMALS, "SOURCE", 0,
     "file (default: where it has them), or smooth: at each vertex the mean of "
     "the faces around it; facets are --shade flat",
     0},
    {"turn", KEY_TURN, "X,Y,Z", 0,
     "turn the mesh around its middle, in parts of a turn around x, then y, "
     "then z",
     0},
    {"order", KEY_ORDER, "NAME", 0,
     "painter (default: what a device without memory for depths shows; joints "
     "of large triangles may tear), zbuffer16, or zbuffer32, zbuffer for "
     "short: exact at every pixel",
     0},
    {"cull", KEY_CULL, "SIDE", 0, "leave out none (default), back or front", 0},
    {0, 0, 0, 0, "Texture:", 4},
    {"texture", KEY_TEXTURE, "MODE", 0, "none, nearest or bilinear (default)",
     0},
    {"texture-file", KEY_TEXTURE_FILE, "FILE", 0,
     "this picture instead of the mesh's own; of a pel2d file, instead of its "
     "colours, with texels floor(u (W - 1)), floor(v (H - 1))",
     0},
    {"mapping", KEY_MAPPING, "NAME", 0,
     "vertices (a texel for each), affine, subdivided, or perspective "
     "(default)",
     0},
    {"span", KEY_SPAN, "PIXELS", 0,
     "between divisions when subdivided: 2, 4, 8, 16 (default), 32 or 64", 0},
    {"wrap", KEY_WRAP, "NAME", 0,
     "outside of the texture: clamp, repeat (default) or mirror", 0},
    {0},
};

/* Options that take one of some names. The index of a name is the number of
 * what it stands for. */
static const struct choice {
    int key;
    const char *option;
    const char *names[5];
} choices[] = {
    {KEY_SHADE, "--shade", {"flat", "gouraud", "phong"}},
    {KEY_NORMALS, "--normals-from", {"file", "smooth"}},
    {KEY_ORDER, "--order", {"painter", "zbuffer16", "zbuffer32", "zbuffer"}},
    {KEY_CULL, "--cull", {"none", "back", "front"}},
    {KEY_TEXTURE, "--texture", {"none", "nearest", "bilinear"}},
    {KEY_MAPPING,
     "--mapping",
     {"vertices", "affine", "subdivided", "perspective"}},
    {KEY_WRAP, "--wrap", {"clamp", "repeat", "mirror"}},
    {0, NULL, {NULL}},
};

static void set_choice(int key, int choice, struct scene_options *o)
{
    struct scene_settings *s = &o->settings;
    switch (key) {
    case KEY_SHADE:
        s->shade = (enum scene_shade)choice;
        break;
    case KEY_NORMALS:
        o->source.smooth_normals = choice == 1;
        break;
    case KEY_ORDER:
        s->order = choice == 3 ? SCENE_ZBUFFER32 : (enum scene_order)choice;
        break;
    case KEY_CULL:
        s->cull = (enum pel_cull)choice;
        break;
    case KEY_TEXTURE:
        s->texture = (enum scene_texture)choice;
        o->source.without_texture = choice == SCENE_TEXTURE_NONE;
        break;
    case KEY_MAPPING:
        s->mapping = (enum scene_mapping)choice;
        break;
    default:
        s->wrap = (enum pel_wrap)choice;
    }
}

static bool parse_choice(const struct choice *c, const char *text,
                         struct scene_options *o)
{
    int choice;
    if (!option_choice(c->option, text, c->names, &choice))
        return false;
    set_choice(c->key, choice, o);
    return true;
}

static bool parse_span(const char *text, struct scene_settings *s)
{
    int64_t v = 0;
    if (number_integer(text, 2, PEL_SPAN_MAX, &v) != NUMBER_OK ||
        (v & (v - 1)) != 0)
        return message_error("--span is '%s'; 2, 4, 8, 16, 32 or 64 would be "
                             "right",
                             text);
    s->span = (int)v;
    return true;
}

static bool parse_turn(const char *text, struct scene_settings *s)
{
    static const struct option_numbers numbers = {
        3, ',', -1, 1, "X,Y,Z in parts of a turn, such as 0,0.25,0,"};
    double turn[3];
    if (!option_numbers("--turn", text, &numbers, turn))
        return false;
    for (int k = 0; k < 3; k++)
        s->turn[k] = (uint16_t)lround(turn[k] * 65536);
    return true;
}

static bool parse_transparency(const char *text, struct scene_settings *s)
{
    int v;
    const bool right = option_integer("--transparency", text, 0, 255, &v);
    s->transparency = (uint8_t)v;
    return right;
}

static bool parse_value(int key, const char *text, struct scene_options *o)
{
    struct scene_settings *s = &o->settings;
    switch (key) {
    case KEY_COLOR:
        s->has_color = true;
        return option_color("--color", text, &s->color);
    case KEY_TRANSPARENCY:
        return parse_transparency(text, s);
    case KEY_TURN:
        return parse_turn(text, s);
    case KEY_SPAN:
        return parse_span(text, s);
    default:
        o->source.texture = text;
        return true;
    }
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct scene_options *o = state->input;
    const struct choice *choice = choices;
    if (key == ARGP_KEY_INIT) {
        state->child_inputs[0] = o;
        state->child_inputs[1] = o;
        return 0;
    }
    if (key < KEY_SHADE || key > KEY_WRAP)
        return ARGP_ERR_UNKNOWN;
    options_note(&o->given, options, key);
    while (choice->key && choice->key != key)
        choice++;
    const bool right =
        choice->key ? parse_choice(choice, text, o) : parse_value(key, text, o);
    return right ? 0 : EINVAL;
}

static const struct argp_child children[] = {
    {&camera_argp, 0, "Camera:", 2}, {&light_argp, 0, NULL, 3}, {0}};

const struct argp scene_argp = {
    .options = options, .parser = parse, .children = children};
