#include "sim/cli/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sim/cli/message.h"

bool output_open(struct output *output, const char *path)
{
    output->path = path;
    output->data = NULL;
    output->size = 0;
    output->stream = open_memstream(&output->data, &output->size);
    if (!output->stream)
        return message_error_at(path, 0, "out of memory");
    return true;
}

void output_abandon(struct output *output)
{
    if (output->stream)
        fclose(output->stream);
    output->stream = NULL;
    free(output->data);
    output->data = NULL;
}

static bool write_all(const struct output *output, FILE *file)
{
    return fwrite(output->data, 1, output->size, file) == output->size &&
           fflush(file) == 0;
}

static bool report(const char *path)
{
    return message_error_at(path, 0, "cannot be written: %s", strerror(errno));
}

static bool write_stdout(const struct output *output)
{
    if (isatty(STDOUT_FILENO))
        return message_error("standard output is a terminal: name a file "
                             "with -o, or use a pipe");
    if (!write_all(output, stdout))
        return message_error("standard output cannot be written: %s",
                             strerror(errno));
    return true;
}

/* What is there and is no file (a device, a pipe) is written to, not replaced.
 */
static bool write_in_place(const struct output *output)
{
    FILE *file = fopen(output->path, "wb");
    if (!file)
        return report(output->path);
    const bool done = write_all(output, file);
    if (fclose(file) != 0 || !done)
        return report(output->path);
    return true;
}

static mode_t mode_of_new_files(void)
{
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* Writes to `temporary`, a template of mkstemp, and moves that to `target`. */
static bool write_and_rename(const struct output *output, char *temporary,
                             const char *target, mode_t mode)
{
    const int descriptor = mkstemp(temporary);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
    if (!file)
        return report(output->path);
    const bool written =
        write_all(output, file) && fchmod(descriptor, mode) == 0;
    if (fclose(file) == 0 && written && rename(temporary, target) == 0)
        return true;
    report(output->path);
    unlink(temporary);
    return false;
}

static bool write_file(const struct output *output, const char *target,
                       mode_t mode)
{
    char *temporary;
    if (asprintf(&temporary, "%s.XXXXXX", target) < 0)
        return message_error_at(target, 0, "out of memory");
    const bool done = write_and_rename(output, temporary, target, mode);
    free(temporary);
    return done;
}

static bool write_path(const struct output *output)
{
    struct stat status;
    if (stat(output->path, &status) != 0)
        return write_file(output, output->path, mode_of_new_files());
    if (!S_ISREG(status.st_mode))
        return write_in_place(output);
    char *target = realpath(output->path, NULL);
    if (!target)
        return report(output->path);
    const bool done = write_file(output, target, status.st_mode & 07777);
    free(target);
    return done;
}

bool output_commit(struct output *output)
{
    const bool whole = !ferror(output->stream);
    const bool ended = fclose(output->stream) == 0;
    output->stream = NULL;
    bool done = false;
    if (!whole || !ended)
        message_error_at(output->path, 0, "out of memory");
    else if (strcmp(output->path, "-") == 0)
        done = write_stdout(output);
    else
        done = write_path(output);
    output_abandon(output);
    return done;
}
