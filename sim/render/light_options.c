#include <errno.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/cli/option_text.h"
#include "sim/render/scene_options.h"

enum {
    KEY_LIGHT = 0x400,
    KEY_SUN,
    KEY_AMBIENT,
    KEY_KA,
    KEY_KD,
    KEY_KS,
    KEY_SHININESS,
    KEY_TERMS,
    KEY_HIGHLIGHTS,
    KEY_BACK_HIGHLIGHTS,
    KEY_UNLIT
};

static const struct argp_option options[] = {
    {0, 0, 0, 0,
     "Light (none unless one of these is given, for Phong, and "
     "where nothing else would show the shape):",
     3},
    {"light", KEY_LIGHT, "X,Y,Z:R,G,B", 0,
     "a light at a place, 1,1,1 being full white; up to 32 (default: one from "
     "above, left of the viewer)",
     0},
    {"sun", KEY_SUN, "X,Y,Z:R,G,B", 0, "a light from that direction", 0},
    {"ambient", KEY_AMBIENT, "R,G,B", 0, "ambient light (default: 1,1,1)", 0},
    {"ka", KEY_KA, "NUMBER", 0, "ambient factor (default: 0.3)", 0},
    {"kd", KEY_KD, "NUMBER", 0, "diffuse factor (default: 0.7)", 0},
    {"ks", KEY_KS, "NUMBER", 0, "specular factor (default: 0.3)", 0},
    {"shininess", KEY_SHININESS, "1..256", 0,
     "exponent of highlights (default: 20)", 0},
    {"terms", KEY_TERMS, "LIST", 0,
     "which of ambient,diffuse,specular (default: all)", 0},
    {"highlights", KEY_HIGHLIGHTS, "KIND", 0,
     "coloured (default) by the surface, or plain", 0},
    {"back-highlights", KEY_BACK_HIGHLIGHTS, "WHETHER", 0,
     "highlights where light falls on the back: on (default), as the formula "
     "stands, or off",
     0},
    {"unlit", KEY_UNLIT, NULL, 0, "no light, whatever the mesh", 0},
    {0},
};

static const struct option_numbers channels = {
    3, ',', 0, 15.99, "R,G,B from 0 to 15.99, such as 1,0.9,0.8,"};

/* X,Y,Z:R,G,B */
static bool read_light(const char *text, struct scene_light *light)
{
    static const struct option_numbers place = {3, ',', -MESH_LIMIT, MESH_LIMIT,
                                                NULL};
    char copy[256];
    const size_t length = strcspn(text, ":");
    if (text[length] == '\0' || length >= sizeof(copy))
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    return option_numbers_read(copy, &place, light->at) &&
           option_numbers_read(text + length + 1, &channels, light->color);
}

static bool parse_light(const char *option, const char *text,
                        struct scene_settings *s)
{
    struct scene_light *light = &s->light[s->lights];
    if (s->lights == SCENE_LIGHTS_MAX)
        return message_error("%s is light %d; up to %d would be right", option,
                             s->lights + 1, SCENE_LIGHTS_MAX);
    if (!read_light(text, light))
        return message_error("%s is '%s'; X,Y,Z:R,G,B with colours from 0 to "
                             "15.99, such as 2,5,3:1,1,1, would be right",
                             option, text);
    light->directional = strcmp(option, "--sun") == 0;
    if (light->directional && light->at[0] == 0 && light->at[1] == 0 &&
        light->at[2] == 0)
        return message_error("--sun is '%s'; the way towards it, such as "
                             "1,2,1:1,1,1, would be right",
                             text);
    s->lights++;
    return true;
}

static bool parse_factor(const char *option, const char *text, double *factor)
{
    static const struct option_numbers numbers = {
        1, 0, 0, 15.99, "a number from 0 to 15.99, such as 0.5,"};
    return option_numbers(option, text, &numbers, factor);
}

/* The bit of a name that ends at a comma or the text's end; 0: none. */
static unsigned find_term(const char *text)
{
    static const char *const names[] = {"ambient", "diffuse", "specular"};
    const size_t length = strcspn(text, ",");
    for (unsigned i = 0; i < 3; i++)
        if (strlen(names[i]) == length && memcmp(names[i], text, length) == 0)
            return 1u << i;
    return 0;
}

static bool parse_terms(const char *text, struct scene_settings *s)
{
    unsigned term = 1;
    s->terms = 0;
    for (const char *at = text; *at && term; at += at[0] == ',') {
        term = find_term(at);
        s->terms |= term;
        at += strcspn(at, ",");
    }
    return (s->terms && term) ||
           message_error("--terms is '%s'; a list of ambient, diffuse and "
                         "specular, such as ambient,diffuse, would be right",
                         text);
}

static bool parse_highlights(const char *text, struct scene_settings *s)
{
    static const char *const names[] = {"coloured", "plain", NULL};
    int choice = 0;
    const bool right = option_choice("--highlights", text, names, &choice);
    s->plain_highlights = choice == 1;
    return right;
}

static bool parse_back_highlights(const char *text, struct scene_settings *s)
{
    static const char *const names[] = {"on", "off", NULL};
    int choice = 0;
    const bool right = option_choice("--back-highlights", text, names, &choice);
    s->no_back_highlights = choice == 1;
    return right;
}

/* The options after which there is light. */
static bool parse_lighting(int key, const char *text, struct scene_settings *s)
{
    s->has_light = true;
    switch (key) {
    case KEY_LIGHT:
        return parse_light("--light", text, s);
    case KEY_SUN:
        return parse_light("--sun", text, s);
    case KEY_AMBIENT:
        return option_numbers("--ambient", text, &channels, s->ambient_color);
    case KEY_KA:
        return parse_factor("--ka", text, &s->ambient);
    case KEY_KD:
        return parse_factor("--kd", text, &s->diffuse);
    case KEY_KS:
        return parse_factor("--ks", text, &s->specular);
    case KEY_SHININESS:
        return option_integer("--shininess", text, 1, 256, &s->shininess);
    case KEY_TERMS:
        return parse_terms(text, s);
    case KEY_HIGHLIGHTS:
        return parse_highlights(text, s);
    default:
        return parse_back_highlights(text, s);
    }
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct scene_options *o = state->input;
    if (key < KEY_LIGHT || key > KEY_UNLIT)
        return ARGP_ERR_UNKNOWN;
    options_note(&o->given, options, key);
    if (key == KEY_UNLIT) {
        o->settings.lit = SCENE_UNLIT;
        return 0;
    }
    return parse_lighting(key, text, &o->settings) ? 0 : EINVAL;
}

const struct argp light_argp = {.options = options, .parser = parse};
