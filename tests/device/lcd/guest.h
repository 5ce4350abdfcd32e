/* What the programs of the boards have in common. UART is the address of the
 * serial line, a PL011 or one like it, at whose other end is device/linux/vm.c.
 */
#ifndef TESTS_DEVICE_LCD_GUEST_H
#define TESTS_DEVICE_LCD_GUEST_H

#include <pel/pel.h>

/* Writes a line, and waits until it is answered. */
void guest_ask(const char *line);

/* The last word. */
__attribute__((__noreturn__)) void guest_done(bool good);

/* The picture of device/linux/reference.pel. */
void guest_draw(const struct pel_surface *s);

#endif
