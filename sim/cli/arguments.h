/* Command lines: options in tables, whose rows say how a text is read and where
 * its value goes. */
#ifndef SIM_CLI_ARGUMENTS_H
#define SIM_CLI_ARGUMENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "core/base/format.h"

enum option_kind {
    OPTION_HEADING, /* `help` stands above the options that follow */
    OPTION_FLAG,    /* bool: true */
    OPTION_TEXT,    /* const char *: the argument itself */
    OPTION_INTEGER, /* int, low..high, or int[n] like OPTION_NUMBERS */
    OPTION_NUMBERS, /* double[n], each low..high, `separator` between them */
    OPTION_CHOICE,  /* enum, or bool with `n` = 1: an index among `expected` */
    OPTION_COLOR,   /* pel_color: #rrggbb, opaque */
    OPTION_FORMAT,  /* const struct pel_format * */
    OPTION_CALL     /* `parse` does it: false, with a message */
};

struct option_row {
    const char *name;     /* without dashes */
    const char *argument; /* of the option, in capitals; NULL: none */
    const char *help;
    enum option_kind kind;
    size_t offset;        /* of the value in the table's input */
    size_t flag;          /* of a bool that becomes true; 0: none */
    const char *expected; /* an example; the names of a choice, A|B|C */
    int n;
    char separator;
    char letter; /* a short name, or 0 */
    double low, high;
    bool (*parse)(const char *option, const char *text, void *input);
};

enum { OPTIONS_MAX = 80 }; /* of one command, --help included */

/* The names, without dashes, of the options that were given, each once. */
struct options_given {
    const char *names[OPTIONS_MAX];
    int count;
};
bool options_has(const struct options_given *given, const char *name);

struct option_table {
    const struct option_row *options; /* ends with the help NULL */
    void *input;
    struct options_given *given; /* notes their names; or NULL */
};

struct command_line {
    const char *arguments; /* after the options, for people */
    int least, most;       /* how many of them */
    const char *about;     /* before the options and, after \v, behind them */
    struct option_table tables[9]; /* ends with the options NULL */
};

/* Reads a command line; argv[0] is "pel NAME". Returns the arguments that are
 * no options, ended by NULL. Wrong ones end the program with STATUS_ERROR. */
char **arguments_parse(const struct command_line *line, int argc, char **argv);

/* The numbers of an OPTION_NUMBERS, and nothing else. No message. */
bool option_numbers(const char *text, const struct option_row *numbers,
                    double *value);

/* The index of a name in A|B|C, or -1. */
int choice_find(const char *names, const char *name);

/* pel: --OPTION is 'TEXT': expected EXPECTED. False. */
bool option_refuse(const char *option, const char *text, const char *expected);

#endif
