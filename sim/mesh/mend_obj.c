/* OBJ: numbers, lines, faces and vertex colours as assimp takes them. */
#include "sim/mesh/mend.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sim/cli/message.h"

/* A word that begins the line, and what follows it; NULL when it is another. */
static const char *after(const char *line, const char *word)
{
    const size_t n = strlen(word);
    if (strncmp(line, word, n) != 0 || (line[n] && !isblank(line[n])))
        return NULL;
    return line + n + strspn(line + n, " \t");
}

/* Position, and colour where six numbers or more are there; a fourth or fifth
 * is the weight of a curve, which polygons do not have. */
static bool put_vertex(struct mend *m, const char *text)
{
    double v[8], color[3] = {MEND_NO_COLOR, MEND_NO_COLOR, MEND_NO_COLOR};
    const int n = mend_numbers(m, text, v, 8);
    if (n < 0)
        return false;
    if (n < 3 || n > 7)
        return message_error_at(m->path, m->line,
                                "a vertex has %d numbers: expected 3, and "
                                "perhaps 3 of its colour",
                                n);
    for (int k = 0; k < 3 && n >= 6; k++)
        color[k] = fmin(fmax(v[n == 7 ? 4 + k : 3 + k], 0), 1);
    fprintf(m->obj, "v %.9g %.9g %.9g", v[0], v[1], v[2]);
    if (!m->colorless)
        fprintf(m->obj, " %.9g %.9g %.9g", color[0], color[1], color[2]);
    fputc('\n', m->obj);
    return true;
}

static bool put_vector(struct mend *m, const char *word, const char *text,
                       int least)
{
    double v[3] = {0, 0, 0};
    const int n = mend_numbers(m, text, v, 3);
    if (n >= 0 && n < least)
        return message_error_at(
            m->path, m->line, "%s has %d numbers: expected %d", word, n, least);
    if (n >= 0 && least == 3)
        fprintf(m->obj, "vn %.9g %.9g %.9g\n", v[0], v[1], v[2]);
    else if (n >= 0)
        fprintf(m->obj, "vt %.9g %.9g\n", v[0], v[1]);
    return n >= 0;
}

static bool fits(const long index[3])
{
    for (int k = 0; k < 3; k++)
        if (index[k] < -INT32_MAX || index[k] > INT32_MAX)
            return false;
    return true;
}

/* Corners: an index of a vertex, or with /uv, //normal, /uv/normal. */
static bool put_face(struct mend *m, const char *text)
{
    fputc('f', m->obj);
    while (*text) {
        long index[3] = {0, 0, 0};
        const char *word = text;
        int k = 0;
        for (; k < 3; k++) {
            char *end;
            index[k] = *text == '/' ? 0 : strtol(text, &end, 10);
            if (*text != '/' && (end == text || index[k] == 0))
                break;
            text = *text == '/' ? text : end;
            if (*text != '/')
                break;
            text++;
            if (*text == '\0' || isblank(*text))
                break;
        }
        if (index[0] == 0 || k == 3 || !fits(index) ||
            (*text && !isblank(*text)))
            return message_error_at(m->path, m->line,
                                    "'%.*s' is no corner of a face: expected "
                                    "numbers like 1, 1/2, 1//3 or 1/2/3",
                                    mend_word(word), word);
        fprintf(m->obj, " %ld", index[0]);
        if (index[1])
            fprintf(m->obj, "/%ld", index[1]);
        if (index[2])
            fprintf(m->obj, "%s/%ld", index[1] ? "" : "/", index[2]);
        text += strspn(text, " \t");
    }
    fputc('\n', m->obj);
    return true;
}

/* One name, perhaps with blanks in it; or several. */
static bool put_library(struct mend *m, const char *text)
{
    char *path = mend_path_beside(m->path, text), *names, *rest, *name;
    const bool is_one = path && access(path, R_OK) == 0;
    free(path);
    if (is_one)
        return mend_mtl(m, text);
    rest = names = strdup(text);
    bool good = names;
    while (good && (name = strtok_r(rest, " \t", &rest)))
        good = mend_mtl(m, name);
    free(names);
    return good;
}

static bool put_line(struct mend *m, const char *line)
{
    const char *rest;
    if ((rest = after(line, "v")))
        return put_vertex(m, rest);
    if ((rest = after(line, "vt")))
        return put_vector(m, "vt", rest, 1);
    if ((rest = after(line, "vn")))
        return put_vector(m, "vn", rest, 3);
    if ((rest = after(line, "f")) || (rest = after(line, "fo")))
        return put_face(m, rest);
    if ((rest = after(line, "mtllib")))
        return put_library(m, rest);
    if (*line)
        fprintf(m->obj, "%s\n", line);
    return true;
}

/* Does a vertex have a colour? Lines are joined in a copy of the text. False,
 * with a message, when there is no memory for one. */
static bool find_colors(struct mend *m)
{
    char *text = malloc(m->size + 1), *at = text;
    struct mend copy = {.text = text};
    m->colorless = true;
    if (!text)
        return message_error_at(m->path, 0, "no memory for its lines");
    memcpy(text, m->text, m->size + 1);
    while (at && m->colorless) {
        const char *word = after(mend_line(&copy, &at), "v");
        int words = 0;
        for (; word && *word; words++) {
            word += strcspn(word, " \t");
            word += strspn(word, " \t");
        }
        m->colorless = words < 6;
    }
    free(text);
    return true;
}

bool mend_obj(struct mend *m)
{
    if (!find_colors(m))
        return false;
    fprintf(m->obj, "mtllib pel.mtl\n");
    for (char *at = m->text; at;) {
        const char *line = mend_line(m, &at);
        if (!put_line(m, line))
            return false;
    }
    return true;
}
