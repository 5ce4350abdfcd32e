/* Methods: ways to draw a workload. Pel is one for each compiler; the peers are
 * libraries that do the same job. */
#ifndef BENCH_METHOD_H
#define BENCH_METHOD_H

#include "canvas.h"
#include "workload.h"

struct method {
    const char *name;  /* "pel", "memset" or the peer's */
    const char *build; /* "gcc -O2"; "packaged" for what was not built here */

    /* Gets ready to draw the workload into the canvas: shapes in the method's
     * own types, so that conversion is not timed. Workload and canvas outlive
     * the job. NULL when the method has nothing that draws this workload;
     * exits when it has, and fails. */
    void *(*open)(const struct workload *w, const struct canvas *c);

    /* Draws shapes [first, first + n), complete on return. */
    void (*draw)(void *job, int first, int n);

    void (*close)(void *job);
};

/* Those of this build, the first one Pel: the reference of coverage; ends with
 * NULL. */
extern const struct method *const methods[];

/* One line for each peer that is not there, and the package that brings it. */
extern const char methods_absent[];

bool method_is_pel(const struct method *m);
bool method_is_limit(const struct method *m); /* "memset" */
bool method_is_peer(const struct method *m);

/* Draws into memory of its own and copies all of it to the canvas after each
 * call: its pixels cannot be compared shape by shape. */
bool method_is_apart(const struct method *m); /* "osmesa" */

/* Zeroed memory; exits when there is none. */
void *method_allocate(int n, size_t size);

/* Ends the program: what failed, and what would be right. */
void method_fail(const char *what, const char *right);

#endif
