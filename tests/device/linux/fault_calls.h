/* System calls that fail on demand: linked with --wrap for each of them. */
#ifndef TESTS_FAULT_CALLS_H
#define TESTS_FAULT_CALLS_H

enum fault_call {
    FAULT_OPEN,
    FAULT_IOCTL,
    FAULT_MMAP,
    FAULT_READ,
    FAULT_WRITE,
    FAULT_POLL,
    FAULT_FORK,
    FAULT_SOCKETPAIR,
    FAULT_SIGNALFD,
    FAULT_CALLOC,
    FAULT_EPOLL,
    FAULT_INOTIFY,
    FAULT_TIMER,
    FAULT_CALLS
};

extern const char *const fault_names[FAULT_CALLS];

/* From now on the n-th such call (from 1) of this process, not of its children,
 * fails with this errno, once. */
void fault_set(enum fault_call call, int n, int error);

/* Has it failed? */
int fault_happened(void);

#endif
