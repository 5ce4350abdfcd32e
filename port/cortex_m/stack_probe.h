/* Measures the stack that a call uses. */
#ifndef PORT_CORTEX_M_STACK_PROBE_H
#define PORT_CORTEX_M_STACK_PROBE_H

#include <stdint.h>

#include <pel/pel.h>

PEL_BEGIN_DECLS

/* Paints the free stack, calls, and looks how deep the paint was touched: bytes
 * below this function's own frame. */
uint32_t stack_used(void (*call)(const void *argument), const void *argument);
PEL_END_DECLS
#endif
