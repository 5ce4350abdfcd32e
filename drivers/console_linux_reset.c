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

static bool set_settings(int fd)
{
    struct termios t;
    if (tcgetattr(fd, &t))
        return false;
    set_sane(&t);
    return tcsetattr(fd, TCSAFLUSH, &t) == 0;
}

/* The first failure is the one to tell. */
static void check(bool done, const char *what, int *error,
                  struct pel_message *message)
{
    if (!done && !*error)
        *error = pel_message_errno(message, what);
}

/* Goes on after a failure: the less is broken, the better. */
static int reset(int fd, struct pel_message *message)
{
    struct vt_mode automatic = {.mode = VT_AUTO};
    int error = 0;
    check(pel_linux_ioctl(fd, VT_SETMODE, &automatic) == 0,
          "cannot set automatic switching (VT_SETMODE)", &error, message);
    check(pel_linux_ioctl_number(fd, KDSKBMODE, K_UNICODE) == 0,
          "cannot set the keyboard mode (KDSKBMODE)", &error, message);
    check(pel_linux_ioctl_number(fd, KDSETMODE, KD_TEXT) == 0,
          "cannot set text mode (KDSETMODE)", &error, message);
    check(set_settings(fd), "cannot set the terminal (termios)", &error,
          message);
    check(show_cursor(fd), "cannot show the cursor", &error, message);
    return error;
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
