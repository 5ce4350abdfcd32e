/* The figures of pel view, each fill for all of them. */
#include "sim/view/figures.h"

#include "core/format/formats.h"
#include "sim/cli/milliseconds.h"
#include "sim/demo/demo.h"
#include "sim/view/sheet.h"

enum { SIZE = 480 };

static bool draw_sheet(struct sheet *sheet, struct demo_result *result)
{
    struct canvas canvas;
    if (!canvas_init(&canvas, &pel_xrgb8888, SIZE, SIZE))
        return false;
    const double start = milliseconds();
    bool done = sheet->show.draw(&sheet->show, &canvas.surface);
    result->milliseconds = milliseconds() - start;
    done = done && canvas_picture(&canvas, &result->picture);
    canvas_free(&canvas);
    return done;
}

/* FILL_OWN: each figure as it begins. */
static bool draw_figures(struct demo_result *result, int fill)
{
    struct sheet sheet;
    bool done = sheet_init(&sheet, NULL);
    if (done)
        sheet.show.resize(&sheet.show, SIZE, SIZE);
    for (int i = 0; done && i < FIGURES && fill != FILL_OWN; i++)
        sheet.style[i].fill = (enum fill)fill;
    for (int i = 0; done && i < 20; i++)
        sheet.show.advance(&sheet.show, 0);
    done = done && draw_sheet(&sheet, result);
    sheet_free(&sheet);
    return done;
}

const struct demo demo_figures[] = {
    {"figures",
     "The figures of `pel view figures`, largest first, so that none hides a "
     "smaller one. They turn, and the user picks and changes them.",
     draw_figures, FILL_OWN},
    {"figures-flat", "The figures, each in one colour.", draw_figures,
     FILL_FLAT},
    {"figures-corners", "Barycentric: a colour at each corner.", draw_figures,
     FILL_CORNERS},
    {"figures-rings", "Radial: rings that repeat, with a phase.", draw_figures,
     FILL_RADIAL},
    {"figures-sectors", "By angle: the hues.", draw_figures, FILL_SECTOR},
    {NULL, NULL, NULL, 0},
};
