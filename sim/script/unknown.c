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

/* The commands that begin with the line's first `common` words; when that is
 * none, the first words of all, each once. */
static void print_names(FILE *out, const struct script_parser *p, size_t common)
{
    size_t column = COLUMNS / 2; /* about where the message has come */
    const char *last = "";
    for (const struct script_command *const *t = script_tables; *t; t++)
        for (const struct script_command *c = *t; c->name; c++) {
            const size_t size =
                common ? strlen(c->name) : strcspn(c->name, " ");
            if (script_common_words(p, c->name) < common ||
                (!common && strncmp(last, c->name, size) == 0 &&
                 strcspn(last, " ") == size))
                continue;
            const bool wrap = column + size + 3 > COLUMNS;
            fprintf(out, "%s%s%.*s", ftell(out) ? "," : "",
                    wrap ? "\n    " : " ", (int)size, c->name);
            column = (wrap ? 4 : column + 2) + size;
            last = c->name;
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
    char given[NAME_MAX_SIZE], *names = NULL;
    size_t size;
    join_words(p, common + 1, given);
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
