#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "console_linux.h"

#include <linux/kd.h>
#include <unistd.h>

#include "linux_io.h"

static void set_sane(struct termios *t)
{
    t->c_iflag |= BRKINT | ICRNL | IXON;
    t->c_iflag &= ~(tcflag_t)(IGNBRK | INLCR | IGNCR);
    t->c_oflag |= OPOST | ONLCR;
    t->c_cflag |= CREAD;
    t->c_lflag |= ISIG | ICANON | IEXTEN | ECHO | ECHOE | ECHOK;
    t->c_lflag &= ~(tcflag_t)(ECHONL | NOFLSH | TOSTOP);
    t->c_cc[VINTR] = 3;
    t->c_cc[VSUSP] = 26;
    t->c_cc[VMIN] = 1;
    t->c_cc[VTIME] = 0;
}

static bool show_cursor(int fd)
{
    static const char cursor_on[] = "\033[?25h";
    ssize_t n;
    do
        n = write(fd, cursor_on, sizeof(cursor_on) - 1);
    while (n < 0 && errno == EINTR);
    return n > 0;
}

/* Restores a state in which nothing is broken. */
static int reset(int fd, struct pel_message *message)
{
    struct pel_console_state state = {.tty = fd,
                                      .input = fd,
                                      .framebuffer = -1,
                                      .kd_mode = KD_TEXT,
                                      .keyboard_mode = K_UNICODE,
                                      .vt_mode = {.mode = VT_AUTO},
                                      .input_flags = -1};
    bool done = tcgetattr(fd, &state.termios) == 0;
    set_sane(&state.termios);
    done = done && pel_console_state_restore(&state);
    return show_cursor(fd) && done
               ? 0
               : pel_message_errno(message, "cannot set up the terminal");
}

/* Whoever sits at a terminal may set it without being root. */
static int open_own(void)
{
    int fd = pel_linux_open("/dev/tty", O_RDWR | O_NOCTTY);
    if (fd < 0 || pel_console_is_virtual(fd))
        return fd;
    close(fd);
    return -1;
}

int pel_console_reset(const char *path, struct pel_message *message)
{
    int fd = path ? -1 : open_own();
    if (!path)
        path = "/dev/tty0";
    if (fd < 0)
        fd = pel_linux_open(path, O_RDWR | O_NOCTTY);
    if (fd < 0)
        return pel_message_open(
            message, path, errno,
            "has this machine virtual terminals? ls /dev/tty*");
    int error = 0;
    if (!pel_console_is_virtual(fd)) {
        error = pel_message_set(message, errno,
                                "%s is not a virtual terminal; give one with "
                                "--tty /dev/ttyN",
                                path);
    } else {
        error = reset(fd, message);
    }
    close(fd);
    return error;
}
