/* Resets a console whose system calls are played here: after any step that
 * fails all others are still made, and the message names the first. */
#include "tests/support/check.h"

#include <errno.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <string.h>
#include <sys/types.h>
#include <termios.h>

#include "drivers/console_linux.h"

enum { STEPS = 6 };
static const char *const names[STEPS] = {"VT_SETMODE", "KDSKBMODE", "KDSETMODE",
                                         "termios",    "termios",   "cursor"};
static int failing, made; /* bits, by the index of a step */

static int step(int i, int done)
{
    made |= 1 << i;
    errno = EIO + i;
    return failing >> i & 1 ? -1 : done;
}

int __wrap_open(const char *path, int flags, ...)
{
    (void)path, (void)flags;
    return 100;
}

int __wrap_close(int fd)
{
    (void)fd;
    return 0;
}

int __wrap_ioctl(int fd, unsigned long request, ...)
{
    (void)fd;
    return request == VT_SETMODE  ? step(0, 0)
           : request == KDSKBMODE ? step(1, 0)
           : request == KDSETMODE ? step(2, 0)
                                  : 0;
}

int __wrap_tcgetattr(int fd, struct termios *t)
{
    (void)fd;
    memset(t, 0, sizeof *t);
    return step(3, 0);
}

int __wrap_tcsetattr(int fd, int when, const struct termios *t)
{
    (void)fd, (void)when;
    assert_true(t->c_lflag & ECHO);
    return step(4, 0);
}

ssize_t __wrap_write(int fd, const void *bytes, size_t n)
{
    (void)fd, (void)bytes;
    return step(5, (int)n);
}

TEST(goes_on_after_failures)
{
    for (failing = 0; failing < 1 << STEPS; failing++) {
        struct pel_message message = {""};
        int first = 0;
        while (first < STEPS && !(failing >> first & 1))
            first++;
        made = 0;
        const int error = pel_console_reset("/dev/tty9", &message);
        /* Settings that could not be read are not written. */
        assert_int_equal(made | (failing & 8) << 1, (1 << STEPS) - 1);
        assert_int_equal(error, first < STEPS ? EIO + first : 0);
        if (error)
            assert_non_null(strstr(message.text, names[first]));
    }
}
