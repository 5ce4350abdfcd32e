/* The sheet of the fill rule: each case a few triangles on a small canvas,
 * shown magnified, y down and y up. */
#include "sim/demo/rules.h"

#include <stdio.h>

#include "core/pel.h"
#include "sim/demo/demo.h"
#include "sim/view/inspect.h"

enum {
    ZOOM = 16, /* magnified pixels of a side */
    MARGIN = 28,
    CELL_WIDTH = RULES_WIDTH * ZOOM + MARGIN,
    CELL_HEIGHT = RULES_HEIGHT * ZOOM + MARGIN,
    COLUMNS = 4,
    ROWS = 3
};

const struct rules_case rules_cases[] = {
    {"A left and a right edge, flat bottom", {24, 4, 6, 34, 42, 34}, 1, false},
    {"A left and a right edge, flat top", {6, 6, 42, 6, 26, 38}, 1, false},
    {"Two left edges", {30, 2, 6, 18, 34, 38}, 1, false},
    {"Two right edges", {18, 2, 42, 18, 14, 38}, 1, false},
    {"A square of two triangles: corners, sides and diagonal on pixel centres",
     {10, 6, 38, 6, 38, 34, 10, 6, 38, 34, 10, 34},
     2,
     false},
    {"A hexagon of six triangles around a pixel centre",
     {26, 22, 42, 22, 34, 6,  26, 22, 34, 6,  18, 6,  26, 22, 18, 6,  10, 22,
      26, 22, 10, 22, 18, 38, 26, 22, 18, 38, 34, 38, 26, 22, 34, 38, 42, 22},
     6,
     false},
    {"Eight triangles around one pixel centre: one of them owns it",
     {26, 22, 42, 22, 42, 38, 26, 22, 42, 38, 26, 38, 26, 22, 26, 38,
      10, 38, 26, 22, 10, 38, 10, 22, 26, 22, 10, 22, 10, 6,  26, 22,
      10, 6,  26, 6,  26, 22, 26, 6,  42, 6,  26, 22, 42, 6,  42, 22},
     8,
     false},
    {"A strip of twelve triangles that share edges",
     {2,  5,  4,  19, 13, 22, 2,  5,  14, 2,  13, 22, 14, 2,  13, 22, 25, 17,
      14, 2,  26, 9,  25, 17, 26, 9,  25, 17, 34, 22, 26, 9,  37, 3,  34, 22,
      37, 3,  34, 22, 45, 20, 37, 3,  46, 6,  45, 20, 4,  19, 2,  36, 13, 22,
      13, 22, 2,  36, 24, 38, 13, 22, 24, 38, 25, 17, 25, 17, 24, 38, 34, 22},
     12,
     false},
    {"Tiny triangles: some hold no pixel centre and cover nothing, some one "
     "pixel; the two halves of a square own its pixel once",
     {3,  3,  5,  3,  4,  5,  9,  5,  12, 5,  10, 8,  18, 6,  22, 6,  18, 10,
      30, 6,  30, 10, 26, 10, 34, 10, 38, 6,  38, 10, 42, 10, 42, 6,  46, 6,
      4,  16, 8,  16, 4,  20, 8,  16, 8,  20, 4,  20, 14, 18, 22, 18, 18, 22,
      30, 18, 34, 22, 26, 22, 38, 26, 46, 26, 46, 34, 6,  30, 26, 29, 16, 31},
     12,
     false},
    {"A fan with slivers",
     {2, 2, 46, 3,  46, 5,  2, 2, 46, 5,  46, 14, 2, 2, 46, 14, 46, 17,
      2, 2, 46, 17, 46, 26, 2, 2, 46, 26, 46, 27, 2, 2, 46, 27, 46, 38,
      2, 2, 46, 38, 32, 38, 2, 2, 32, 38, 30, 38, 2, 2, 30, 38, 16, 38,
      2, 2, 16, 38, 15, 38, 2, 2, 15, 38, 6,  38, 2, 2, 6,  38, 4,  38},
     12,
     false},
    {"Three vertices in a line cover nothing",
     {4,  6,  44, 6,  20, 6,  6,  12, 6,  36, 6,  20, 12, 36, 28,
      12, 20, 24, 18, 36, 44, 30, 31, 33, 34, 14, 44, 24, 39, 19},
     5,
     false},
    {"The same with the option that draws them as lines",
     {4,  6,  44, 6,  20, 6,  6,  12, 6,  36, 6,  20, 12, 36, 28,
      12, 20, 24, 18, 36, 44, 30, 31, 33, 34, 14, 44, 24, 39, 19},
     5,
     true},
    {NULL, {0}, 0, false},
};

static void draw_triangles(const struct pel_surface *surface,
                           const struct rules_case *rules)
{
    static const pel_color colors[8] = {
        PEL_RGB(0x7F, 0xB3, 0xD5), PEL_RGB(0xF5, 0xB0, 0x6B),
        PEL_RGB(0x9C, 0xCC, 0x8C), PEL_RGB(0xD7, 0xA3, 0xD0),
        PEL_RGB(0xE8, 0xD1, 0x6C), PEL_RGB(0x80, 0xC9, 0xC0),
        PEL_RGB(0xE5, 0x9A, 0x9A), PEL_RGB(0xB5, 0xA8, 0xE0),
    };
    for (int i = 0; i < rules->count; i++) {
        const uint8_t *q = &rules->v[6 * i];
        const struct pel_point v[3] = {{q[0] * 64, q[1] * 64},
                                       {q[2] * 64, q[3] * 64},
                                       {q[4] * 64, q[5] * 64}};
        const struct pel_flat flat = PEL_FLAT(colors[i % 8]);
        (rules->line ? pel_triangle_or_line : pel_triangle)(surface, v,
                                                            &flat.paint);
    }
}

/* Rows of memory go down the picture as it is seen. */
void rules_draw(const struct rules_case *rules, bool y_up,
                struct rules_pixels *pixels)
{
    uint32_t colors[RULES_HEIGHT][RULES_WIDTH];
    uint32_t hits[RULES_HEIGHT][RULES_WIDTH] = {{0}};
    const struct pel_rect bounds = {0, 0, RULES_WIDTH, RULES_HEIGHT};
    const int32_t size = (int32_t)sizeof colors[0];
    const int32_t stride = y_up ? -size : size;
    const int first = y_up ? RULES_HEIGHT - 1 : 0;
    struct pel_surface picture, heat;
    pel_surface_init_rect(&picture, &pel_xrgb8888, colors[first], stride,
                          &bounds);
    pel_surface_init_rect(&heat, &pel_heat, hits[first], stride, &bounds);
    pel_clear(&picture, PEL_RGB(255, 255, 255));
    draw_triangles(&picture, rules);
    draw_triangles(&heat, rules);
    for (int y = 0; y < RULES_HEIGHT; y++) {
        const int row = y_up ? RULES_HEIGHT - 1 - y : y;
        pel_xrgb8888.load(&picture, 0, y, RULES_WIDTH, pixels->color[row]);
        for (int x = 0; x < RULES_WIDTH; x++)
            pixels->hits[y][x] = (uint8_t)hits[y][x];
    }
}

/* The place of a case on the sheet: px of its left top corner. */
struct cell {
    const struct pel_surface *sheet;
    int32_t x, y;
    bool y_up;
};

static void fill_box(const struct pel_surface *sheet, int32_t x, int32_t y,
                     int32_t size, pel_color color)
{
    const struct pel_flat paint = PEL_FLAT(color);
    const struct pel_point from = {PEL_PX(x), PEL_PX(y)};
    const struct pel_point to = {PEL_PX(x + size), PEL_PX(y + size)};
    pel_rectangle(sheet, from, to, &paint.paint);
}

/* Digits of 3 x 5 blocks, rows from the top, the left block in the high bit. */
static void show_number(const struct cell *cell, int number)
{
    static const uint16_t digits[10] = {0x7B6F, 0x2C97, 0x73E7, 0x73CF, 0x5BC9,
                                        0x79CF, 0x79EF, 0x7249, 0x7BEF, 0x7BCF};
    enum { BLOCK = 2 };
    char text[12];
    snprintf(text, sizeof text, "%d", number);
    for (int n = 0; text[n]; n++)
        for (int i = 0; i < 15; i++)
            if (digits[text[n] - '0'] >> (14 - i) & 1)
                fill_box(cell->sheet, cell->x + (4 * n + i % 3) * BLOCK,
                         cell->y - 14 + i / 3 * BLOCK, BLOCK,
                         PEL_RGB(0x30, 0x30, 0x30));
}

/* One pixel: its color inside a grid line, red when painted more than once;
 * its centre, dark when covered. */
static void show_pixel(const struct cell *cell, int x, int y,
                       const struct rules_pixels *pixels)
{
    const int hits = pixels->hits[y][x];
    const int32_t left = cell->x + x * ZOOM, top = cell->y + y * ZOOM;
    const struct pel_flat dot =
        PEL_FLAT(hits ? PEL_RGB(0x20, 0x20, 0x20) : PEL_RGB(0xB8, 0xB8, 0xB8));
    const struct pel_point center = {PEL_PX(left) + ZOOM * 128,
                                     PEL_PX(top) + ZOOM * 128};
    fill_box(cell->sheet, left, top, ZOOM, PEL_RGB(0xDD, 0xDD, 0xDD));
    fill_box(cell->sheet, left + 1, top + 1, ZOOM - 1,
             hits > 1 ? PEL_RGB(255, 0, 0) : pixels->color[y][x]);
    pel_circle(cell->sheet, center, 2 * 256, &dot.paint);
}

/* A vertex in quarters of a pixel on the sheet. */
static struct pel_point zoom_point(const struct cell *cell, const uint8_t *q)
{
    const int32_t y = cell->y_up ? RULES_HEIGHT * 4 - q[1] : q[1];
    return (struct pel_point){PEL_PX(cell->x) + q[0] * ZOOM * 64,
                              PEL_PX(cell->y) + y * ZOOM * 64};
}

static void show_edges(const struct cell *cell, const struct rules_case *rules)
{
    const struct pel_flat paint = PEL_FLAT(PEL_RGB(0x10, 0x30, 0x80));
    for (int i = 0; i < 3 * rules->count; i++) {
        const uint8_t *v = &rules->v[i / 3 * 6];
        pel_line(cell->sheet, zoom_point(cell, v + 2 * (i % 3)),
                 zoom_point(cell, v + 2 * ((i + 1) % 3)), &paint.paint);
    }
}

/* Pixels painted once, and more often. */
struct tally {
    bool y_up;
    int *once, *twice;
};

static bool draw_cases(struct canvas *canvas, const void *context)
{
    const struct tally *tally = context;
    const bool y_up = tally->y_up;
    pel_clear(&canvas->surface, PEL_RGB(0xF4, 0xF4, 0xF0));
    for (int i = 0; rules_cases[i].caption; i++) {
        const struct cell cell = {&canvas->surface,
                                  MARGIN + i % COLUMNS * CELL_WIDTH,
                                  MARGIN + i / COLUMNS * CELL_HEIGHT, y_up};
        struct rules_pixels pixels;
        rules_draw(&rules_cases[i], y_up, &pixels);
        show_number(&cell, i + 1);
        for (int k = 0; k < RULES_WIDTH * RULES_HEIGHT; k++) {
            const int x = k % RULES_WIDTH, y = k / RULES_WIDTH;
            show_pixel(&cell, x, y, &pixels);
            *tally->once += pixels.hits[y][x] == 1;
            *tally->twice += pixels.hits[y][x] > 1;
        }
        show_edges(&cell, &rules_cases[i]);
    }
    return true;
}

/* The note has the captions of the cases by their numbers, and the tally. */
static bool draw_sheet(struct demo_result *result, const void *y_up)
{
    static const struct demo_size size = {&pel_xrgb8888,
                                          COLUMNS * CELL_WIDTH + MARGIN,
                                          ROWS * CELL_HEIGHT + MARGIN};
    const size_t most = sizeof result->note;
    size_t n = 0;
    int once = 0, twice = 0;
    const struct tally tally = {*(const bool *)y_up, &once, &twice};
    const bool done = demo_draw(result, &size, draw_cases, &tally);
    for (int i = 0; rules_cases[i].caption; i++)
        n += (size_t)snprintf(result->note + n, most - n, "%d: %s. ", i + 1,
                              rules_cases[i].caption);
    snprintf(result->note + n, most - n,
             "%d pixels were painted once, %d more than once (they would be "
             "red).",
             once, twice);
    return done;
}

static const bool down = false, up = true;

const struct demo demo_rules[] = {
    {"rules-top-left",
     "The fill rule, y downwards: a pixel belongs to a triangle when its "
     "centre (dot) is inside; a centre on an edge belongs to the triangle of "
     "which that edge is a <b>top</b> or a <b>left</b> one.",
     NULL, draw_sheet, &down},
    {"rules-bottom-left",
     "The same triangles on a surface with a negative stride, so that y grows "
     "upwards: now centres on a <b>bottom</b> or a <b>left</b> edge belong to "
     "the triangle.",
     NULL, draw_sheet, &up},
    {NULL, NULL, NULL, NULL, NULL},
};
