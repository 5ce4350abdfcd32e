/* The state of a console and of a framebuffer device that has to be as before
 * when a program ends, however it ends. */
#ifndef PEL_DRIVERS_CONSOLE_LINUX_STATE_H
#define PEL_DRIVERS_CONSOLE_LINUX_STATE_H

#include <linux/fb.h>
#include <linux/vt.h>
#include <stdbool.h>
#include <stdint.h>
#include <termios.h>

#include "linux_message.h"

PEL_BEGIN_DECLS

enum { PEL_PALETTE_ENTRIES = 256 };

struct pel_console_state {
    int tty;         /* the virtual terminal; -1: none */
    int input;       /* the terminal that keys come from; -1: none */
    int framebuffer; /* -1: none */

    int number; /* of the virtual terminal, from 1 */
    int active; /* the one that was shown */
    int kd_mode, keyboard_mode;
    struct vt_mode vt_mode;
    struct termios termios; /* of input */
    int input_flags;        /* of descriptor 0: O_NONBLOCK is among them */
    struct fb_var_screeninfo variables;
    bool has_palette;
    uint32_t palette_length; /* entries in use */
    uint16_t red[PEL_PALETTE_ENTRIES], green[PEL_PALETTE_ENTRIES],
        blue[PEL_PALETTE_ENTRIES];
};

/* Is it a virtual terminal, not a serial line or a pipe? */
bool pel_console_is_virtual(int fd);

/* Reads everything from the three descriptors, which the caller has set. 0, or
 * an errno, with the message telling which step failed. */
int pel_console_state_save(struct pel_console_state *state,
                           struct pel_message *message);

/* True when the virtual terminal is the one that is shown, or there is none. */
bool pel_console_state_is_shown(const struct pel_console_state *state);

/* Puts everything back; the framebuffer's mode and palette only while the
 * terminal is shown, as they belong to whoever is. Goes on after a failure:
 * what can be restored, is. False when something could not. Safe in a signal
 * handler, and in any process that holds the descriptors. */
bool pel_console_state_restore(const struct pel_console_state *state);

/* The mode and the palette of the framebuffer alone. */
bool pel_console_state_restore_framebuffer(
    const struct pel_console_state *state);
PEL_END_DECLS
#endif
