/* What a pixel costs in gradients of so many cells that it has dozens of them,
 * and neighbours differ, beside those of two colors, 180 px wide. */
#include <stdio.h>

#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { WIDTH = 200, HEIGHT = 8, CELLS = 4096 };

static uint32_t memory[WIDTH * HEIGHT];
static pel_color colors[CELLS];
static struct pel_surface surface;

static void case_report(const char *kind, const char *format, int32_t cells,
                        const struct pel_paint *paint)
{
    char name[40];
    snprintf(name, sizeof name, "%s-many-%s", kind, format);
    const uint32_t from = stopwatch_read();
    pel_box(&surface, &surface.bounds, paint);
    report(name, cells, stopwatch_eighths(from, stopwatch_read()),
           WIDTH * HEIGHT);
}

static void gradients_of(const char *format, int32_t cells)
{
    static struct pel_linear linear;
    static struct pel_radial radial;
    static struct pel_conic conic;
    const int32_t size = PEL_PX(cells == 2 ? 180 : 1);
    const struct pel_point from = PEL_AT(3, 5),
                           to = {from.x + size, from.y + size / 3};
    const struct pel_rings rings = {PEL_AT(90, 12), size, 0};
    const struct pel_ramp ramp = {colors, cells, PEL_REFLECT};
    if (pel_linear_init(&linear, from, to, &ramp) ||
        pel_radial_init(&radial, &rings, &ramp) ||
        pel_conic_init(&conic, rings.center, 0, &ramp))
        printf("gradients of %d colors refused\n", (int)cells);
    case_report("linear", format, cells, &linear.base.paint);
    case_report("radial", format, cells, &radial.base.paint);
    case_report("conic", format, cells, &conic.base.paint);
}

void gradients_report(void)
{
    static const struct {
        const char *name;
        const struct pel_format *format;
    } formats[] = {{"rgb565_le", &pel_rgb565_le}, {"xrgb8888", &pel_xrgb8888}};
    const struct pel_rect bounds = {0, 0, WIDTH, HEIGHT};
    for (int i = 0; i < CELLS; i++)
        colors[i] = PEL_RGB(i & 1 ? 255 : 0, i >> 4, 90);
    for (unsigned i = 0; i < sizeof formats / sizeof *formats; i++) {
        pel_surface_init(&surface, formats[i].format, memory, sizeof memory,
                         &bounds);
        gradients_of(formats[i].name, 2);
        gradients_of(formats[i].name, CELLS);
    }
}
