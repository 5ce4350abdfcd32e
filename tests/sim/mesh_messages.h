/* Catches what goes to standard error, and files with a given text. */
#ifndef TESTS_SIM_MESH_MESSAGES_H
#define TESTS_SIM_MESH_MESSAGES_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct messages {
    int saved;  /* standard error as it was */
    FILE *file; /* where it goes meanwhile */
    char text[1024];
};

static inline void messages_begin(struct messages *m)
{
    fflush(stderr);
    m->saved = dup(STDERR_FILENO);
    m->file = tmpfile();
    assert_non_null(m->file);
    dup2(fileno(m->file), STDERR_FILENO);
}

static inline const char *messages_end(struct messages *m)
{
    fflush(stderr);
    dup2(m->saved, STDERR_FILENO);
    close(m->saved);
    rewind(m->file);
    m->text[fread(m->text, 1, sizeof(m->text) - 1, m->file)] = '\0';
    fclose(m->file);
    return m->text;
}

/* Names a new file with that text; the caller removes it and frees the name. */
static inline char *file_with(const char *text, size_t size)
{
    const char *directory = getenv("TMPDIR");
    char *path = malloc(4096);
    assert_non_null(path);
    snprintf(path, 4096, "%s/pel-test-XXXXXX", directory ? directory : "/tmp");
    int file = mkstemp(path);
    assert_true(file >= 0);
    assert_int_equal(write(file, text, size), (ssize_t)size);
    close(file);
    return path;
}

#endif
