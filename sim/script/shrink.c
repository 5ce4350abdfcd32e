/* Delta debugging (Zeller and Hildebrandt, 2002): parts of the lines are left
 * out, halves first, then quarters, down to single lines, until no line can be
 * left out any more. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/cli/message.h"
#include "sim/cli/output.h"
#include "sim/cli/text_line.h"
#include "sim/script/script.h"

struct shrinking {
    char *command;   /* its output is not shown */
    char *candidate; /* the path that the command is given */
    int status;      /* of the whole */
    int runs;
};

/* All lines but those from `from` up to, not including, `to`. */
static void put_lines(const struct text_lines *lines, size_t from, size_t to,
                      FILE *stream)
{
    for (size_t i = 0; i < lines->count; i++)
        if (i < from || i >= to)
            fprintf(stream, "%s\n", lines->text[i]);
}

static bool write_candidate(const struct shrinking *s,
                            const struct text_lines *lines, size_t from,
                            size_t to)
{
    FILE *file = fopen(s->candidate, "we");
    if (file)
        put_lines(lines, from, to, file);
    const bool written = file && !ferror(file);
    return ((!file || fclose(file) == 0) && written) ||
           message_error_at(s->candidate, 0, "cannot be written: %s",
                            strerror(errno));
}

static bool write_result(const struct text_lines *lines, const char *path)
{
    struct output output;
    if (!output_open(&output, path))
        return false;
    put_lines(lines, 0, 0, output.stream);
    return output_commit(&output);
}

/* For the handler of signals. */
static struct {
    pid_t guard; /* removes the candidate when this end of a pipe is closed: */
    int guard_pipe;
    volatile pid_t child;         /* the command, while it runs */
    volatile sig_atomic_t number; /* of the signal that came; 0: none */
} running;

/* A process of its own sees every end of this one, SIGKILL too. */
static bool guard(const char *candidate)
{
    char none;
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0 || (running.guard = fork()) < 0)
        return message_error("no guard of %s: %s", candidate, strerror(errno));
    if (running.guard == 0) {
        setsid();
        close(ends[1]);
        while (read(ends[0], &none, 1) < 0 && errno == EINTR)
            continue;
        unlink(candidate);
        _exit(0);
    }
    close(ends[0]);
    running.guard_pipe = ends[1];
    return true;
}

static void end_guard(void)
{
    close(running.guard_pipe);
    while (waitpid(running.guard, NULL, 0) < 0 && errno == EINTR)
        continue;
}

static const int ending[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGTERM, SIGPIPE,
                             SIGALRM, SIGXCPU, SIGUSR1, SIGUSR2};
enum { ENDING = sizeof ending / sizeof *ending };

/* The first signal ends the command, so that what was reached is written; the
 * second one the program. */
static void on_signal(int number)
{
    if (running.number == 0) {
        running.number = number;
        if (running.child > 0)
            kill(running.child, SIGTERM);
        return;
    }
    end_guard();
    signal(number, SIG_DFL);
    raise(number);
}

/* Those that end the program, unless the caller ignores them. */
static void catch_signals(void)
{
    for (int i = 0; i < ENDING; i++)
        if (signal(ending[i], on_signal) == SIG_IGN)
            signal(ending[i], SIG_IGN);
}

/* Like system(), but for the signals. After one of them nothing is run. */
static int run(const char *command)
{
    int status = -1;
    sigset_t blocked, before;
    sigemptyset(&blocked);
    for (int i = 0; i < ENDING; i++)
        sigaddset(&blocked, ending[i]);
    sigprocmask(SIG_BLOCK, &blocked, &before);
    running.child = running.number ? -1 : fork();
    sigprocmask(SIG_SETMASK, &before, NULL);
    if (running.child == 0) {
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    while (running.child > 0 && waitpid(running.child, &status, 0) < 0 &&
           errno == EINTR)
        continue;
    running.child = 0;
    return status;
}

/* The status of the command for these lines; -1, with a message, when it did
 * not run or was interrupted. */
static int status_of(struct shrinking *s, const struct text_lines *lines,
                     size_t from, size_t to)
{
    if (!write_candidate(s, lines, from, to))
        return -1;
    fflush(stdout);
    s->runs++;
    const int status = run(s->command);
    if (status >= 0 && !WIFSIGNALED(status) && !running.number)
        return status;
    message_error("--command did not end: %s",
                  running.number ? strsignal(running.number)
                  : status < 0   ? strerror(errno)
                                 : strsignal(WTERMSIG(status)));
    return -1;
}

static void leave_out(struct text_lines *lines, size_t from, size_t to)
{
    for (size_t i = from; i < to; i++)
        free(lines->text[i]);
    memmove(lines->text + from, lines->text + to,
            (lines->count - to) * sizeof(*lines->text));
    lines->count -= to - from;
}

/* Goes once through all parts of `size` lines. *less: some could go. */
static bool try_parts(struct shrinking *s, struct text_lines *lines,
                      size_t size, bool *less)
{
    *less = false;
    for (size_t end = lines->count; end > 0;) {
        const size_t from = end > size ? end - size : 0;
        const int status = status_of(s, lines, from, end);
        if (status < 0)
            return false;
        if (status == s->status) {
            leave_out(lines, from, end);
            *less = true;
        }
        end = from;
    }
    return true;
}

static bool shrink(struct shrinking *s, struct text_lines *lines,
                   const char *path)
{
    bool less = false;
    s->status = status_of(s, lines, 0, 0);
    if (s->status <= 0)
        return s->status == 0 &&
               message_error_at(path, 0,
                                "the command does not fail: expected one that "
                                "ends with a status other than 0 for this "
                                "script, as $1");
    for (size_t size = (lines->count + 1) / 2; size > 0;) {
        if (!try_parts(s, lines, size, &less))
            return false;
        const size_t half = (lines->count + 1) / 2;
        size = !less ? size / 2 : size < half ? size : half;
    }
    return true;
}

bool script_shrink(const char *path, const char *command, const char *output)
{
    struct shrinking s = {.runs = 0};
    struct text_lines lines = {NULL, 0};
    const char *slash = strrchr(path, '/');
    if (asprintf(&s.candidate, "%.*s.pel-shrink-%ld.pel",
                 slash ? (int)(slash - path) + 1 : 0, path,
                 (long)getpid()) < 0 ||
        setenv("PEL_CANDIDATE", s.candidate, 1) != 0 ||
        asprintf(&s.command,
                 "set -- \"$PEL_CANDIDATE\"; exec >/dev/null 2>&1\n%s",
                 command) < 0)
        return message_error("out of memory");
    if (!guard(s.candidate))
        return false;
    catch_signals();
    bool done = text_lines_read(&lines, path);
    const size_t before = lines.count;
    done = done && shrink(&s, &lines, path);
    /* What an interrupted run has reached is worth keeping. */
    if (done || lines.count < before)
        done = write_result(&lines, output) && done;
    if (lines.count < before || done)
        message_error_at(path, 0, "%zu of %zu lines are left, after %d runs",
                         lines.count, before, s.runs);
    end_guard();
    free(s.candidate);
    free(s.command);
    text_lines_free(&lines);
    return done;
}
