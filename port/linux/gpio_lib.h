/* What gpio.c needs of libgpiod, whose versions 1 and 2 have in common how
 * a chip is opened and closed. */
#ifndef PEL_PORT_LINUX_GPIO_LIB_H
#define PEL_PORT_LINUX_GPIO_LIB_H

#include "gpio.h"

PEL_BEGIN_DECLS

enum { PEL_GPIO_EDGES_AT_ONCE = 16 }; /* that the kernel keeps of a line */

/* Of an open chip. */
unsigned pel_gpio_chip_lines(void *chip);
void pel_gpio_chip_label(void *chip, char *label, size_t size);

/* The line's number, or -1. */
int pel_gpio_chip_find(void *chip, const char *name);

/* Who holds a line; false when it is free. */
bool pel_gpio_chip_holder(void *chip, unsigned offset, char *name, size_t size);

/* Requests the lines at `offsets`: fills `request`, `debounces`. 0 or an
 * errno. */
int pel_gpio_request_lines(struct pel_gpio *gpio,
                           const struct pel_gpio_request *request);
void pel_gpio_release_lines(struct pel_gpio *gpio);

PEL_END_DECLS

#endif
