/* session DEVICE: draws 5 frames, and tells how often the driver asked to wait
 * for the vertical blank and what it was answered at last. A second display
 * beside the first must be refused, with a message, and leave the first and the
 * console as they are. Linked with --wrap=ioctl. */
#include <errno.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>

#include "core/pel.h"
#include "drivers/display_linux.h"

enum { FRAMES = 5 };

static int waits, answer;

int __real_ioctl(int fd, unsigned long request, ...);
int __wrap_ioctl(int fd, unsigned long request, ...);

int __wrap_ioctl(int fd, unsigned long request, ...)
{
    va_list arguments;
    va_start(arguments, request);
    void *argument = va_arg(arguments, void *);
    va_end(arguments);
    int result = __real_ioctl(fd, request, argument);
    if (request == FBIO_WAITFORVSYNC) {
        waits++;
        answer = result ? errno : 0;
    }
    return result;
}

static int fail(const char *what, const struct pel_display_linux *screen)
{
    printf("FAIL %s: %s\n", what, screen->message.text);
    return 1;
}

static enum pel_status draw(struct pel_display_linux *screen)
{
    struct pel_surface surface;
    enum pel_status status =
        pel_display_begin(&screen->display, &screen->area, &surface);
    if (status != PEL_OK)
        return status;
    pel_clear(&surface, PEL_RGB(20, 30, 40));
    status = pel_display_flush(&screen->display, &surface);
    return status == PEL_OK ? pel_display_flip(&screen->display) : status;
}

static int check_second(const char *device)
{
    static struct pel_display_linux second;
    int mode = -1;
    if (pel_display_linux_open(&second, device, PEL_FB_ANY) == PEL_OK)
        return fail("a second display is opened", &second);
    if (!strstr(second.message.text, "already"))
        return fail("a second display is refused with", &second);
    pel_display_linux_close(&second);
    if (ioctl(0, KDGETMODE, &mode) || mode != KD_GRAPHICS)
        return fail("a second display gave the console back", &second);
    return 0;
}

int main(int argc, char **argv)
{
    static struct pel_display_linux screen;
    if (argc < 2 ||
        pel_display_linux_open(&screen, argv[1], PEL_FB_ANY) != PEL_OK)
        return fail("open", &screen);
    int bad = check_second(argv[1]);
    for (int i = 0; i < FRAMES && !bad; i++)
        if (draw(&screen) != PEL_OK)
            bad = fail("draw", &screen);
    pel_display_linux_close(&screen);
    printf("%d wait%s for the vertical blank", waits, waits == 1 ? "" : "s");
    if (waits)
        printf(": %s", answer == ENOTTY ? "ENOTTY"
                       : answer         ? strerror(answer)
                                        : "done");
    printf("\n");
    return bad;
}
