/* The libraries that pel was built with. */
#ifndef SIM_CLI_LIBRARIES_H
#define SIM_CLI_LIBRARIES_H

#include <stdbool.h>

struct library {
    const char *name;
    const char *package; /* of Debian, that brings it */
    const char *adds;    /* what it is for */
    bool present;        /* in this build */
};

/* All of them; the last has the name NULL. */
extern const struct library libraries[];

#endif
