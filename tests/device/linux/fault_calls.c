#include "fault_calls.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <sys/types.h>
#include <unistd.h>

const char *const fault_names[FAULT_CALLS] = {
    "open",          "ioctl",         "mmap",          "read",     "write",
    "poll",          "fork",          "socketpair",    "signalfd", "calloc",
    "epoll_create1", "inotify_init1", "timerfd_create"};

static enum fault_call chosen = FAULT_CALLS;
static int left, error_to_give, happened;
static pid_t process;

void fault_set(enum fault_call call, int n, int error)
{
    chosen = call;
    left = n;
    error_to_give = error;
    happened = 0;
    process = getpid();
}

int fault_happened(void)
{
    return happened;
}

static int fails(enum fault_call call)
{
    if (call != chosen || getpid() != process || --left != 0)
        return 0;
    happened = 1;
    errno = error_to_give;
    return 1;
}

/* A call, which fails with this result. */
#define CALL(which, type, name, parameters, arguments, failed)    \
    type __real_##name parameters;                                \
    type __wrap_##name parameters                                 \
    {                                                             \
        return fails(which) ? (failed) : __real_##name arguments; \
    }

CALL(FAULT_MMAP, void *, mmap,
     (void *at, size_t size, int protection, int flags, int fd, off_t offset),
     (at, size, protection, flags, fd, offset), (void *)-1)
CALL(FAULT_READ, ssize_t, read, (int fd, void *buffer, size_t size),
     (fd, buffer, size), -1)
CALL(FAULT_WRITE, ssize_t, write, (int fd, const void *buffer, size_t size),
     (fd, buffer, size), -1)
CALL(FAULT_POLL, int, poll, (struct pollfd * lines, nfds_t n, int timeout),
     (lines, n, timeout), -1)
CALL(FAULT_FORK, pid_t, fork, (void), (), -1)
CALL(FAULT_SOCKETPAIR, int, socketpair,
     (int domain, int type, int protocol, int pair[2]),
     (domain, type, protocol, pair), -1)
CALL(FAULT_SIGNALFD, int, signalfd, (int fd, const sigset_t *set, int flags),
     (fd, set, flags), -1)
CALL(FAULT_CALLOC, void *, calloc, (size_t n, size_t size), (n, size), NULL)
CALL(FAULT_EPOLL, int, epoll_create1, (int flags), (flags), -1)
CALL(FAULT_INOTIFY, int, inotify_init1, (int flags), (flags), -1)
CALL(FAULT_TIMER, int, timerfd_create, (int clock, int flags), (clock, flags),
     -1)

int __real_open(const char *path, int flags, ...);
int __real_ioctl(int fd, unsigned long request, ...);

int __wrap_open(const char *path, int flags, ...)
{
    return fails(FAULT_OPEN) ? -1 : __real_open(path, flags, 0);
}

int __wrap_ioctl(int fd, unsigned long request, ...)
{
    va_list arguments;
    va_start(arguments, request);
    void *argument = va_arg(arguments, void *);
    va_end(arguments);
    return fails(FAULT_IOCTL) ? -1 : __real_ioctl(fd, request, argument);
}
