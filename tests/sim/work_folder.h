/* A folder for the files of a test program, and what goes to standard error. */
#ifndef TESTS_SIM_WORK_FOLDER_H
#define TESTS_SIM_WORK_FOLDER_H

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static char directory[] = "/tmp/pel-test-XXXXXX";

static void path_of(const char *name, char *path, size_t size)
{
    snprintf(path, size, "%s/%s", directory, name);
}

static int set_up(void **state)
{
    (void)state;
    return mkdtemp(directory) ? 0 : -1;
}

/* Fails when other files than those named, up to NULL, were left. */
static int remove_folder(const char *const *names)
{
    for (; *names; names++) {
        char path[64];
        path_of(*names, path, sizeof path);
        unlink(path);
    }
    return rmdir(directory);
}

/* Standard error goes to text[size] until catch_end. */
static FILE *kept_errors;

static void catch_errors(char *text, size_t size)
{
    kept_errors = stderr;
    stderr = fmemopen(text, size, "w");
}

static void catch_end(void)
{
    fclose(stderr);
    stderr = kept_errors;
}

#endif
