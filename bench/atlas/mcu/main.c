/* Instructions per triangle of each way to fill one, counted in an emulator:
 * prints `method edge time triangles`, the spaces of a method's name as '_'. */
#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "bench/methods/fill.h"

enum { SIDE = 136, TRIANGLES = 20, NAME = 48 };

static uint32_t pixels[SIDE * SIDE];
static struct pel_point triangle[TRIANGLES][3];

static int32_t random_below(uint32_t *state, int32_t limit)
{
    *state = *state * 1664525u + 1013904223u;
    return (int32_t)((*state >> 8) % (uint32_t)limit);
}

static void make(int32_t edge)
{
    uint32_t state = 12345;
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        struct pel_point *p = &triangle[i / 3][i % 3];
        p->x = PEL_PX(4) + random_below(&state, PEL_PX(edge)) / 16 * 16;
        p->y = PEL_PX(4) + random_below(&state, PEL_PX(edge)) / 16 * 16;
    }
}

static void report_method(const struct pel_surface *s,
                          const struct fill_method *m, int32_t edge)
{
    char name[NAME];
    int n = 0;
    for (; m->name[n] && n < NAME - 1; n++)
        name[n] = m->name[n] == ' ' ? '_' : m->name[n];
    name[n] = 0;
    /* One by one: the stopwatch has 24 bits. */
    int32_t time = 0;
    for (int i = 0; i < TRIANGLES; i++) {
        const uint32_t from = stopwatch_read();
        m->draw(s, triangle[i], UINT32_MAX);
        time += stopwatch_eighths(from, stopwatch_read());
    }
    report(name, edge, time, TRIANGLES);
}

int main(void)
{
    static const int32_t edges[] = {4, 8, 16, 32, 64, 128};
    const struct pel_rect bounds = {0, 0, SIDE, SIDE};
    struct pel_surface s;
    if (pel_surface_init(&s, &pel_xrgb8888, pixels, sizeof pixels, &bounds))
        return 1;
    stopwatch_start();
    for (unsigned i = 0; i < sizeof edges / sizeof *edges; i++) {
        make(edges[i]);
        for (const struct fill_method *const *m = fill_methods; *m; m++)
            report_method(&s, *m, edges[i]);
    }
    return 0;
}
