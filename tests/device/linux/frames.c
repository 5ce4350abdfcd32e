/* frames DEVICE [COUNT]: draws frames, for ever when no count is given; ends
 * with status 2 when the device fails, and tells after how many. A negative
 * count: overflows its stack instead of drawing. */
#include <stdio.h>
#include <stdlib.h>

#include "core/pel.h"
#include "drivers/display_linux.h"

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

int main(int argc, char **argv)
{
    volatile char top = 0;
    static struct pel_display_linux screen;
    const long most = argc > 2 ? atol(argv[2]) : 1000000000;
    long frame = 0;
    if (argc < 2 ||
        pel_display_linux_open(&screen, argv[1], PEL_FB_ANY) != PEL_OK) {
        fprintf(stderr, "frames: %s\n", screen.message.text);
        return 2;
    }
    fprintf(stderr, "frames: %s\n", screen.note.text);
    enum pel_status status = PEL_OK;
    for (; frame < most && status == PEL_OK; frame++) {
        pel_display_linux_wait(&screen, 0);
        status = draw(&screen, frame);
    }
    if (most < 0)
        return overflow(&top);
    pel_display_linux_close(&screen);
    if (status != PEL_OK)
        fprintf(stderr, "frames: %ld frames, then: %s\n", frame - 1,
                screen.message.text);
    return status == PEL_OK ? 0 : 2;
}
