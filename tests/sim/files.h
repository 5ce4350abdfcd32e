/* Files of a test program, and what it says on standard error. */
#ifndef TESTS_SIM_FILES_H
#define TESTS_SIM_FILES_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tests/support/check.h"

/* What goes to standard error between begin and end. */
struct messages {
    FILE *kept;
    char text[1024];
};

static inline void messages_begin(struct messages *m)
{
    m->text[0] = '\0';
    m->kept = stderr;
    stderr = fmemopen(m->text, sizeof(m->text), "w");
}

static inline const char *messages_end(struct messages *m)
{
    fclose(stderr);
    stderr = m->kept;
    return m->text;
}

/* Names a new file with that text; the caller removes it and frees the name. */
static inline char *file_with(const char *text, size_t size)
{
    const char *folder = getenv("TMPDIR");
    char *path = malloc(4096);
    assert_non_null(path);
    snprintf(path, 4096, "%s/pel-test-XXXXXX", folder ? folder : "/tmp");
    int file = mkstemp(path);
    assert_true(file >= 0);
    assert_int_equal(write(file, text, size), (ssize_t)size);
    close(file);
    return path;
}

/* A folder for files with names: made by mkdtemp before the first test. */
static char directory[] = "/tmp/pel-test-XXXXXX";

static inline void path_of(const char *name, char *path, size_t size)
{
    snprintf(path, size, "%s/%s", directory, name);
}

/* Fails when other files than those named, up to NULL, were left. */
static inline int remove_folder(const char *const *names)
{
    for (; *names; names++) {
        char path[64];
        path_of(*names, path, sizeof path);
        unlink(path);
    }
    return rmdir(directory);
}

#endif
