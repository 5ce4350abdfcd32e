/* Finding the command of a line, and the message when there is none. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/script/parser.h"

enum { COLUMNS = 80 };

/* How many words of a name the line begins with; *whole: with all. */
static size_t common_words(const struct script_parser *p, const char *name,
                           bool *whole)
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
    *whole = !*name;
    return n;
}

static size_t shown_length(const char *name, size_t common)
{
    return common ? strlen(name) : strcspn(name, " ");
}

/* Is a command before `end` shown as the same text? */
static bool is_told(const struct script_command *end, size_t common)
{
    const size_t length = shown_length(end->name, common);
    const struct script_command *c = script_shapes;
    while (c != end && (shown_length(c->name, common) != length ||
                        memcmp(c->name, end->name, length) != 0))
        c = script_next(c);
    return c != end;
}

/* The commands that begin with the line's first `common` words; when that is
 * none, the first words of all, each once. */
static void print_names(FILE *out, const struct script_parser *p, size_t common)
{
    size_t column = COLUMNS / 2; /* about where the message has come */
    const char *separator = "";
    bool whole;
    for (const struct script_command *c = script_shapes; c;
         c = script_next(c)) {
        const char *name = c->name;
        const size_t length = shown_length(name, common);
        if (common_words(p, name, &whole) < common || is_told(c, common))
            continue;
        const bool wrap = column + length + 3 > COLUMNS;
        fprintf(out, "%s%s%.*s", separator, wrap ? "\n    " : " ", (int)length,
                name);
        column = (wrap ? 4 : column + 2) + length;
        separator = ",";
    }
}

/* Without ends of lines, which strtok_r would take for its own. */
static void print_word(FILE *out, const char *word)
{
    fputc(' ', out);
    for (int i = 0; i < 60 && word[i]; i++)
        fputc(word[i] == '\n' ? '?' : word[i], out);
}

/* The list goes on in lines of its own. */
static bool refuse(const struct script_parser *p, size_t common)
{
    char *text = NULL, *rest = NULL;
    size_t size;
    const char *line;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return message_error("out of memory");
    for (size_t i = 0; i <= common && i < p->word_count; i++)
        print_word(out, p->words[i]);
    fprintf(out, ": expected");
    print_names(out, p, common);
    if (fclose(out) == 0)
        ERROR_AT(p, "unknown command%s", strtok_r(text, "\n", &rest));
    while (rest && (line = strtok_r(NULL, "\n", &rest)) != NULL) {
        message_print(stderr, "%s", line);
        fputc('\n', stderr);
    }
    free(text);
    return false;
}

bool script_find_command(struct script_parser *p, size_t *words)
{
    size_t most = 0;
    bool whole;
    for (p->command = script_shapes; p->command;
         p->command = script_next(p->command)) {
        *words = common_words(p, p->command->name, &whole);
        if (whole)
            return true;
        most = *words > most ? *words : most;
    }
    return refuse(p, most);
}
