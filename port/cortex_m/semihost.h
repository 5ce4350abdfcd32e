/* Semihosting: text to, and exit status for, the debugger or the emulator that
 * runs the program. Without one, the first call is a fault. */
#ifndef PORT_CORTEX_M_SEMIHOST_H
#define PORT_CORTEX_M_SEMIHOST_H

#include <stdint.h>

#include <pel/pel.h>

PEL_BEGIN_DECLS

void semihost_write(const char *text);

/* In decimal; needs no division. */
void semihost_write_number(uint32_t number);

/* Ends the program; status 0..255 becomes the emulator's own exit status. */
__attribute__((__noreturn__)) void semihost_exit(int status);
PEL_END_DECLS
#endif
