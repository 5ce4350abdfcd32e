/* The bus of panels and touch chips (drivers/bus.h) on Linux: SPI by spidev,
 * I2C by i2c-dev, other lines by libgpiod (gpio.h).
 *
 * Nothing is copied on SPI: the kernel reads rows where they lie, in pieces of
 * spidev's bufsiz (4 KB, or what spidev.bufsiz= on the kernel's command line
 * says). I2C needs a control byte before each piece, so rows go through a
 * buffer of 129 bytes. */
#ifndef PEL_PORT_LINUX_BUS_H
#define PEL_PORT_LINUX_BUS_H

#include "../../drivers/bus.h"
#include "gpio.h"

PEL_BEGIN_DECLS

/* A line is a name, GPIO25, or one of a chip, gpiochip0:25; NULL: there is
 * none. */
struct pel_bus_request {
    const char *spi;   /* /dev/spidev0.0, or */
    const char *i2c;   /* /dev/i2c-1 */
    uint32_t speed;    /* Hz, of SPI; 0: 32 MHz, which the kernel rounds down */
    uint8_t mode;      /* of SPI, 0 to 3; panels without a pin CS want 3 */
    uint8_t address;   /* of I2C, 7 bits */
    bool plain;        /* I2C without control bytes, as touch chips have it */
    const char *dc;    /* high for data; SPI with `data` needs it */
    const char *reset; /* low resets */
    const char *light; /* high after open, low after close */
};

struct pel_bus_linux {
    struct pel_bus bus;
    int fd;
    struct pel_gpio dc, reset, light;
    int data;             /* what D/C is: 0, 1, or -1 before it was set */
    uint32_t speed, most; /* SPI: Hz; bytes of a message */
    uint8_t address;
    bool plain;
    char path[64];
    struct pel_message *message;
};

/* Nothing is sent yet. 0 or an errno, with the message; EAGAIN: another program
 * has the chip of I2C; EBUSY: a line; a later error of the bus is told in
 * `message` too, which outlives the bus. */
int pel_bus_linux_open(struct pel_bus_linux *bus,
                       const struct pel_bus_request *request,
                       struct pel_message *message);

/* Nothing when it is not open. */
void pel_bus_linux_close(struct pel_bus_linux *bus);

/* Takes a line that is named as above; nothing without a name. 0 or an errno,
 * with the message. */
int pel_bus_line_open(struct pel_gpio *line, const char *name,
                      enum pel_gpio_use use, struct pel_message *message);

/* For bus.c, bus_spi.c and bus_i2c.c: set up the device that is open, and
 * `command` and `data`. 0 or an errno, with the message. */
int pel_bus_spi_start(struct pel_bus_linux *bus,
                      const struct pel_bus_request *request);
int pel_bus_i2c_start(struct pel_bus_linux *bus,
                      const struct pel_bus_request *request);

/* "/dev/spidev0.0: WHAT: Input/output error"; the errno given. */
int pel_bus_fails(struct pel_bus_linux *bus, const char *what, int error);
PEL_END_DECLS
#endif
