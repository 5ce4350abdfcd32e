/* Reading one line of a script after the other. Only for scene*.c. */
#ifndef SIM_SCENE_PARSER_H
#define SIM_SCENE_PARSER_H

#include "scene_meshes.h"

struct scene_parser {
    struct scene *scene;
    long line;
    size_t item_capacity, value_capacity;
    char **words; /* of the line, in its own memory */
    size_t word_count, word_capacity;
    bool by_vertex; /* paint vertex is in force */
    bool has_font;
    struct scene_stage stage; /* in force */
};

/* Adds what the line says to the scene. Cuts `text` into words. False, with a
 * message, when it is not right. */
bool scene_parse_line(struct scene_parser *parser, char *text);

/* Says that no command has the name of this line, and which one may have been
 * meant, or which ones there are. False. */
bool scene_refuse_unknown(const struct scene_parser *parser);

#endif
