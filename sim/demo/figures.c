/* The figures of pel view, each fill for all of them. */
#include "sim/view/figures.h"

#include "core/format/formats.h"
#include "sim/demo/demo.h"
#include "sim/view/sheet.h"

enum { SIZE = 480 };

static bool draw_sheet(struct canvas *canvas, const void *context)
{
    struct sheet *const *sheet = context;
    return (*sheet)->show.draw(&(*sheet)->show, &canvas->surface);
}

/* With each figure's own fill where that is FILL_OWN. */
static bool draw_figures(struct demo_result *result, const void *what)
{
    const enum fill fill = *(const enum fill *)what;
    static const struct demo_size size = {&pel_xrgb8888, SIZE, SIZE};
    struct sheet sheet, *context = &sheet;
    bool done = sheet_init(&sheet, NULL);
    if (done)
        sheet.show.resize(&sheet.show, SIZE, SIZE);
    for (int i = 0; done && i < FIGURES && fill != FILL_OWN; i++)
        sheet.style[i].fill = fill;
    for (int i = 0; done && i < 20; i++)
        sheet.show.advance(&sheet.show, 0);
    done = done && demo_draw(result, &size, draw_sheet, &context);
    sheet_free(&sheet);
    return done;
}

static const enum fill own = FILL_OWN, flat = FILL_FLAT, rings = FILL_RADIAL,
                       corners = FILL_CORNERS, sectors = FILL_SECTOR;

const struct demo demo_figures[] = {
    {"figures",
     "The figures of <code>pel view figures</code>, largest first, so that "
     "none hides a "
     "smaller one. They turn, and the user picks and changes them.",
     "pel view figures", draw_figures, &own},
    {"figures-flat", "The figures, each in one colour.", NULL, draw_figures,
     &flat},
    {"figures-corners", "Barycentric: a colour at each corner.", NULL,
     draw_figures, &corners},
    {"figures-rings", "Radial: rings that repeat, with a phase.", NULL,
     draw_figures, &rings},
    {"figures-sectors", "By angle: the hues.", NULL, draw_figures, &sectors},
    {NULL, NULL, NULL, NULL, NULL},
};
