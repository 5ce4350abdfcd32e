/* Values of options, from their text. All are false, with a message that says
 * what would be right, when it is none. `option` is its name, with dashes. */
#ifndef SIM_CLI_OPTION_TEXT_H
#define SIM_CLI_OPTION_TEXT_H

#include <argp.h>
#include <stdbool.h>

#include "core/base/format.h"

/* The range of numbers, and an example of what would be right. */
struct option_numbers {
    int n;          /* how many, with `separator` between them */
    char separator; /* or 0 when n is 1 */
    double low, high;
    const char *right;
};

/* n finite decimal numbers and nothing else. */
bool option_numbers(const char *option, const char *text,
                    const struct option_numbers *numbers, double *value);

/* The same without a message. */
bool option_numbers_read(const char *text, const struct option_numbers *numbers,
                         double *value);

/* The index of `text` in a list of names that ends with NULL; an error names
 * them all. */
bool option_choice(const char *option, const char *text,
                   const char *const *names, int *choice);

/* A whole number from min to max. */
bool option_integer(const char *option, const char *text, int min, int max,
                    int *value);

/* A pixel format by its name. */
bool option_format(const char *text, const struct pel_format **format);

/* #rrggbb or rrggbb, opaque. */
bool option_color(const char *option, const char *text, unsigned *color);

/* The names, without dashes, of the options that were given, each once. */
struct options_given {
    const char *names[64];
    int count;
};

/* Is there one with that name? */
bool options_has(const struct options_given *given, const char *name);

/* Adds the option with this key, which is one of the array's. */
void options_note(struct options_given *given,
                  const struct argp_option *options, int key);

#endif
