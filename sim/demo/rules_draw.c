#include <string.h>

#include "core/pel.h"
#include "sim/demo/rules_sheet.h"

/* A paint of one colour that counts what it paints. */
struct counting {
    struct pel_paint paint;
    struct rules_pixels *pixels;
    bool y_up;
    struct pel_flat flat;
};

static void counting_fill(const struct pel_paint *paint,
                          const struct pel_spans *rows)
{
    const struct counting *c = (const struct counting *)(const void *)paint;
    for (int i = 0; i < rows->n; i++) {
        const int32_t y = rows->y + i * rows->step;
        const int32_t line = c->y_up ? RULES_HEIGHT - 1 - y : y;
        for (int32_t x = rows->span[i].x0; x < rows->span[i].x1; x++)
            c->pixels->hits[line][x]++;
    }
    pel_flat_fill(&c->flat.paint, rows);
}

static pel_color triangle_color(int i)
{
    static const pel_color colors[] = {
        PEL_RGB(0x7F, 0xB3, 0xD5), PEL_RGB(0xF5, 0xB0, 0x6B),
        PEL_RGB(0x9C, 0xCC, 0x8C), PEL_RGB(0xD7, 0xA3, 0xD0),
        PEL_RGB(0xE8, 0xD1, 0x6C), PEL_RGB(0x80, 0xC9, 0xC0),
        PEL_RGB(0xE5, 0x9A, 0x9A), PEL_RGB(0xB5, 0xA8, 0xE0),
    };
    return colors[i % 8];
}

static void draw_triangles(const struct pel_surface *surface,
                           const struct rules_case *rules,
                           struct counting *paint)
{
    for (int i = 0; i < rules->count; i++) {
        const uint8_t *q = rules->v[i];
        const struct pel_point v[3] = {{q[0] * 64, q[1] * 64},
                                       {q[2] * 64, q[3] * 64},
                                       {q[4] * 64, q[5] * 64}};
        paint->flat.color = triangle_color(i);
        if (rules->line)
            pel_triangle_or_line(surface, v, &paint->paint);
        else
            pel_triangle(surface, v, &paint->paint);
    }
}

/* A pel_color is an XRGB8888 pixel on a little-endian CPU only, so the colours
 * are read back with the format's own function. */
static void read_colors(void *memory, struct rules_pixels *pixels)
{
    struct pel_surface view;
    pel_surface_init(&view, &pel_xrgb8888, memory, RULES_WIDTH, RULES_HEIGHT);
    for (int32_t y = 0; y < RULES_HEIGHT; y++)
        view.format->load(&view, 0, y, RULES_WIDTH, pixels->color[y]);
}

void rules_draw(const struct rules_case *rules, bool y_up,
                struct rules_pixels *pixels)
{
    uint32_t memory[RULES_HEIGHT][RULES_WIDTH];
    const struct pel_rect bounds = {0, 0, RULES_WIDTH, RULES_HEIGHT};
    const int32_t stride = (int32_t)sizeof memory[0];
    struct counting paint = {
        {.fill = counting_fill}, pixels, y_up, PEL_FLAT(PEL_RGB(0, 0, 0))};
    struct pel_surface surface;
    memset(pixels->hits, 0, sizeof pixels->hits);
    pel_surface_init_rect(&surface, &pel_xrgb8888,
                          y_up ? memory[RULES_HEIGHT - 1] : memory[0],
                          y_up ? -stride : stride, &bounds);
    pel_clear(&surface, PEL_RGB(255, 255, 255));
    draw_triangles(&surface, rules, &paint);
    read_colors(memory, pixels);
}
