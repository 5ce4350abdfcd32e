/* E-paper at the pins of a Linux board, for display_linux_panel.c: flush takes
 * pixels, flip begins a refresh, which only the next one waits for. */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_PAPER_H
#define PEL_DRIVERS_DISPLAY_LINUX_PAPER_H

#include "display_linux_panel.h"

PEL_BEGIN_DECLS

/* Sets panel->paper to what the request names. False: to nothing, as that is no
 * e-paper. */
bool pel_display_paper_find(struct pel_display_panel *panel,
                            const struct pel_panel_request *request);

/* Names of chips, ", " before each, for a message; cut when too long. */
void pel_display_paper_names(char *text, size_t size);

/* Takes the line BUSY. 0 or an errno, with the message. */
int pel_display_paper_open(struct pel_display_panel *panel,
                           const struct pel_panel_request *request,
                           struct pel_message *message);

/* Sets the chip up and fills `display`, but for begin. */
enum pel_status pel_display_paper_init(struct pel_display *display,
                                       struct pel_display_panel *panel);

/* Where it was told something, it sleeps afterwards. */
void pel_display_paper_close(struct pel_display_panel *panel);
PEL_END_DECLS
#endif
