/* Reading pixels: a run of colors from anywhere in a line, in every format,
 * and nothing written around them. */
#include "tests/support/canvas.h"
#include "tests/support/check.h"

enum { WIDTH = 40, Y = 3, LENGTH_MAX = 20 };

static const pel_color untouched = 0x12345678;

static void check_load(const struct canvas *c, int32_t x, int32_t n)
{
    pel_color got[LENGTH_MAX + 2];
    for (int32_t i = 0; i < LENGTH_MAX + 2; i++)
        got[i] = untouched;
    c->surface.format->load(&c->surface, x, Y, n, got + 1);
    for (int32_t i = -1; i < LENGTH_MAX + 1; i++) {
        const pel_color want =
            i < 0 || i >= n
                ? untouched
                : layout_unpack(c->layout, canvas_pixel(c, x + i, Y));
        if (got[i + 1] != want)
            fail_msg("%s, %d colours from %d: number %d: expected %08x, got "
                     "%08x",
                     c->layout->name, n, x, i, want, got[i + 1]);
    }
}

TEST(runs)
{
    static struct canvas canvas;
    const struct pel_rect bounds = {0, 0, WIDTH, 9};
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        canvas_open(&canvas, layouts[f].format, &bounds, 0);
        for (int32_t x = 0; x < WIDTH - LENGTH_MAX; x++)
            for (int32_t n = 1; n <= LENGTH_MAX; n++)
                check_load(&canvas, x, n);
    }
}
