#define _POSIX_C_SOURCE 200809L
#include "console_linux_guardian.h"

#include <errno.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

/* Holding other files of a dead process open would keep pipes and devices
 * busy. */
static void close_others(const struct pel_console_state *state, int line)
{
    long most = sysconf(_SC_OPEN_MAX);
    if (most < 0 || most > 4096)
        most = 4096;
    for (int fd = 1; fd < (int)most; fd++)
        if (fd != line && fd != state->tty && fd != state->input &&
            fd != state->framebuffer)
            close(fd);
}

/* A byte on the line means that there is nothing left to do; its end without
 * one that the process died. Descriptor 0 stays open: its flags are restored
 * too. All signals are blocked. */
static void watch(const struct pel_console_state *state, int line)
{
    char byte;
    ssize_t n;
    setpgid(0, 0);
    close_others(state, line);
    do
        n = read(line, &byte, 1);
    while (n < 0 && errno == EINTR);
    if (n < 1)
        pel_console_state_restore(state);
    _exit(0);
}

int pel_guardian_start(struct pel_guardian *guardian,
                       const struct pel_console_state *state)
{
    int line[2];
    sigset_t all, before;
    guardian->line = -1;
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line))
        return errno;
    /* No handler of the program may run in the guardian. */
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    guardian->process = fork();
    if (guardian->process == 0) {
        close(line[1]);
        watch(state, line[0]);
    }
    int error = errno;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    close(line[0]);
    if (guardian->process < 0) {
        close(line[1]);
        return error;
    }
    guardian->line = line[1];
    return 0;
}

void pel_guardian_dismiss(const struct pel_guardian *guardian)
{
    ssize_t n;
    if (guardian->line < 0)
        return;
    do
        n = send(guardian->line, "", 1, MSG_NOSIGNAL);
    while (n < 0 && errno == EINTR);
}

void pel_guardian_end(struct pel_guardian *guardian)
{
    if (guardian->line < 0)
        return;
    close(guardian->line);
    guardian->line = -1;
    while (waitpid(guardian->process, NULL, 0) < 0 && errno == EINTR)
        continue;
}
