/* The Linux console while a program draws on the screen: taken at the start,
 * given back at the end, whatever the end is.
 *
 * One process has one console, so there is one state, and no struct of the
 * caller. While it is taken:
 *   - the kernel draws no text (KD_GRAPHICS); keys are not echoed and come one
 *     by one; Ctrl-C still interrupts, Ctrl-Z does nothing;
 *   - signals that would end the process restore the console first and are then
 *     raised again; handlers that were there before run after that;
 *   - a guardian process (a child; waitpid(-1) may see it) restores after
 *     SIGKILL;
 *   - another virtual terminal can be switched to: the program stops at its
 *     next pel_console_check and goes on when it is shown again. SIGUSR1 and
 *     SIGUSR2 are used for that and stay blocked.
 * Threads are started after the console was taken, so that they inherit the
 * blocked signals; the calls below come from one thread.
 *
 * Not on a virtual terminal (ssh, a serial line, a service) there is no text to
 * stop and no terminal to switch: drawing works, and notes say so. */
#ifndef PEL_DRIVERS_CONSOLE_LINUX_H
#define PEL_DRIVERS_CONSOLE_LINUX_H

#include <stdbool.h>
#include <stddef.h>

#include "console_linux_state.h"

PEL_BEGIN_DECLS

enum pel_console_event {
    PEL_CONSOLE_NOTHING, /* the time is over, or a signal came */
    PEL_CONSOLE_KEY,     /* a key was pressed, or the input has ended */
    PEL_CONSOLE_REDRAW   /* shown again: all pixels are lost */
};

/* Work of a display when another terminal is shown, and when it returns.
 * NULL: nothing. */
struct pel_console_hooks {
    void *context;
    void (*leave)(void *context);
    void (*enter)(void *context);
};

/* Takes the console; `framebuffer` is an open fbdev device whose mode and
 * palette are to be saved, or -1. 0, with a note or an empty message; or an
 * errno, with the message telling why, and everything as before: EBUSY while it
 * is taken. */
int pel_console_take(int framebuffer, const struct pel_console_hooks *hooks,
                     struct pel_message *message);

/* Gives it back; nothing when it was not taken. */
void pel_console_give_back(void);

/* Mode and palette of the framebuffer as they were, while another terminal is
 * shown. */
void pel_console_restore_framebuffer(void);

/* Lets a terminal switch happen that was asked for, and returns when this
 * terminal is shown again: PEL_CONSOLE_REDRAW, otherwise PEL_CONSOLE_NOTHING.
 * Called whenever no thread draws; costs one system call. */
enum pel_console_event pel_console_check(void);

/* Waits for a key or a redraw, at most `milliseconds`; -1: for ever. */
enum pel_console_event pel_console_wait(int milliseconds);

/* The same, and keeps the keys: at most `size` >= 1 bytes, as the terminal
 * sends them; PEL_CONSOLE_KEY with a count of 0: the input has ended. Waits no
 * longer when the descriptor `other` is readable; -1: none. */
enum pel_console_event pel_console_read(int milliseconds, int other, char *keys,
                                        size_t size, size_t *count);

/* Repairs a virtual terminal that something left in graphics mode, with a raw
 * keyboard, without echo or without its cursor: text mode, Unicode keyboard,
 * automatic switching, sane settings. `path` is /dev/ttyN, or NULL for the one
 * that the program runs on, and where it does not run on one (ssh) for the one
 * that is shown, which needs root. 0 or an errno, with the message. */
int pel_console_reset(const char *path, struct pel_message *message);
PEL_END_DECLS
#endif
