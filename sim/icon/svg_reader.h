/* Reading SVG: elements that are open, and their properties. Only for svg*.c.
 */
#ifndef SIM_ICON_SVG_READER_H
#define SIM_ICON_SVG_READER_H

#include <expat.h>

#include "sim/icon/svg.h"

struct element {
    struct svg_style style;
    struct svg_matrix matrix;
    double own_opacity;
    size_t first;         /* shape in it */
    bool is_css, in_defs; /* in_defs: nothing is drawn */
};

struct reader {
    struct svg *svg;
    XML_Parser parser;
    struct element *open; /* elements */
    size_t depth;
    unsigned skipped; /* elements inside one that is not drawn, and itself */
    bool bad;
};

/* Ends the reading with a message of the line, the first one alone. False. */
__attribute__((format(printf, 2, 3))) bool svg_refuse(struct reader *r,
                                                      const char *format, ...);

/* A part of a text, malloc'ed; NULL, and the reading ends. */
char *svg_copy(struct reader *r, const char *text, size_t n);

/* Values of properties and attributes; false, and the reading ends, when they
 * are none. */
bool svg_set_paint(struct reader *r, const char *text, struct svg_paint *to);
bool svg_set_part(struct reader *r, const char *name, const char *text,
                  double *to); /* 0 to 1 */
bool svg_set_word(struct reader *r, const char *name, const char *text,
                  const char *words, int *to); /* the index in "one two" */

/* The value of an attribute, or NULL. */
const char *svg_attribute(const char **list, const char *name);

/* A length in px, of what percents are of; 0 where there is none. */
double svg_length_of(struct reader *r, const char **list, const char *name,
                     double whole);

/* False: the name is that of no shape. */
bool svg_add_shape(struct reader *r, const char *name, const struct element *e,
                   const char **list);

/* Calls `set` with each attribute, and then with what `style` says, which goes
 * before them. */
typedef bool svg_setter(struct reader *r, void *to, const char *name,
                        const char *value);
bool svg_each_property(struct reader *r, const char **list, void *to,
                       svg_setter *set);

/* The setter of a struct element. */
svg_setter svg_set_property;

#endif
