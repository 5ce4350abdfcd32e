#include "sim/cli/child.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"

struct child_limits child_limits = {60, 2048};

struct child {
    const char *path;
    FILE *result, *messages; /* both in memory that parent and child share */
    int pipe[2];             /* what libraries print; its end is the child's */
    pid_t id;
    bool late;
    char line[160]; /* the last one that was printed */
    size_t length;
};

static FILE *shared_memory(void)
{
    const int file = memfd_create("pel", MFD_CLOEXEC);
    return file < 0 ? NULL : fdopen(file, "w+");
}

/* Bytes of address space that this process has. */
static rlim_t own_memory(void)
{
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file)
        return 0;
    if (fscanf(file, "%lu", &pages) != 1)
        pages = 0;
    fclose(file);
    return pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

static void set_limit(int resource, rlim_t most)
{
    const struct rlimit limit = {most, most};
    setrlimit((__rlimit_resource_t)resource, &limit);
}

/* The time on the wall is the parent's to watch. */
__attribute__((noreturn)) static void do_work(struct child *c, child_work *work,
                                              const void *what)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_CPU, (rlim_t)child_limits.seconds + 1);
    set_limit(RLIMIT_AS, own_memory() + ((rlim_t)child_limits.megabytes << 20));
    dup2(c->pipe[1], STDOUT_FILENO);
    dup2(c->pipe[1], STDERR_FILENO);
    stderr = c->messages;
    const bool done = work(what, c->result);
    const bool written =
        fflush(c->result) == 0 && !ferror(c->result) && fflush(stderr) == 0;
    _exit(done && written ? EXIT_SUCCESS : EXIT_FAILURE);
}

/* Keeps the last line that is not empty; of a long one the beginning, with room
 * for its end. */
static void take_text(struct child *c, const char *text, size_t size)
{
    for (; size > 0; text++, size--) {
        const bool ended = c->length > 0 && c->line[c->length - 1] == '\n';
        const bool ends = *text == '\n';
        if (ended && !ends)
            c->length = 0;
        if (ends ? c->length > 0 && !ended : c->length < sizeof(c->line) - 2)
            c->line[c->length++] = *text;
    }
}

/* Tells whoever watches that the work goes on, from the first second on. */
static void show_progress(const struct child *c, int seconds, const char *end)
{
    if (seconds == 0 || !isatty(STDERR_FILENO))
        return;
    fputc('\r', stderr);
    message_print(stderr, "pel: %s: %d s", c->path, seconds);
    fputs(end, stderr);
}

/* Reads until the child has ended, which closes the pipe, or its time is over.
 */
static void listen_to(struct child *c)
{
    const double start = milliseconds();
    int seconds = 0;
    struct pollfd wanted = {c->pipe[0], POLLIN, 0};
    char text[4096];
    ssize_t size = 1;
    while (size != 0 && !c->late) {
        const double left = start + 1000.0 * (seconds + 1) - milliseconds();
        const int ready = left > 0 ? poll(&wanted, 1, (int)left + 1) : 0;
        if (ready == 0)
            show_progress(c, ++seconds, "");
        c->late = seconds >= child_limits.seconds;
        size = ready > 0 ? read(c->pipe[0], text, sizeof(text)) : -1;
        if (size > 0)
            take_text(c, text, (size_t)size);
    }
    show_progress(c, seconds, "\n");
    if (c->late)
        kill(c->id, SIGKILL);
    c->line[c->length] = '\0';
    c->line[strcspn(c->line, "\n")] = '\0';
}

static int status_of(const struct child *c)
{
    int status = 0;
    while (waitpid(c->id, &status, 0) < 0 && errno == EINTR)
        continue;
    return status;
}

/* Libraries say so, each in words of its own. Files may be named memory: the
 * blank keeps out those in a folder, and messages begin with the path. */
static bool lacks_memory(const char *text, const char *path)
{
    const char *const name = strstr(text, path);
    if (name)
        text = name + strlen(path);
    return strstr(text, "bad_alloc") || strstr(text, "bad allocation") ||
           strstr(text, " memory");
}

/* The lines that came, from what a library may have made of the child. */
static void show(char *text)
{
    char *rest = NULL;
    for (const char *line = strtok_r(text, "\n", &rest); line;
         line = strtok_r(NULL, "\n", &rest)) {
        message_print(stderr, "%s", line);
        fputc('\n', stderr);
    }
}

/* Shows the child's own messages, or says how it ended. Was it well? */
static bool report(struct child *c, int status)
{
    char text[8192];
    const bool failed = status != 0;
    const bool crashed = WIFSIGNALED(status);
    rewind(c->messages);
    const size_t size = fread(text, 1, sizeof(text) - 1, c->messages);
    text[size] = '\0';
    if (c->late)
        return message_error_at(c->path, 0, CHILD_LIMIT_TEXT("s"),
                                child_limits.seconds);
    if (failed && lacks_memory(crashed ? c->line : text, c->path))
        return message_error_at(c->path, 0, CHILD_LIMIT_TEXT("MB"),
                                child_limits.megabytes);
    show(text);
    if (!crashed && (!failed || size > 0))
        return !failed;
    return message_error_at(
        c->path, 0, "the library that reads it crashed: %s%s%s",
        crashed ? strsignal(WTERMSIG(status)) : "ended without a word",
        *c->line ? ": " : "", c->line);
}

FILE *child_run(const char *path, child_work *work, const void *what)
{
    struct child c = {.path = path,
                      .result = shared_memory(),
                      .messages = shared_memory(),
                      .id = -1};
    bool done = false;
    fflush(stdout); /* or the child would have it too */
    if (c.result && c.messages && pipe2(c.pipe, O_CLOEXEC) == 0) {
        c.id = fork();
        if (c.id == 0)
            do_work(&c, work, what);
        close(c.pipe[1]);
        if (c.id > 0)
            listen_to(&c);
        close(c.pipe[0]);
    }
    if (c.id > 0)
        done = report(&c, status_of(&c));
    else
        message_error_at(path, 0, "no process to read it: %s", strerror(errno));
    if (c.messages)
        fclose(c.messages);
    if (done)
        rewind(c.result);
    else if (c.result)
        fclose(c.result);
    return done ? c.result : NULL;
}
