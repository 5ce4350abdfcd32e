/* For a board under test: does core draw what it draws everywhere, and a number
 * for each frame, which the same program prints on a host. */
#include <stdio.h>

#include <pel/pel.h>
#include "drivers/display_crc.h"
#include "drivers/selftest.h"

enum { SIDE = 240, LINES = 8 };

static uint32_t memory[SIDE * LINES / 2]; /* PEL_SELFTEST_SIZE and more */

static void print(const struct pel_display_crc *crc)
{
    printf("frame %08lx\n", (unsigned long)crc->sum);
}

/* The driver of your panel, instead. */
static enum pel_status send(const struct pel_display *display,
                            const struct pel_surface *surface)
{
    (void)display;
    (void)surface;
    return PEL_OK;
}

static enum pel_status show(const struct pel_display *display, int32_t radius)
{
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(90, 200, 255, 160));
    const struct pel_point center = PEL_AT(120, 120);
    for (int32_t y = 0; y < SIDE; y += LINES) {
        const struct pel_rect lines = {0, y, SIDE, y + LINES};
        struct pel_surface s;
        if (pel_surface_init(&s, display->format, memory, sizeof memory,
                             &lines) != PEL_OK)
            return PEL_ERROR_SCRATCH;
        pel_clear(&s, PEL_RGB(10, 20, 60));
        pel_circle(&s, center, PEL_PX(radius), &glass.paint);
        pel_display_flush(display, &s);
        pel_display_wait(display); /* there is one band */
    }
    return pel_display_flip(display);
}

int main(void)
{
    static const struct pel_display panel = {
        .width = SIDE, .height = SIDE, .format = &pel_rgb565_be, .flush = send};
    struct pel_display_crc crc = {.inner = &panel, .report = print};
    struct pel_display display;
    enum pel_status status = pel_selftest_all(memory, sizeof memory);
    printf("selftest %d\n", (int)status);
    if (status == PEL_OK)
        status = pel_display_crc_init(&display, &crc);
    for (int32_t radius = 20; radius <= 100 && status == PEL_OK; radius += 40)
        status = show(&display, radius);
    return status != PEL_OK;
}
