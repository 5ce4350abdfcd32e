/* What bus.c, bus_spi.c and bus_i2c.c share. */
#ifndef PEL_PORT_LINUX_BUS_KINDS_H
#define PEL_PORT_LINUX_BUS_KINDS_H

#include "bus.h"

PEL_BEGIN_DECLS

/* Set up the device that is open, and `command` and `data`. 0 or an errno, with
 * the message. */
int pel_bus_spi_start(struct pel_bus_linux *bus,
                      const struct pel_bus_request *request);
int pel_bus_i2c_start(struct pel_bus_linux *bus,
                      const struct pel_bus_request *request);

/* "/dev/spidev0.0: WHAT: Input/output error"; the errno given. */
int pel_bus_fails(struct pel_bus_linux *bus, const char *what, int error);

PEL_END_DECLS
#endif
