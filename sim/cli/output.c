#include "sim/cli/output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sim/cli/message.h"

bool output_open(struct output *output, const char *path)
{
    memset(output, 0, sizeof *output);
    output->path = path;
    output->stream = open_memstream(&output->data, &output->size);
    return output->stream || message_error_at(path, 0, "out of memory");
}

void output_abandon(struct output *output)
{
    if (output->stream)
        fclose(output->stream);
    if (output->temporary)
        unlink(output->temporary);
    free(output->temporary);
    free(output->target);
    free(output->data);
    memset(output, 0, sizeof *output);
}

static bool refuse(const struct output *output)
{
    const bool is_path = strcmp(output->path, "-") != 0;
    return message_error("%s%s cannot be written: %s",
                         is_path ? output->path : "standard output",
                         is_path ? ":" : "", strerror(errno));
}

/* Writes to an open file and closes it; -1: the file could not be opened. */
static bool write_to(const struct output *output, int file)
{
    ssize_t n = file;
    for (size_t at = 0; n >= 0 && at < output->size; at += (size_t)n) {
        n = write(file, output->data + at, output->size - at);
        if (n < 0 && errno == EINTR)
            n = 0;
    }
    if (n >= 0)
        return close(file) == 0 || refuse(output);
    refuse(output);
    if (file >= 0)
        close(file);
    return false;
}

static mode_t mode_of_new_files(void)
{
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* Signals that end the program wait until the temporary file is gone. Threads
 * of pools take none. */
static void block_signals(void)
{
    sigset_t ending;
    sigemptyset(&ending);
    sigaddset(&ending, SIGHUP);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGQUIT);
    sigaddset(&ending, SIGTERM);
    sigprocmask(SIG_BLOCK, &ending, NULL);
}

/* A file with a short name beside the target: there may be no room for a longer
 * one than the target's. */
static bool write_temporary(struct output *output, mode_t mode)
{
    const char *slash = strrchr(output->target, '/');
    const int folder = slash ? (int)(slash - output->target) + 1 : 0;
    if (asprintf(&output->temporary, "%.*s.pel-XXXXXX", folder,
                 output->target) < 0) {
        output->temporary = NULL;
        return message_error_at(output->path, 0, "out of memory");
    }
    block_signals();
    const int file = mkstemp(output->temporary);
    if (file < 0 || fchmod(file, mode) == 0)
        return write_to(output, file);
    refuse(output);
    close(file);
    return false;
}

/* Devices, pipes, and links to missing files are written to, not replaced. */
static bool write_path(struct output *output)
{
    struct stat status, link;
    const char *path = output->path;
    const bool is_there = stat(path, &status) == 0;
    if (is_there ? !S_ISREG(status.st_mode) : lstat(path, &link) == 0)
        return write_to(output, open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666));
    output->target = is_there ? realpath(path, NULL) : strdup(path);
    return output->target
               ? write_temporary(output, is_there ? status.st_mode & 07777
                                                  : mode_of_new_files())
               : refuse(output);
}

/* All but the name. */
static bool write_output(struct output *output)
{
    const bool whole = !ferror(output->stream);
    const bool ended = fclose(output->stream) == 0;
    output->stream = NULL;
    if (!whole || !ended)
        return message_error_at(output->path, 0, "out of memory");
    if (strcmp(output->path, "-") != 0)
        return write_path(output);
    return isatty(STDOUT_FILENO)
               ? message_error("standard output is a terminal: name a file "
                               "with -o, or use a pipe")
               : write_to(output, dup(STDOUT_FILENO));
}

static bool take_name(struct output *output)
{
    if (!output->temporary)
        return true;
    if (rename(output->temporary, output->target) != 0)
        return refuse(output);
    free(output->temporary);
    output->temporary = NULL;
    return true;
}

bool output_commit_both(struct output *output, struct output *second)
{
    sigset_t before;
    sigprocmask(SIG_BLOCK, NULL, &before);
    const bool done = write_output(output) &&
                      (!second || write_output(second)) && take_name(output) &&
                      (!second || take_name(second));
    output_abandon(output);
    if (second)
        output_abandon(second);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return done;
}

bool output_commit(struct output *output)
{
    return output_commit_both(output, NULL);
}
