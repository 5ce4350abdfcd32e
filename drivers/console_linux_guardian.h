/* What restores the console when the program does not: signals that would end
 * it, caught, and a process that watches for SIGKILL and the out-of-memory
 * killer. KD_GRAPHICS outlives the process that set it. */
#ifndef PEL_DRIVERS_CONSOLE_LINUX_GUARDIAN_H
#define PEL_DRIVERS_CONSOLE_LINUX_GUARDIAN_H

#include <sys/types.h>

#include "console_linux_state.h"

PEL_BEGIN_DECLS

struct pel_guardian {
    pid_t process;
    int line; /* the guardian watches its other end; -1: none */
};

/* Forks the guardian, which keeps a copy of `state`, the descriptors in it and
 * standard input, whose flags are in it, and no other descriptor. It leaves the
 * process group, so that signals from the keyboard do not reach it, and ignores
 * the others. It stays in the session, because the right to set console modes
 * comes with the controlling terminal; a session leader without
 * CAP_SYS_TTY_CONFIG that is killed takes that right from it. 0 or an errno. */
int pel_guardian_start(struct pel_guardian *guardian,
                       const struct pel_console_state *state);

/* Tells the guardian that all is restored. Safe in a signal handler. */
void pel_guardian_dismiss(const struct pel_guardian *guardian);

/* Waits for its end; not dismissed, it restores first. */
void pel_guardian_end(struct pel_guardian *guardian);

/* From now on a signal that would end or stop the process calls `restore` once
 * (it must be async-signal-safe), then the action that was set before. Signals
 * that were ignored stay so; SIGTSTP, SIGTTIN and SIGTTOU are ignored. A
 * stack of its own makes this work when the stack has overflowed (of the
 * calling thread). */
void pel_signals_catch(void (*restore)(void));

/* The actions of before. */
void pel_signals_release(void);
PEL_END_DECLS
#endif
