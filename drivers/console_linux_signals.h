/* Signals that end a process, caught so that something runs first. */
#ifndef PEL_DRIVERS_CONSOLE_LINUX_SIGNALS_H
#define PEL_DRIVERS_CONSOLE_LINUX_SIGNALS_H

#include "../core/base/inline.h"

PEL_BEGIN_DECLS

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
