/* Reading one line of a script after the other. Only for sim/script. */
#ifndef SIM_SCRIPT_PARSER_H
#define SIM_SCRIPT_PARSER_H

#include "sim/script/assets.h"

struct script_parser {
    struct script *script;
    long line;
    char **words; /* of the line, in its own memory */
    size_t word_count;
    bool by_vertex; /* paint vertex is in force */
    bool has_font;
    struct script_scene scene; /* in force */
};

/* Adds what the line says to the script. Cuts `text` into words. False, with a
 * message, when it is not right. */
bool script_parse_line(struct script_parser *parser, char *text);

/* Words of a command's name, and how many of them the line begins with. */
size_t script_name_words(const char *name);
size_t script_common_words(const struct script_parser *parser,
                           const char *name);

/* Says that no command has the name of this line, and which ones there are.
 * False. */
bool script_refuse_unknown(const struct script_parser *parser);

#endif
