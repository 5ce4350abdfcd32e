#include "sim/render/scene_options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/mesh/vector.h"

/* X,Y,Z:R,G,B */
static bool read_light(const char *text, struct scene_light *light)
{
    static const struct option_row place = {
        .n = 3, .separator = ',', .low = -MESH_LIMIT, .high = MESH_LIMIT};
    static const struct option_row channels = {
        .n = 3, .separator = ',', .low = 0, .high = 15.99};
    char copy[256], *color = copy;
    snprintf(copy, sizeof(copy), "%s", text);
    const char *at = strsep(&color, ":");
    return color && strlen(text) < sizeof(copy) &&
           option_numbers(at, &place, light->at) &&
           option_numbers(color, &channels, light->color);
}

static bool parse_light(const char *option, const char *text, void *input)
{
    struct scene_settings *s = &((struct scene_options *)input)->settings;
    struct scene_light *light = &s->light[s->lights];
    if (s->lights == SCENE_LIGHTS_MAX)
        return message_error("--%s is light %d: expected up to %d", option,
                             s->lights + 1, SCENE_LIGHTS_MAX);
    if (!read_light(text, light))
        return option_refuse(option, text,
                             "X,Y,Z:R,G,B with colours from 0 to 15.99, such "
                             "as 2,5,3:1,1,1");
    light->directional = strcmp(option, "sun") == 0;
    if (light->directional && vector_length(light->at) <= 0)
        return option_refuse(option, text,
                             "the direction towards it, such as 1,2,1:1,1,1");
    s->lights++;
    return true;
}

/* Names between commas: bit i is the i-th of SCENE_TERMS. */
static bool parse_terms(const char *option, const char *text, void *input)
{
    struct scene_settings *s = &((struct scene_options *)input)->settings;
    char copy[64], *rest = copy;
    s->terms = 0;
    snprintf(copy, sizeof(copy), "%s", text);
    while (rest) {
        const int term = choice_find(SCENE_TERMS, strsep(&rest, ","));
        if (term < 0 || strlen(text) >= sizeof(copy))
            return option_refuse(option, text,
                                 "a list of ambient, diffuse and specular, "
                                 "such as ambient,diffuse");
        s->terms |= 1u << term;
    }
    return true;
}

static bool parse_unlit(const char *option, const char *text, void *input)
{
    (void)option;
    (void)text;
    ((struct scene_options *)input)->settings.lit = SCENE_UNLIT;
    return true;
}

static bool parse_turn(const char *option, const char *text, void *input)
{
    struct scene_settings *s = &((struct scene_options *)input)->settings;
    static const struct option_row numbers = {
        .n = 3, .separator = ',', .low = -1, .high = 1};
    double turn[3];
    if (!option_numbers(text, &numbers, turn))
        return option_refuse(option, text,
                             "X,Y,Z in parts of a turn, such as 0,0.25,0");
    for (int k = 0; k < 3; k++)
        s->turn[k] = (uint16_t)lround(turn[k] * 65536);
    return true;
}

#define AT(member) offsetof(struct scene_options, member)
#define SIZE(member) sizeof(((struct scene_options *)NULL)->member)
#define HEADING(text) \
    {                 \
        .help = text  \
    }
#define CALL(function) OPTION_CALL, .parse = function
#define CHOICE(member, names) \
    OPTION_CHOICE, .offset = AT(member), .n = SIZE(member), .expected = names
#define NUMBERS(member, count, between, least, most, example)               \
    OPTION_NUMBERS, .offset = AT(member), .n = count, .separator = between, \
                    .low = least, .high = most, .expected = example
#define POINT(member) \
    NUMBERS(member, 3, ',', -MESH_LIMIT, MESH_LIMIT, "X,Y,Z such as 0,1.5,4")
#define FACTOR(member)                                                        \
    NUMBERS(member, 1, 0, 0, 15.99, "a number from 0 to 15.99, such as 0.5"), \
        .flag = AT(settings.has_light)

const struct option_row scene_option_table[] = {
    HEADING("Shading:"),
    {"shade", "MODE", "flat, gouraud (default) or phong",
     CHOICE(settings.shade, SCENE_SHADES)},
    {"tolerance", "STEPS",
     "for Phong: for each triangle the cheapest method that is proven to be "
     "within so many steps of 255, without dim lights (default: 0, exact)",
     NUMBERS(settings.tolerance, 1, 0, 0, 255,
             "a number from 0 to 255, such as 2")},
    {"color", "COLOUR", "#rrggbb for the whole mesh instead of its colours",
     OPTION_COLOR, .offset = AT(settings.color),
     .flag = AT(settings.has_color)},
    {"transparency", "0..255", "0 (default) is opaque, 255 draws nothing",
     OPTION_INTEGER, .offset = AT(settings.transparency), .low = 0,
     .high = 255},
    {"normals-from", "SOURCE",
     "file (default: where it has them), or smooth: at each vertex the mean of "
     "the faces around it; facets are --shade flat",
     CHOICE(source.smooth_normals, SCENE_NORMALS)},
    {"crease", "DEGREES",
     "make normals whatever the file has, with an edge between faces that are "
     "turned by more than this (default of normals that are made: 120)",
     NUMBERS(source.crease, 1, 0, 0, 180, "an angle from 0 to 180, such as 40"),
     .flag = AT(source.has_crease)},
    {"turn", "X,Y,Z",
     "turn the mesh around its middle, in parts of a turn around x, then y, "
     "then z",
     CALL(parse_turn)},
    {"order", "NAME",
     "auto (default): exact at every pixel, by the painter's order where it is "
     "proven and by depths of 32 bits elsewhere, without memory for them an "
     "error; painter, for devices without depths: some pixels may be wrong; "
     "zbuffer16: may mix close surfaces; or zbuffer32, zbuffer for short: "
     "depths alone",
     CHOICE(settings.order, SCENE_ORDERS)},
    {"cull", "SIDE", "leave out none (default), back or front",
     CHOICE(settings.cull, SCENE_CULLS)},
    HEADING("Camera:"),
    {"eye", "X,Y,Z",
     "where the camera stands (default: where it sees the whole mesh)",
     POINT(settings.camera.eye), .flag = AT(settings.camera.has_eye)},
    {"target", "X,Y,Z", "what it looks at (default: the mesh's middle)",
     POINT(settings.camera.target), .flag = AT(settings.camera.has_target)},
    {"up", "X,Y,Z", "what is up in the picture (default: 0,1,0)",
     POINT(settings.camera.up)},
    {"projection", "NAME", "perspective (default) or orthographic",
     CHOICE(settings.camera.projection, CAMERA_PROJECTIONS)},
    {"focal", "MM", "focal length in mm (default: 50)",
     NUMBERS(settings.camera.focal, 1, 0, 1e-6, 1e6,
             "a length in mm, such as 50")},
    {"sensor", "WxH",
     "sensor size in mm (default: 36 mm wide, square pixels); of an "
     "orthographic camera the size of what is seen, in the mesh's units",
     NUMBERS(settings.camera.sensor, 2, 'x', 1e-6, MESH_LIMIT,
             "WxH in mm, such as 36x24"),
     .flag = AT(settings.camera.has_sensor)},
    {"near", "DISTANCE",
     "nothing nearer to the eye is seen (default: just before the mesh)",
     NUMBERS(settings.camera.near_plane, 1, 0, 1e-15, MESH_LIMIT,
             "a distance above 0, such as 0.1"),
     .flag = AT(settings.camera.has_near)},
    {"size", "WxH", "of the picture, in pixels (default: 1200x1200)",
     OPTION_INTEGER, .offset = AT(settings.camera.width), .n = 2,
     .separator = 'x', .low = 1, .high = 32767,
     .expected = "WxH from 1x1 to 32767x32767, such as 640x480"},
    {"background", "COLOUR", "#rrggbb (default: #ffffff)", OPTION_COLOR,
     .offset = AT(settings.camera.background)},
    HEADING("Light (none unless one of these is given, for Phong, and where "
            "nothing else would show the shape):"),
    {"light", "X,Y,Z:R,G,B",
     "a light at a place, 1,1,1 being full white; up to 32 (default: one from "
     "above, left of the viewer)",
     CALL(parse_light), .flag = AT(settings.has_light)},
    {"sun", "X,Y,Z:R,G,B", "a light from that direction", CALL(parse_light),
     .flag = AT(settings.has_light)},
    {"ambient", "R,G,B", "ambient light (default: 1,1,1)",
     NUMBERS(settings.ambient_color, 3, ',', 0, 15.99,
             "R,G,B from 0 to 15.99, such as 1,0.9,0.8"),
     .flag = AT(settings.has_light)},
    {"ka", "NUMBER", "ambient factor (default: 0.3)", FACTOR(settings.ambient)},
    {"kd", "NUMBER", "diffuse factor (default: 0.7)", FACTOR(settings.diffuse)},
    {"ks", "NUMBER", "specular factor (default: 0.3)",
     FACTOR(settings.specular)},
    {"shininess", "1..256", "exponent of highlights (default: 20)",
     OPTION_INTEGER, .offset = AT(settings.shininess),
     .flag = AT(settings.has_light), .low = 1, .high = 256},
    {"terms", "LIST", "which of ambient,diffuse,specular (default: all)",
     CALL(parse_terms), .flag = AT(settings.has_light)},
    {"highlights", "KIND", "coloured (default) by the surface, or plain",
     CHOICE(settings.plain_highlights, SCENE_HIGHLIGHTS),
     .flag = AT(settings.has_light)},
    {"back-highlights", "WHETHER",
     "highlights where light falls on the back: on (default), as the formula "
     "stands, or off",
     CHOICE(settings.no_back_highlights, "on|off"),
     .flag = AT(settings.has_light)},
    {"light-sides", "WHICH",
     "front (default), or both: a normal that points away from the eye is "
     "turned",
     CHOICE(settings.both_sides, SCENE_SIDES)},
    {"interpolation", "WHERE",
     "colours, normals and positions are linear on screen (default), or in the "
     "world: right on large triangles that lead away",
     CHOICE(settings.in_world, SCENE_INTERPOLATIONS)},
    {"unlit", NULL, "no light, whatever the mesh", CALL(parse_unlit)},
    HEADING("Texture:"),
    {"texture", "MODE", "none, nearest or bilinear (default)",
     CHOICE(settings.texture, SCENE_TEXTURES)},
    {"texture-file", "FILE",
     "this picture instead of the mesh's own; of a pel2d file, instead of its "
     "colours, with texels floor(u (W - 1)), floor(v (H - 1))",
     OPTION_TEXT, .offset = AT(source.texture)},
    {"mapping", "NAME",
     "vertices (a texel for each), affine, subdivided, or perspective "
     "(default)",
     CHOICE(settings.mapping, SCENE_MAPPINGS)},
    {"texel-tolerance", "TEXELS",
     "in perspective: the cheapest mapping of each triangle that is proven to "
     "be within so many texels (default: 0, exact)",
     NUMBERS(settings.texel_tolerance, 1, 0, 0, 256,
             "a number from 0 to 256, such as 0.5")},
    {"span", "PIXELS",
     "between divisions when subdivided: 2, 4, 8, 16 (default), 32 or 64",
     CHOICE(settings.span, SCENE_SPANS)},
    {"wrap", "NAME",
     "outside of the texture: clamp, repeat, mirror, or own (default), as the "
     "mesh file says and repeat where it does not",
     CHOICE(settings.wrap, SCENE_WRAPS)},
    {.help = NULL},
};
