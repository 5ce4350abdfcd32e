/* damage DEVICE: shows grey frames, then a red one, and after a key a blue one,
 * of which it flushes less than it draws; the next key ends it. A device that
 * is told of the damage shows red where that was flushed, and then blue in the
 * box of both. */
#include <stdio.h>

#include "core/pel.h"
#include "drivers/display_linux.h"

static const struct pel_rect damage[2] = {{40, 30, 140, 70},
                                          {100, 60, 240, 200}};

static enum pel_status show(struct pel_display_linux *screen, pel_color color,
                            const struct pel_rect *flushed)
{
    struct pel_surface surface;
    enum pel_status status =
        pel_display_begin(&screen->display, &screen->area, &surface);
    if (status != PEL_OK)
        return status;
    pel_clear(&surface, color);
    pel_surface_clip(&surface, flushed);
    status = pel_display_flush(&screen->display, &surface);
    return status == PEL_OK ? pel_display_flip(&screen->display) : status;
}

int main(int argc, char **argv)
{
    static struct pel_display_linux screen;
    static const pel_color colors[2] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 0, 255)};
    if (argc < 2 ||
        pel_display_linux_open(&screen, argv[1], PEL_FB_ANY) != PEL_OK) {
        fprintf(stderr, "damage: %s\n", screen.message.text);
        return 2;
    }
    enum pel_status status = PEL_OK;
    for (int i = 0; i < 3 && status == PEL_OK; i++)
        status = show(&screen, PEL_RGB(128, 128, 128),
                      i < 2 ? &screen.area : &damage[0]);
    for (int i = 0; i < 2 && status == PEL_OK; i++) {
        status = show(&screen, colors[i], &damage[i]);
        fprintf(stderr, "damage: %s\n", screen.note.text);
        while (pel_display_linux_wait(&screen, -1) != PEL_CONSOLE_KEY)
            continue;
    }
    pel_display_linux_close(&screen);
    return status == PEL_OK ? 0 : 2;
}
