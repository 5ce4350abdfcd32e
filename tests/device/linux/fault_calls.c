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

int __real_open(const char *path, int flags, ...);
int __wrap_open(const char *path, int flags, ...);
int __real_ioctl(int fd, unsigned long request, ...);
int __wrap_ioctl(int fd, unsigned long request, ...);
void *__real_mmap(void *at, size_t size, int protection, int flags, int fd,
                  off_t offset);
void *__wrap_mmap(void *at, size_t size, int protection, int flags, int fd,
                  off_t offset);
ssize_t __real_read(int fd, void *buffer, size_t size);
ssize_t __wrap_read(int fd, void *buffer, size_t size);
ssize_t __real_write(int fd, const void *buffer, size_t size);
ssize_t __wrap_write(int fd, const void *buffer, size_t size);
int __real_poll(struct pollfd *lines, nfds_t n, int timeout);
int __wrap_poll(struct pollfd *lines, nfds_t n, int timeout);
pid_t __real_fork(void);
pid_t __wrap_fork(void);
int __real_socketpair(int domain, int type, int protocol, int pair[2]);
int __wrap_socketpair(int domain, int type, int protocol, int pair[2]);
int __real_signalfd(int fd, const sigset_t *set, int flags);
int __wrap_signalfd(int fd, const sigset_t *set, int flags);
void *__real_calloc(size_t n, size_t size);
void *__wrap_calloc(size_t n, size_t size);
int __real_epoll_create1(int flags);
int __wrap_epoll_create1(int flags);
int __real_inotify_init1(int flags);
int __wrap_inotify_init1(int flags);
int __real_timerfd_create(int clock, int flags);
int __wrap_timerfd_create(int clock, int flags);

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

void *__wrap_mmap(void *at, size_t size, int protection, int flags, int fd,
                  off_t offset)
{
    return fails(FAULT_MMAP)
               ? (void *)-1
               : __real_mmap(at, size, protection, flags, fd, offset);
}

ssize_t __wrap_read(int fd, void *buffer, size_t size)
{
    return fails(FAULT_READ) ? -1 : __real_read(fd, buffer, size);
}

ssize_t __wrap_write(int fd, const void *buffer, size_t size)
{
    return fails(FAULT_WRITE) ? -1 : __real_write(fd, buffer, size);
}

int __wrap_poll(struct pollfd *lines, nfds_t n, int timeout)
{
    return fails(FAULT_POLL) ? -1 : __real_poll(lines, n, timeout);
}

pid_t __wrap_fork(void)
{
    return fails(FAULT_FORK) ? -1 : __real_fork();
}

int __wrap_socketpair(int domain, int type, int protocol, int pair[2])
{
    return fails(FAULT_SOCKETPAIR)
               ? -1
               : __real_socketpair(domain, type, protocol, pair);
}

int __wrap_signalfd(int fd, const sigset_t *set, int flags)
{
    return fails(FAULT_SIGNALFD) ? -1 : __real_signalfd(fd, set, flags);
}

void *__wrap_calloc(size_t n, size_t size)
{
    return fails(FAULT_CALLOC) ? NULL : __real_calloc(n, size);
}

int __wrap_epoll_create1(int flags)
{
    return fails(FAULT_EPOLL) ? -1 : __real_epoll_create1(flags);
}

int __wrap_inotify_init1(int flags)
{
    return fails(FAULT_INOTIFY) ? -1 : __real_inotify_init1(flags);
}

int __wrap_timerfd_create(int clock, int flags)
{
    return fails(FAULT_TIMER) ? -1 : __real_timerfd_create(clock, flags);
}
