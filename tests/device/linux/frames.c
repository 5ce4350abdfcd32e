/* frames DEVICE [COUNT]: draws frames, for ever when no count is given, and
 * tells when it has drawn two; ends with status 2 when the device fails, and
 * tells after how many. A negative count: overflows its stack instead of
 * drawing. With a count it tells how often the driver asked to wait for the
 * vertical blank and what it was answered at last; a second display beside the
 * first must be refused, with a message, and leave the first and the console as
 * they are. Linked with --wrap=ioctl. */
#include <errno.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>

#include "core/pel.h"
#include "drivers/display_linux.h"

static int waits, answer;

int __real_ioctl(int fd, unsigned long request, ...);

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

static enum pel_status draw(struct pel_display_linux *screen, long frame)
{
    struct pel_surface surface;
    const struct pel_display *display = &screen->display;
    const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 60, 40));
    const int32_t left = (int32_t)(frame * 7 % (display->width - 20));
    const struct pel_point from = PEL_AT(left, 10);
    const struct pel_point to = PEL_AT(left + 20, display->height - 10);
    enum pel_status status =
        pel_display_begin(display, &screen->area, &surface);
    if (status != PEL_OK)
        return status;
    pel_clear(&surface, PEL_RGB(20, 30, 40));
    pel_rectangle(&surface, from, to, &red.paint);
    status = pel_display_flush(display, &surface);
    return status == PEL_OK ? pel_display_flip(display) : status;
}

static int overflow(volatile char *above)
{
    volatile char here[4096];
    here[0] = above[0];
    if (here[0])
        return 0;
    return overflow(here) + here[0];
}

/* What is wrong with a second display, or NULL. */
static const char *check_second(const char *device)
{
    static struct pel_display_linux second;
    int mode = -1;
    if (pel_display_linux_open(&second, device, PEL_FB_ANY) == PEL_OK)
        return "a second display is opened";
    if (!strstr(second.message.text, "already"))
        return second.message.text;
    pel_display_linux_close(&second);
    if (ioctl(0, KDGETMODE, &mode) || mode != KD_GRAPHICS)
        return "a second display gave the console back";
    return NULL;
}

static void print_waits(void)
{
    printf("%d wait%s for the vertical blank", waits, waits == 1 ? "" : "s");
    if (waits)
        printf(": %s", answer == ENOTTY ? "ENOTTY"
                       : answer         ? strerror(answer)
                                        : "done");
    printf("\n");
}

int main(int argc, char **argv)
{
    volatile char top = 0;
    static struct pel_display_linux screen;
    const long most = argc > 2 ? atol(argv[2]) : 0;
    long frame = 0;
    if (argc < 2 ||
        pel_display_linux_open(&screen, argv[1], PEL_FB_ANY) != PEL_OK) {
        fprintf(stderr, "frames: %s\n", screen.message.text);
        return 2;
    }
    const char *wrong = most > 0 ? check_second(argv[1]) : NULL;
    if (wrong)
        printf("FAIL %s\n", wrong);
    if (most < 0)
        return overflow(&top);
    enum pel_status status = PEL_OK;
    for (; (!most || frame < most) && status == PEL_OK; frame++) {
        if (!most && frame == 2)
            fprintf(stderr, "frames: drawing\n");
        if (!most)
            pel_display_linux_wait(&screen, 0);
        status = draw(&screen, frame);
    }
    pel_display_linux_close(&screen);
    if (most)
        print_waits();
    if (status != PEL_OK)
        fprintf(stderr, "frames: %ld frames, then: %s\n", frame - 1,
                screen.message.text);
    return status == PEL_OK && !wrong ? 0 : 2;
}
