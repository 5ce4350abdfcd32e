#include "sim/mesh/mend.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sim/cli/message.h"
#include "sim/cli/text_line.h"

bool mend_read(struct mend *m, const char *path)
{
    m->line = 0;
    m->text = file_read(file_named(path), &m->size);
    return m->text;
}

bool mend_read_lines(struct mend *m, const char *path)
{
    if (!mend_read(m, path))
        return false;
    for (size_t i = 0; i < m->size; i++)
        if (m->text[i] == '\r' && m->text[i + 1] != '\n')
            m->text[i] = '\n'; /* as old Macs had it */
    return true;
}

/* A # begins a comment; in lines of names, where a word does. */
static void cut_comment(char *line)
{
    static const char *const names[] = {"usemtl", "newmtl", "mtllib", "map_",
                                        "g ",     "o ",     NULL};
    bool may_hold = false;
    for (int i = 0; names[i]; i++)
        may_hold = may_hold || strncmp(line, names[i], strlen(names[i])) == 0;
    for (char *c = line; *c; c++)
        if (*c == '#' && (!may_hold || c == line || isblank(c[-1]))) {
            *c = '\0';
            return;
        }
}

static void cut_blanks(char *line)
{
    size_t n = strlen(line);
    while (n > 0 && isspace((unsigned char)line[n - 1]))
        line[--n] = '\0';
}

/* Does the line from `line` to `end` go on in the next one? Then what tells so
 * becomes blanks. */
static bool join(char *line, char *end)
{
    char *last = end;
    while (last > line && isspace((unsigned char)last[-1]))
        last--;
    if (last == line || last[-1] != '\\' ||
        memchr(line, '#', (size_t)(last - line)))
        return false;
    memset(last - 1, ' ', (size_t)(end - last) + 2);
    return true;
}

char *mend_line(struct mend *m, char **at)
{
    char *line = *at + strspn(*at, " \t\r\f\v"), *end = line;
    m->line++;
    while ((end = strchr(end, '\n')) && join(line, end))
        m->line++;
    *at = end ? end + 1 : NULL;
    if (end)
        *end = '\0';
    cut_comment(line);
    cut_blanks(line);
    return line;
}

int mend_word(const char *text)
{
    const size_t n = strcspn(text, " \t");
    return n < 80 ? (int)n : 80;
}

int mend_numbers(const struct mend *m, const char *text, double *number, int n)
{
    int i = 0;
    for (; i < n; i++) {
        char *end;
        text += strspn(text, " \t");
        if (*text == '\0')
            return i;
        number[i] = strtod(text, &end);
        if (end == text || (*end && !isblank(*end)) || !isfinite(number[i])) {
            message_error_at(m->path, m->line,
                             "'%.*s' is no number: expected one like -1.5e3",
                             mend_word(text), text);
            return -1;
        }
        text = end;
    }
    return i;
}

char *mend_path_beside(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    const int folder = slash ? (int)(slash - path) + 1 : 0;
    char *found = NULL, *beside = NULL, *own = strdup(name);
    for (char *c = own; c && *c; c++)
        if (*c == '\\') /* as files made on other systems have it */
            *c = '/';
    const char *last = own ? strrchr(own, '/') : NULL;
    if (!own ||
        asprintf(&found, "%.*s%s", *own == '/' ? 0 : folder, path, own) < 0)
        found = NULL;
    if (found && last && access(found, R_OK) != 0 &&
        asprintf(&beside, "%.*s%s", folder, path, last + 1) >= 0 &&
        access(beside, R_OK) == 0) {
        free(found);
        found = beside;
    } else
        free(beside);
    free(own);
    return found;
}
