/* System E: draws one case and shows it magnified. Only for demo_rules*.c. */
#ifndef SIM_DEMO_RULES_SHEET_H
#define SIM_DEMO_RULES_SHEET_H

#include "core/base/surface.h"
#include "sim/demo/rules_cases.h"

enum {
    RULES_ZOOM = 16, /* magnified pixels of a side */
    RULES_MARGIN = 28,
    RULES_CELL_WIDTH = RULES_WIDTH * RULES_ZOOM + RULES_MARGIN,
    RULES_CELL_HEIGHT = RULES_HEIGHT * RULES_ZOOM + RULES_MARGIN
};

/* What Pel did: the colours in memory, first line of memory first, and how
 * often each pixel was painted. */
struct rules_pixels {
    pel_color color[RULES_HEIGHT][RULES_WIDTH];
    uint8_t hits[RULES_HEIGHT][RULES_WIDTH];
};

/* Draws the case on a surface with a positive stride (y down), or with a
 * negative one, so that what memory shows has y up. */
void rules_draw(const struct rules_case *rules, bool y_up,
                struct rules_pixels *pixels);

/* Shows pixels, their centres and the true edges with the left top corner at
 * (x, y) of the sheet, and the number beside them. */
struct rules_place {
    int32_t x, y; /* px */
    int number;
    bool y_up;
};
void rules_show(const struct pel_surface *sheet,
                const struct rules_place *place, const struct rules_case *rules,
                const struct rules_pixels *pixels);

#endif
