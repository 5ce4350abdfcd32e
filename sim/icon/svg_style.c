/* The properties of elements, in attributes or in style="...". What would look
 * different without being read is refused by its name. */
#include "sim/icon/svg_reader.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

static const char blanks[] = " \t\r\n";

bool svg_refuse(struct reader *r, const char *format, ...)
{
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (!r->bad)
        ERROR_AT(r->svg, "%s", text);
    r->bad = true;
    XML_StopParser(r->parser, XML_FALSE);
    return false;
}

char *svg_copy(struct reader *r, const char *text, size_t n)
{
    char *copy = strndup(text, n);
    if (!copy)
        svg_refuse(r, "out of memory");
    return copy;
}

static bool begins(const char *text, const char *word)
{
    return strncmp(text, word, strlen(word)) == 0;
}

bool svg_set_paint(struct reader *r, const char *text, struct svg_paint *to)
{
    *to = (struct svg_paint){.kind = SVG_NONE};
    if (begins(text, "none"))
        return true;
    if (strncasecmp(text, "currentColor", 12) == 0) {
        to->kind = SVG_CURRENT;
        return true;
    }
    if (begins(text, "url(")) {
        text += 4 + strspn(text + 4, " \"'");
        if (*text++ != '#')
            return svg_refuse(r, "a colour in another file, %.100s", text - 1);
        to->kind = SVG_GRADIENT;
        to->id = svg_copy(r, text, strcspn(text, " \"')"));
        return to->id;
    }
    to->kind = SVG_COLOR;
    return svg_color(text, &to->color) ||
           svg_refuse(r,
                      "the colour '%.60s': expected #rrggbb, rgb(), one of "
                      "HTML's names or url(#gradient)",
                      text);
}

static bool set_number(struct reader *r, const char *name, const char *text,
                       double *to)
{
    struct svg_length length;
    if (!svg_length(text, &length) ||
        (length.percent && begins(name, "stroke-width")))
        return svg_refuse(r, "%s is '%.60s': expected a number of px", name,
                          text);
    *to = length.value;
    return true;
}

bool svg_set_part(struct reader *r, const char *name, const char *text,
                  double *to)
{
    const bool done = set_number(r, name, text, to);
    *to = fmin(fmax(*to, 0), 1);
    return done;
}

bool svg_set_word(struct reader *r, const char *name, const char *text,
                  const char *words, int *to)
{
    const size_t n = strcspn(text, blanks);
    const char *w = words;
    for (*to = 0; *w; ++*to) {
        const size_t length = strcspn(w, " ");
        if (length == n && strncmp(w, text, n) == 0)
            return true;
        w += length + (w[length] == ' ');
    }
    return svg_refuse(r, "%s is '%.60s': expected one of %s", name, text,
                      words);
}

/* What pel draws by, and with NONE what it does not: the one value of those
 * that changes nothing. */
static const struct property {
    const char *name;
    enum { PAINT, PART, NUMBER, WORD, NONE } kind;
    size_t offset; /* in struct element */
    const char *words;
} properties[] = {
#define OF(member) offsetof(struct element, member)
    {"fill", PAINT, OF(style.fill), NULL},
    {"stroke", PAINT, OF(style.stroke), NULL},
    {"opacity", PART, OF(own_opacity), NULL},
    {"fill-opacity", PART, OF(style.fill_opacity), NULL},
    {"stroke-opacity", PART, OF(style.stroke_opacity), NULL},
    {"stroke-width", NUMBER, OF(style.width), NULL},
    {"stroke-miterlimit", NUMBER, OF(style.miter_limit), NULL},
    {"stroke-linecap", WORD, OF(style.cap), "butt square round"},
    {"stroke-linejoin", WORD, OF(style.join), "bevel miter round"},
    {"fill-rule", WORD, OF(style.rule), "evenodd nonzero"},
    {"visibility", WORD, OF(style.hidden), "visible hidden collapse"},
#undef OF
    {"filter", NONE, 0, "none"},
    {"mask", NONE, 0, "none"},
    {"clip-path", NONE, 0, "none"},
    {"marker", NONE, 0, "none"},
    {"marker-start", NONE, 0, "none"},
    {"marker-mid", NONE, 0, "none"},
    {"marker-end", NONE, 0, "none"},
    {"vector-effect", NONE, 0, "none"},
    {"paint-order", NONE, 0, "normal"},
    {"mix-blend-mode", NONE, 0, "normal"}};

static bool set_by(struct reader *r, const struct property *p, void *at,
                   const char *text)
{
    switch (p->kind) {
    case PAINT:
        return svg_set_paint(r, text, at);
    case PART:
        return svg_set_part(r, p->name, text, at);
    case NUMBER:
        return set_number(r, p->name, text, at);
    case WORD:
        return svg_set_word(r, p->name, text, p->words, at);
    default:
        return strcmp(text, p->words) == 0 ||
               svg_refuse(r,
                          "%s is '%.60s', which pel does not draw: expected "
                          "shapes without, or a PNG",
                          p->name, text);
    }
}

bool svg_set_property(struct reader *r, void *to, const char *name,
                      const char *text)
{
    struct element *const e = to;
    if (begins(text, "inherit"))
        return true;
    for (size_t i = 0; i < sizeof properties / sizeof *properties; i++)
        if (strcmp(properties[i].name, name) == 0)
            return set_by(r, &properties[i], (char *)to + properties[i].offset,
                          text);
    if (strcmp(name, "stroke-dasharray") == 0)
        e->style.dashed = !begins(text, "none");
    if (strcmp(name, "display") == 0 && begins(text, "none"))
        r->skipped = 1;
    return strcmp(name, "transform") != 0 || svg_transform(text, &e->matrix) ||
           svg_refuse(r,
                      "transform is '%.100s': expected functions such as "
                      "translate(3, 4)",
                      text);
}

const char *svg_attribute(const char **list, const char *name)
{
    for (; *list; list += 2)
        if (strcmp(*list, name) == 0)
            return list[1];
    return NULL;
}

/* Without the blanks around it. */
static char *trimmed(char *text)
{
    text += strspn(text, blanks);
    for (size_t n = strlen(text); n > 0 && strchr(blanks, text[n - 1]); n--)
        text[n - 1] = '\0';
    return text;
}

/* NAME: VALUE; ... */
static void each_of_style(struct reader *r, const char *text, void *to,
                          svg_setter *set)
{
    char *const copy = svg_copy(r, text, strlen(text));
    char *rest = copy;
    while (rest && !r->bad) {
        char *const name = strsep(&rest, ";"), *const colon = strchr(name, ':');
        if (colon) {
            *colon = '\0';
            set(r, to, trimmed(name), trimmed(colon + 1));
        }
    }
    free(copy);
}

bool svg_each_property(struct reader *r, const char **list, void *to,
                       svg_setter *set)
{
    const char *const style = svg_attribute(list, "style");
    for (const char **a = list; *a && !r->bad; a += 2)
        set(r, to, *a, a[1] + strspn(a[1], blanks));
    if (style)
        each_of_style(r, style, to, set);
    return !r->bad;
}
