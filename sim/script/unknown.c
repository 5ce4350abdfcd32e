/* Messages for commands that do not exist. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/script/parser.h"

enum { NAME_MAX_SIZE = 64, COLUMNS = 80 };

/* The first n words, or as many as there are, with a blank between two. */
static void join_words(const struct script_parser *p, size_t n,
                       char text[NAME_MAX_SIZE])
{
    size_t length = 0;
    text[0] = '\0';
    for (size_t i = 0; i < n && i < p->word_count && length < NAME_MAX_SIZE;
         i++)
        length += (size_t)snprintf(text + length, NAME_MAX_SIZE - length,
                                   "%s%s", i ? " " : "", p->words[i]);
}

size_t script_name_words(const char *name)
{
    size_t n = 1;
    for (; *name; name++)
        n += *name == ' ';
    return n;
}

/* Characters to change, leave out or add until a is b: one row after the other
 * of Levenshtein's table. */
static int distance(const char *a, const char *b)
{
    int row[NAME_MAX_SIZE + 1];
    const int n = (int)strlen(b);
    for (int j = 0; j <= n; j++)
        row[j] = j;
    for (int i = 1; a[i - 1]; i++) {
        int diagonal = row[0];
        row[0] = i;
        for (int j = 1; j <= n; j++) {
            const int changed = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            if (row[j - 1] < row[j])
                row[j] = row[j - 1];
            row[j] = changed <= row[j] ? changed : row[j] + 1;
        }
    }
    return row[n];
}

/* The command that is nearest to the line's first words, at a distance of 2 at
 * most and less than half the name; or NULL. */
static const struct script_command *guess(const struct script_parser *p)
{
    const struct script_command *best = NULL;
    int least = 3;
    for (const struct script_command *const *t = script_tables; *t; t++) {
        for (const struct script_command *c = *t; c->name; c++) {
            char given[NAME_MAX_SIZE];
            join_words(p, script_name_words(c->name), given);
            const int d = distance(given, c->name);
            if (d < least && 2 * d < (int)strlen(c->name)) {
                least = d;
                best = c;
            }
        }
    }
    return best;
}

size_t script_common_words(const struct script_parser *p, const char *name)
{
    size_t n = 0;
    while (*name && n < p->word_count) {
        const size_t length = strcspn(name, " ");
        if (strlen(p->words[n]) != length ||
            memcmp(p->words[n], name, length) != 0)
            break;
        name += length + (name[length] == ' ');
        n++;
    }
    return n;
}

/* True when no command before this one has the same first word. */
static bool is_first(const struct script_command *command)
{
    const size_t size = strcspn(command->name, " ");
    for (const struct script_command *const *t = script_tables; *t; t++)
        for (const struct script_command *c = *t; c->name; c++)
            if (strcspn(c->name, " ") == size &&
                memcmp(c->name, command->name, size) == 0)
                return c == command;
    return true;
}

/* The commands that begin with the line's first `common` words; when that is
 * none, the first words of all. */
static void print_names(FILE *out, const struct script_parser *p, size_t common)
{
    size_t column = COLUMNS / 2; /* about where the message has come */
    for (const struct script_command *const *t = script_tables; *t; t++)
        for (const struct script_command *c = *t; c->name; c++) {
            const size_t size =
                common ? strlen(c->name) : strcspn(c->name, " ");
            if (common ? script_common_words(p, c->name) < common
                       : !is_first(c))
                continue;
            const bool wrap = column + size + 3 > COLUMNS;
            fprintf(out, "%s%s%.*s", ftell(out) ? "," : "",
                    wrap ? "\n    " : " ", (int)size, c->name);
            column = (wrap ? 4 : column + 2) + size;
        }
}

static size_t most_common_words(const struct script_parser *p)
{
    size_t most = 0;
    for (const struct script_command *const *t = script_tables; *t; t++) {
        for (const struct script_command *c = *t; c->name; c++) {
            const size_t n = script_common_words(p, c->name);
            most = n > most ? n : most;
        }
    }
    return most;
}

bool script_refuse_unknown(const struct script_parser *p)
{
    const size_t common = most_common_words(p);
    const struct script_command *meant = guess(p);
    char given[NAME_MAX_SIZE], *names = NULL;
    size_t size;
    join_words(p, common + 1, given);
    if (meant)
        return message_error_at(p->script->path, p->line,
                                "unknown command %s; did you mean %s?", given,
                                meant->name);
    FILE *out = open_memstream(&names, &size);
    if (out) {
        print_names(out, p, common);
        fclose(out);
    }
    message_error_at(p->script->path, p->line, "unknown command %s: expected%s",
                     given, names ? names : " another");
    free(names);
    return false;
}
