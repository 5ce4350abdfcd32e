/* System calls that begin again when a signal interrupts them. Safe in signal
 * handlers. */
#ifndef PEL_DRIVERS_LINUX_IO_H
#define PEL_DRIVERS_LINUX_IO_H

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <sys/ioctl.h>
#include <time.h>

#include <pel/pel.h>

static inline int pel_linux_open(const char *path, int flags)
{
    int fd;
    do
        fd = open(path, flags | O_CLOEXEC);
    while (fd < 0 && errno == EINTR);
    return fd;
}

static inline int pel_linux_ioctl(int fd, unsigned long request, void *argument)
{
    int result;
    do
        result = ioctl(fd, request, argument);
    while (result < 0 && errno == EINTR);
    return result;
}

/* For requests whose argument is a number. */
static inline int pel_linux_ioctl_number(int fd, unsigned long request,
                                         uintptr_t argument)
{
    return pel_linux_ioctl(fd, request, PEL_CAST_ADDRESS(void *, argument));
}

/* Of CLOCK_MONOTONIC; wraps. */
static inline uint32_t pel_linux_milliseconds(void)
{
    struct timespec now = {0, 0};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return PEL_CAST(uint32_t, PEL_CAST(uint64_t, now.tv_sec) * 1000 +
                                  PEL_CAST(uint64_t, now.tv_nsec) / 1000000);
}

#endif
