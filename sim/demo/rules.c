/* System E: the sheet of the fill rule, and its y-up twin. */
#include <stdio.h>

#include "sim/image/canvas.h"
#include "core/pel.h"
#include "sim/demo/demo.h"
#include "sim/demo/rules_sheet.h"
#include "sim/cli/milliseconds.h"

enum { COLUMNS = 4, ROWS = 3 };

struct tally {
    int once, twice; /* pixels painted once, and more often */
};

static void tally_add(struct tally *tally, const struct rules_pixels *pixels)
{
    for (int y = 0; y < RULES_HEIGHT; y++) {
        for (int x = 0; x < RULES_WIDTH; x++) {
            tally->once += pixels->hits[y][x] == 1;
            tally->twice += pixels->hits[y][x] > 1;
        }
    }
}

static struct tally draw_cases(const struct pel_surface *sheet, bool y_up)
{
    struct tally tally = {0, 0};
    pel_clear(sheet, PEL_RGB(0xF4, 0xF4, 0xF0));
    for (int i = 0; rules_cases[i].caption; i++) {
        const struct rules_place place = {
            RULES_MARGIN + i % COLUMNS * RULES_CELL_WIDTH,
            RULES_MARGIN + i / COLUMNS * RULES_CELL_HEIGHT, i + 1, y_up};
        struct rules_pixels pixels;
        rules_draw(&rules_cases[i], y_up, &pixels);
        rules_show(sheet, &place, &rules_cases[i], &pixels);
        tally_add(&tally, &pixels);
    }
    return tally;
}

/* The captions of the cases by their numbers, and the tally. */
static void write_note(const struct tally *tally, char *note, size_t size)
{
    size_t n = 0;
    for (int i = 0; rules_cases[i].caption; i++)
        n += (size_t)snprintf(note + n, size - n, "%d: %s. ", i + 1,
                              rules_cases[i].caption);
    snprintf(note + n, size - n,
             "%d pixels were painted once, %d more than once (they would be "
             "red).",
             tally->once, tally->twice);
}

enum { Y_DOWN, Y_UP };

static bool draw_sheet(struct demo_result *result, int which)
{
    struct canvas canvas;
    if (!canvas_init(&canvas, &pel_xrgb8888,
                     COLUMNS * RULES_CELL_WIDTH + RULES_MARGIN,
                     ROWS * RULES_CELL_HEIGHT + RULES_MARGIN))
        return false;
    const double start = milliseconds();
    const struct tally tally = draw_cases(&canvas.surface, which == Y_UP);
    result->milliseconds = milliseconds() - start;
    write_note(&tally, result->note, sizeof result->note);
    const bool done = canvas_picture(&canvas, &result->picture);
    canvas_free(&canvas);
    return done;
}

const struct demo demo_rules[] = {
    {"rules-top-left",
     "The fill rule, y downwards: a pixel belongs to a triangle when its "
     "centre (dot) is inside; a centre on an edge belongs to the triangle of "
     "which that edge is a <b>top</b> or a <b>left</b> one.",
     draw_sheet, Y_DOWN},
    {"rules-bottom-left",
     "The same triangles on a surface with a negative stride, so that y grows "
     "upwards: now centres on a <b>bottom</b> or a <b>left</b> edge belong to "
     "the triangle.",
     draw_sheet, Y_UP},
    {NULL, NULL, NULL, 0},
};
