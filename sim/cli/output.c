#include "sim/cli/output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sim/cli/message.h"

/* NAME beside the target, malloc'ed: there may be no room for a longer name
 * than the target's. */
static char *beside(const struct output *output, const char *name)
{
    char *path;
    const char *slash = strrchr(output->target, '/');
    const int folder = slash ? (int)(slash - output->target) + 1 : 0;
    return asprintf(&path, "%.*s%s", folder, output->target, name) < 0 ? NULL
                                                                       : path;
}

/* Devices, pipes, and links to missing files are written to, not replaced; all
 * others have a target. */
static bool find_target(struct output *output)
{
    struct stat status, link;
    const char *path = output->path;
    const bool is_there = stat(path, &status) == 0;
    if (strcmp(path, "-") == 0 ||
        (is_there ? !S_ISREG(status.st_mode) : lstat(path, &link) == 0))
        return true;
    output->target = is_there ? realpath(path, NULL) : strdup(path);
    return output->target;
}

/* A file without a name: beside the target, so that it can take its name, or
 * where files of that kind go; else in memory. */
static int open_nameless(struct output *output)
{
    char *folder = output->target ? beside(output, ".") : NULL;
    int file = folder ? open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600) : -1;
    output->has_place = file >= 0;
    free(folder);
    if (file < 0)
        file = open(P_tmpdir, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    return file < 0 ? memfd_create("pel", MFD_CLOEXEC) : file;
}

bool output_open(struct output *output, const char *path)
{
    memset(output, 0, sizeof *output);
    output->path = path;
    const int file = find_target(output) ? open_nameless(output) : -1;
    output->stream = file < 0 ? NULL : fdopen(file, "w+");
    if (!output->stream)
        message_error_at(path, 0, "no room for what is written: %s",
                         strerror(errno));
    return output->stream;
}

static void drop_name(struct output *output)
{
    if (output->temporary)
        unlink(output->temporary);
    free(output->temporary);
    output->temporary = NULL;
}

void output_abandon(struct output *output)
{
    if (output->stream)
        fclose(output->stream);
    drop_name(output);
    free(output->target);
    memset(output, 0, sizeof *output);
}

static bool refuse(const struct output *output)
{
    const bool is_path = strcmp(output->path, "-") != 0;
    return message_error("%s%s cannot be written: %s",
                         is_path ? output->path : "standard output",
                         is_path ? ":" : "", strerror(errno));
}

/* All that was written, to an open file; -1: it could not be opened. */
static bool copy_to(const struct output *output, int file)
{
    char chunk[1 << 16];
    off_t at = 0;
    ssize_t n = file;
    while (n >= 0) {
        n = pread(fileno(output->stream), chunk, sizeof chunk, at);
        if (n <= 0)
            break;
        n = write(file, chunk, (size_t)n);
        if (n < 0 && errno == EINTR)
            n = 0;
        at += n;
    }
    return n == 0;
}

static bool close_file(const struct output *output, int file, bool done)
{
    if (!done)
        refuse(output);
    if (file >= 0 && close(file) != 0 && done)
        return refuse(output);
    return done;
}

static mode_t mode_of_new_files(void)
{
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* Signals that end the program wait until the temporary file is gone; those of
 * faults cannot. Threads of pools take none. */
static void block_signals(sigset_t *before)
{
    static const int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL,
                                 SIGTRAP, SIGSYS, SIGABRT};
    sigset_t ending;
    sigfillset(&ending);
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        sigdelset(&ending, faults[i]);
    sigprocmask(SIG_BLOCK, &ending, before);
}

/* Gives a file the owner, the group and the mode of what was there. */
static bool pass_on(int file, const struct stat *old)
{
    struct stat new;
    return fstat(file, &new) == 0 &&
           ((new.st_uid == old->st_uid &&new.st_gid == old->st_gid) ||
            fchown(file, old->st_uid, old->st_gid) == 0) &&
           fchmod(file, old->st_mode & 0777) == 0;
}

/* Puts the file beside its target, under a temporary name: as it is, or a copy
 * where the file system has no files without a name. The open file, or -1. */
static int name_file(struct output *output)
{
    char from[40];
    const int file = fileno(output->stream);
    output->temporary = beside(output, ".pel-XXXXXX");
    const int new =
        output->temporary ? mkostemp(output->temporary, O_CLOEXEC) : -1;
    snprintf(from, sizeof from, "/proc/self/fd/%d", file);
    if (new < 0 || !output->has_place)
        return new;
    unlink(output->temporary);
    close(new);
    return linkat(AT_FDCWD, from, AT_FDCWD, output->temporary,
                  AT_SYMLINK_FOLLOW) == 0
               ? dup(file)
               : -1;
}

/* All but the name; or nothing yet, where it is to be written in place. */
static bool write_beside(struct output *output)
{
    struct stat old;
    const bool is_there = stat(output->target, &old) == 0;
    const int file = name_file(output);
    const bool written =
        file >= 0 && (output->has_place || copy_to(output, file));
    const bool done =
        written && (is_there ? pass_on(file, &old)
                             : fchmod(file, mode_of_new_files()) == 0);
    if (!done && is_there && (file < 0 || written) &&
        access(output->target, W_OK) == 0) {
        output->in_place = file < 0 ? "its folder takes no new file"
                                    : "its owner cannot be passed on";
        drop_name(output);
        close(file);
        return true;
    }
    return close_file(output, file, done);
}

static bool write_output(struct output *output)
{
    /* errno is that of the writing that failed */
    if (ferror(output->stream) || fflush(output->stream) != 0)
        return refuse(output);
    if (output->target)
        return write_beside(output);
    const bool is_path = strcmp(output->path, "-") != 0;
    if (!is_path && isatty(STDOUT_FILENO))
        return message_error("standard output is a terminal: name a file "
                             "with -o, or use a pipe");
    const int file =
        is_path ? open(output->path, O_WRONLY | O_CREAT | O_TRUNC, 0666)
                : dup(STDOUT_FILENO);
    return close_file(output, file, copy_to(output, file));
}

static bool write_in_place(struct output *output)
{
    struct stat old;
    const int file = open(output->target, O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (file >= 0)
        message_error_at(output->path, 0, "is written in place: %s",
                         output->in_place);
    const bool done =
        copy_to(output, file) && fstat(file, &old) == 0 &&
        (!(old.st_mode & 07000) || fchmod(file, old.st_mode & 0777) == 0);
    return close_file(output, file, done);
}

static bool take_name(struct output *output)
{
    if (output->in_place)
        return write_in_place(output);
    if (output->temporary && rename(output->temporary, output->target) != 0)
        return refuse(output);
    free(output->temporary);
    output->temporary = NULL;
    return true;
}

bool output_commit_both(struct output *output, struct output *second)
{
    sigset_t before;
    block_signals(&before);
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
