/* The page that shows the gallery. */
#ifndef SIM_DEMO_INDEX_H
#define SIM_DEMO_INDEX_H

#include "sim/demo/demo.h"
#include "sim/cli/output.h"

struct demo_index {
    const char *directory;
    char *path;
    struct output output;
};

bool demo_index_open(struct demo_index *index, const char *directory);

/* A picture that lies beside the page under the demo's name. */
void demo_index_add(struct demo_index *index, const struct demo *demo,
                    const struct demo_result *result);

/* Tells which libraries are missing, here and on standard output, and writes
 * the page. */
bool demo_index_commit(struct demo_index *index);

void demo_index_abandon(struct demo_index *index);

/* Plain text as HTML, cut when it does not fit `size` bytes. */
void demo_index_escape(const char *text, char *html, size_t size);

#endif
