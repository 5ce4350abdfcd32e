/* MTL: numbers, and the options of textures. */
#include "sim/mesh/mend.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "sim/cli/message.h"

/* The options of a texture and how many words they take: -o, -s and -t one to
 * three numbers. */
static const struct option {
    const char *name;
    int least, most;
} options[] = {{"-blendu", 1, 1},  {"-blendv", 1, 1}, {"-bm", 1, 1},
               {"-boost", 1, 1},   {"-cc", 1, 1},     {"-clamp", 1, 1},
               {"-imfchan", 1, 1}, {"-mm", 2, 2},     {"-o", 1, 3},
               {"-s", 1, 3},       {"-t", 1, 3},      {"-texres", 1, 1},
               {"-type", 1, 1},    {NULL, 0, 0}};

static bool is_number(const char *word)
{
    char *end;
    strtod(word, &end);
    return end != word && (*end == '\0' || isblank(*end));
}

static const char *next_word(const char *text)
{
    text += strcspn(text, " \t");
    return text + strspn(text, " \t");
}

struct place {
    double scale[2], offset[2];
    bool is_clamped;
};

/* Takes an option at the beginning of a text, and returns what follows. NULL,
 * with a message, when it is wrong. */
static const char *take_option(const struct mend *m, const char *text,
                               const struct option *o, struct place *place)
{
    double *to = strcmp(o->name, "-s") == 0   ? place->scale
                 : strcmp(o->name, "-o") == 0 ? place->offset
                                              : NULL;
    const char *value = next_word(text);
    int n = 0;
    if (strcmp(o->name, "-clamp") == 0)
        place->is_clamped = strncmp(value, "on", 2) == 0;
    while (n < o->most && (n < o->least || is_number(value))) {
        if (o->most == 3 && !is_number(value)) {
            message_error_at(m->path, m->line,
                             "'%.60s' is no number of the option %s", value,
                             o->name);
            return NULL;
        }
        if (to && n < 2)
            to[n] = strtod(value, NULL);
        value = next_word(value);
        n++;
    }
    return value;
}

static bool put_texture(struct mend *m, const char *word, const char *text)
{
    struct place place = {{1, 1}, {0, 0}, false};
    while (text && *text == '-') {
        const struct option *o = options;
        const size_t n = strcspn(text, " \t");
        while (o->name &&
               (strlen(o->name) != n || strncasecmp(text, o->name, n) != 0))
            o++;
        if (!o->name)
            break; /* a name */
        text = take_option(m, text, o, &place);
    }
    if (!text)
        return false;
    fprintf(m->mtl, "%s %s", word, place.is_clamped ? "-clamp on " : "");
    if (strcmp(word, "map_Kd") == 0 &&
        (place.scale[0] != 1 || place.scale[1] != 1 || place.offset[0] != 0 ||
         place.offset[1] != 0))
        fprintf(m->mtl, "\1%.9g %.9g %.9g %.9g\1", place.scale[0],
                place.scale[1], place.offset[0], place.offset[1]);
    fprintf(m->mtl, "%s\n", text);
    return true;
}

/* Colours of one number are grey; those of a curve or of CIE are left out. */
static bool put_numbers(struct mend *m, const char *word, const char *text)
{
    double v[3] = {0, 0, 0};
    if (strncmp(text, "-halo", 5) == 0)
        text = next_word(text);
    if (strncmp(text, "xyz", 3) == 0 || strncmp(text, "spectral", 8) == 0) {
        message_error_at(m->path, m->line,
                         "'%s %.60s' is left out: expected red, green and blue",
                         word, text);
        return true;
    }
    if (!is_number(text))
        return message_error_at(m->path, m->line,
                                "%s has '%.60s': expected numbers", word, text);
    const int n = mend_numbers(m, text, v, 3);
    if (n < 0)
        return false;
    fprintf(m->mtl, "%s", word);
    for (int k = 0; k < (word[0] == 'K' ? 3 : 1); k++)
        fprintf(m->mtl, " %.9g", v[k < n ? k : 0]);
    fputc('\n', m->mtl);
    return true;
}

static bool put_line(struct mend *m, char *line)
{
    static const char *const numbers[] = {"Ka", "Kd", "Ks", "Ke", "Ns",
                                          "Ni", "d",  "Tr", NULL};
    char *rest = line + strcspn(line, " \t");
    if (*rest)
        *rest++ = '\0';
    rest += strspn(rest, " \t");
    m->has_material = m->has_material || strcasecmp(line, "newmtl") == 0;
    if (!m->has_material) {
        message_error_at(m->path, m->line,
                         "'%.60s' before the first newmtl is left out", line);
        return true;
    }
    for (int i = 0; numbers[i]; i++)
        if (strcasecmp(line, numbers[i]) == 0)
            return put_numbers(m, numbers[i], rest);
    if (strcasecmp(line, "map_Kd") == 0)
        return put_texture(m, "map_Kd", rest);
    if (strncasecmp(line, "map_", 4) == 0)
        return put_texture(m, line, rest);
    fprintf(m->mtl, "%s %s\n", line, rest);
    return true;
}

/* A library that is not there: many files were renamed together with it. */
static char *own_library(const struct mend *m)
{
    const char *dot = strrchr(m->path, '.');
    char *path = NULL;
    return asprintf(&path, "%.*s.mtl", dot ? (int)(dot - m->path) : 0,
                    m->path) < 0
               ? NULL
               : path;
}

static bool open_library(struct mend *m, struct mend *lines, const char *name)
{
    char *path = mend_path_beside(m->path, name);
    lines->path = path;
    if (path && mend_read_lines(lines, path))
        return true;
    free(path);
    lines->path = path = own_library(m);
    const bool found = path && mend_read_lines(lines, path);
    message_error_at(m->path, m->line,
                     "its materials %.200s cannot be read%s%.200s", name,
                     found ? ": expected them, and taken are those of " : "",
                     found ? path : "");
    return found;
}

bool mend_mtl(struct mend *m, const char *name)
{
    struct mend lines = {.mtl = m->mtl};
    if (!open_library(m, &lines, name))
        return true;
    for (char *at = lines.text; at;) {
        char *line = mend_line(&lines, &at);
        if (*line && !put_line(&lines, line))
            return false;
    }
    return true;
}
