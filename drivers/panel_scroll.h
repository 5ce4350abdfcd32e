/* Scrolling by the panel: lines of the glass move without a pixel being sent,
 * for scopes, logs and tickers.
 *
 *     pel_panel_init(&display, &panel);
 *     pel_panel_scroll_init(&rolling, &scroll, &display, 10, 310);
 *     for (;;) {
 *         pel_panel_scroll_by(&scroll, 4);
 *         ...draw the 4 lines before line 310, and flush them to `rolling`...
 *     }
 *
 * `rolling` is the display with the coordinates that are seen, whatever has
 * been scrolled. Lines are those that the chip counts its memory by: rows of
 * the display in rotations 0 and 2, columns in 1 and 3; across them nothing
 * scrolls.
 *
 * For chips with MIPI's commands (VSCRDEF 33h, VSCRSADD 37h): ST7789, ST7735,
 * ST7796, ILI9341, ILI9488. Their data sheets are followed as remembered, on a
 * model; no module was at hand. */
#ifndef PEL_DRIVERS_PANEL_SCROLL_H
#define PEL_DRIVERS_PANEL_SCROLL_H

#include "panel.h"

PEL_BEGIN_DECLS

struct pel_panel_scroll {
    const struct pel_display *display; /* without scrolling */
    int32_t from, to;                  /* lines of it that scroll */
    int32_t at;                        /* how far, 0..to - from - 1 */
};

/* Tells the chip which lines scroll, from..to - 1 of the display of a panel,
 * and fills `rolling`, whose context is `scroll`. Both displays and `scroll`
 * stay the caller's. PEL_ERROR_NULL; PEL_ERROR_FORMAT (a chip without these
 * commands); PEL_ERROR_SIZE (no line, or one beside the display); or what the
 * bus said. */
enum pel_status pel_panel_scroll_init(struct pel_display *rolling,
                                      struct pel_panel_scroll *scroll,
                                      const struct pel_display *display,
                                      int32_t from, int32_t to);

/* Moves what the lines show by n lines towards the first: line k shows what
 * line k + n did. Any n; a negative one moves back. The n lines at the end show
 * what has left at the beginning, until they are drawn. Waits for what is in
 * flight. */
enum pel_status pel_panel_scroll_by(struct pel_panel_scroll *scroll, int32_t n);
PEL_END_DECLS
#endif
