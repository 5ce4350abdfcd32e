#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "console_linux.h"

#include <linux/kd.h>
#include <poll.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include "console_linux_guardian.h"
#include "linux_io.h"

/* The console that is taken. Signal handlers need it, so it is not the
 * caller's. */
static struct {
    struct pel_console_state state;
    struct pel_console_hooks hooks;
    struct pel_guardian guardian;
    sigset_t mask; /* of the thread, before */
    int switches;  /* signalfd of terminal switches; -1: none */
    bool taken;
} console = {.guardian = {.line = -1}, .switches = -1};

/* The guardian tries again what could not be restored here. */
static void restore(void)
{
    if (pel_console_state_restore(&console.state))
        pel_guardian_dismiss(&console.guardian);
}

/* The controlling terminal, or standard input, if that is a virtual one: a
 * descriptor of our own, so that its flags are nobody else's. */
static int terminal_open(int *number)
{
    static const char *const candidates[] = {"/dev/tty", "/proc/self/fd/0"};
    struct stat status;
    for (int i = 0; i < 2; i++) {
        int fd = pel_linux_open(candidates[i], O_RDWR | O_NOCTTY);
        if (fd < 0)
            continue;
        if (pel_console_is_virtual(fd)) {
            /* /dev/tty has a number of its own: ask the terminal for its
             * number. */
            *number = 0;
            if (pel_linux_ioctl(fd, TIOCGDEV, number) == 0)
                *number &= 255;
            else if (fstat(fd, &status) == 0)
                *number = (int)(status.st_rdev & 255);
            return fd;
        }
        close(fd);
    }
    return -1;
}

static void find_terminal(struct pel_console_state *s)
{
    s->tty = terminal_open(&s->number);
    s->input = s->tty;
    if (s->tty < 0 && isatty(STDIN_FILENO))
        s->input = fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
}

static void close_terminal(struct pel_console_state *s)
{
    if (s->input >= 0)
        close(s->input);
    s->tty = s->input = -1;
}

static int watch_switches(struct pel_message *message)
{
    struct vt_mode mode = {
        .mode = VT_PROCESS, .relsig = SIGUSR1, .acqsig = SIGUSR2};
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGUSR1);
    sigaddset(&set, SIGUSR2);
    sigprocmask(SIG_BLOCK, &set, NULL);
    console.switches = signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
    if (console.switches < 0)
        return pel_message_errno(message, "cannot watch for terminal switches");
    if (pel_linux_ioctl(console.state.tty, VT_SETMODE, &mode))
        return pel_message_errno(message, "cannot take over terminal switches "
                                          "(VT_SETMODE)");
    return 0;
}

/* A terminal in the background would draw over the one that is shown. */
static int show_terminal(struct pel_message *message)
{
    struct pel_console_state *s = &console.state;
    unsigned long number = (unsigned long)s->number;
    if (s->number > 0 && s->active != s->number &&
        (pel_linux_ioctl_number(s->tty, VT_ACTIVATE, number) ||
         pel_linux_ioctl_number(s->tty, VT_WAITACTIVE, number)))
        return pel_message_errno(message,
                                 "cannot show this terminal (VT_ACTIVATE)");
    return 0;
}

static int raw_keys(struct pel_message *message)
{
    struct termios raw = console.state.termios;
    raw.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    raw.c_cc[VSUSP] = _POSIX_VDISABLE;
    if (tcsetattr(console.state.input, TCSAFLUSH, &raw))
        return pel_message_errno(message,
                                 "cannot read single keys from the terminal");
    return 0;
}

static int set_up(struct pel_message *message)
{
    int error = 0;
    errno = pel_guardian_start(&console.guardian, &console.state);
    if (errno)
        return pel_message_errno(message, "cannot start the guardian process");
    pel_signals_catch(restore);
    if (console.state.tty >= 0) {
        error = show_terminal(message);
        if (!error)
            error = watch_switches(message);
        if (!error &&
            pel_linux_ioctl_number(console.state.tty, KDSETMODE, KD_GRAPHICS))
            error = pel_message_errno(message,
                                      "cannot take the console (KDSETMODE); "
                                      "run on that console, or as root");
    }
    if (!error && console.state.input >= 0)
        error = raw_keys(message);
    return error;
}

/* Virtual terminals draw in turns; who has none draws at any time, and must be
 * alone. The guardian's copy of the descriptor holds the lock too. */
static int lock_framebuffer(const struct pel_console_state *state,
                            struct pel_message *message)
{
    const int how = state->tty >= 0 ? LOCK_SH : LOCK_EX;
    if (state->framebuffer < 0 ||
        flock(state->framebuffer, how | LOCK_NB) == 0 || errno != EWOULDBLOCK)
        return 0;
    return pel_message_set(message, EBUSY,
                           "another program draws on this framebuffer, from "
                           "another terminal: end it first");
}

/* Who began second would end second, and bring back the other's settings. */
static int refuse_second(const struct pel_console_state *state,
                         struct pel_message *message)
{
    if (state->tty < 0 || state->kd_mode != KD_GRAPHICS ||
        state->vt_mode.mode != VT_PROCESS)
        return lock_framebuffer(state, message);
    return pel_message_set(message, EBUSY,
                           "another program has this terminal for its "
                           "graphics: end it, or, where it died, run "
                           "`pel console --reset`");
}

int pel_console_take(int framebuffer, const struct pel_console_hooks *hooks,
                     struct pel_message *message)
{
    static const struct pel_console_hooks none;
    pel_message_set(message, 0, "%s", "");
    if (console.taken)
        return pel_message_set(message, EBUSY,
                               "this program has the console already, for "
                               "another display: close that first");
    console.hooks = hooks ? *hooks : none;
    console.state.framebuffer = framebuffer;
    find_terminal(&console.state);
    int error = pel_console_state_save(&console.state, message);
    if (!error)
        error = refuse_second(&console.state, message);
    if (error) {
        close_terminal(&console.state);
        return error;
    }
    sigprocmask(SIG_BLOCK, NULL, &console.mask);
    console.taken = true;
    error = set_up(message);
    if (error)
        pel_console_give_back();
    else if (console.state.tty < 0)
        pel_message_set(message, 0,
                        "not on a virtual terminal: drawing, but text and "
                        "cursor of the console may show through, and terminal "
                        "switches are not seen");
    return error;
}

void pel_console_give_back(void)
{
    if (!console.taken)
        return;
    restore();
    pel_guardian_end(&console.guardian);
    if (console.switches >= 0)
        close(console.switches);
    console.switches = -1;
    pel_signals_release();
    sigprocmask(SIG_SETMASK, &console.mask, NULL);
    close_terminal(&console.state);
    console.taken = false;
}

void pel_console_restore_framebuffer(void)
{
    if (console.taken)
        pel_console_state_restore_framebuffer(&console.state);
}

/* The number of the signal that came, or 0. */
static uint32_t next_switch(void)
{
    struct signalfd_siginfo info;
    ssize_t n;
    do
        n = read(console.switches, &info, sizeof(info));
    while (n < 0 && errno == EINTR);
    return n == (ssize_t)sizeof(info) ? info.ssi_signo : 0;
}

/* The signals may come from anyone: what counts is which terminal is shown. */
static void wait_for_return(void)
{
    struct pollfd line = {.fd = console.switches, .events = POLLIN};
    while (next_switch() != SIGUSR2 ||
           !pel_console_state_is_shown(&console.state))
        poll(&line, 1, -1);
}

enum pel_console_event pel_console_check(void)
{
    enum pel_console_event event = PEL_CONSOLE_NOTHING;
    if (console.switches < 0)
        return event;
    while (next_switch() == SIGUSR1) {
        if (console.hooks.leave)
            console.hooks.leave(console.hooks.context);
        /* Refused when nobody asked for a switch: then there is none. */
        if (pel_linux_ioctl_number(console.state.tty, VT_RELDISP, 1) == 0) {
            wait_for_return();
            pel_linux_ioctl_number(console.state.tty, VT_RELDISP, VT_ACKACQ);
            pel_linux_ioctl_number(console.state.tty, KDSETMODE, KD_GRAPHICS);
        }
        if (console.hooks.enter)
            console.hooks.enter(console.hooks.context);
        event = PEL_CONSOLE_REDRAW;
    }
    return event;
}

enum pel_console_event pel_console_read(int milliseconds, int other, char *keys,
                                        size_t size, size_t *count)
{
    struct pollfd lines[3] = {{.fd = console.switches, .events = POLLIN},
                              {.fd = console.state.input, .events = POLLIN},
                              {.fd = other, .events = POLLIN}};
    *count = 0;
    if (!console.taken)
        lines[1].fd = -1;
    int n = poll(lines, 3, milliseconds);
    if (n > 0 && lines[0].revents && pel_console_check() == PEL_CONSOLE_REDRAW)
        return PEL_CONSOLE_REDRAW;
    if (n > 0 && lines[1].revents) {
        const ssize_t got = read(console.state.input, keys, size);
        if (got < 0 && (errno == EINTR || errno == EAGAIN))
            return PEL_CONSOLE_NOTHING;
        *count = got > 0 ? (size_t)got : 0;
        return PEL_CONSOLE_KEY;
    }
    return PEL_CONSOLE_NOTHING;
}

enum pel_console_event pel_console_wait(int milliseconds)
{
    char key;
    size_t count;
    return pel_console_read(milliseconds, -1, &key, 1, &count);
}
