#include "bus.h"

#include <errno.h>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <string.h>

#include "../../drivers/linux_io.h"

enum { PIECE = 128, COMMAND = 0x00, DATA = 0x40 };

/* A write, and a read after it where there is one, with no stop between. */
static int transfer(struct pel_bus_linux *bus, uint8_t *bytes, size_t n,
                    uint8_t *answer, size_t answers)
{
    struct i2c_msg messages[2] = {
        {.addr = bus->address, .len = (uint16_t)n, .buf = bytes},
        {.addr = bus->address,
         .flags = I2C_M_RD,
         .len = (uint16_t)answers,
         .buf = answer}};
    struct i2c_rdwr_ioctl_data data = {messages, answers ? 2 : 1};
    if (pel_linux_ioctl(bus->fd, I2C_RDWR, &data) >= 0)
        return 0;
    const int error = errno;
    if (error != ENXIO && error != EREMOTEIO && error != ETIMEDOUT)
        return pel_bus_fails(bus, "transfer", error);
    return pel_message_set(bus->message, error,
                           "no chip answers at address 0x%02x of %s: %s",
                           bus->address, bus->path, strerror(error));
}

static enum pel_status i2c_command(const struct pel_bus *pel_bus,
                                   const uint8_t *bytes, size_t n,
                                   uint8_t *answer, size_t answers)
{
    struct pel_bus_linux *bus = pel_bus->context;
    uint8_t buffer[1 + PIECE] = {COMMAND};
    const size_t skip = bus->plain ? 0 : 1;
    if (n > PIECE) {
        pel_bus_fails(bus, "a command of more than 128 bytes", EMSGSIZE);
        return PEL_ERROR_SIZE;
    }
    memcpy(buffer + skip, bytes, n);
    return transfer(bus, buffer, n + skip, answer, answers) ? PEL_ERROR_DEVICE
                                                            : PEL_OK;
}

static enum pel_status i2c_data(const struct pel_bus *pel_bus,
                                const struct pel_bus_rows *rows)
{
    struct pel_bus_linux *bus = pel_bus->context;
    uint8_t buffer[1 + PIECE] = {DATA};
    size_t used = 1;
    for (int32_t row = 0; row < rows->count; row++)
        for (int32_t i = 0; i < rows->length; i++) {
            if (used == sizeof buffer) {
                if (transfer(bus, buffer, used, NULL, 0))
                    return PEL_ERROR_DEVICE;
                used = 1;
            }
            buffer[used++] = rows->bytes[(ptrdiff_t)row * rows->stride + i];
        }
    return transfer(bus, buffer, used, NULL, 0) ? PEL_ERROR_DEVICE : PEL_OK;
}

/* One program for each address, until its descriptors are closed: the kernel
 * lets all send. */
static int lock_address(struct pel_bus_linux *bus)
{
    struct flock lock = {
        .l_type = F_WRLCK, .l_start = bus->address, .l_len = 1};
    if (fcntl(bus->fd, F_OFD_SETLK, &lock) == 0)
        return 0;
    const int error = errno;
    if (error != EAGAIN && error != EACCES)
        return pel_bus_fails(bus, "lock", error);
    return pel_message_set(bus->message, error,
                           "another program has the chip at address 0x%02x of "
                           "%s: end it first",
                           bus->address, bus->path);
}

int pel_bus_i2c_start(struct pel_bus_linux *bus,
                      const struct pel_bus_request *request)
{
    bus->bus.command = i2c_command;
    bus->bus.data = request->plain ? NULL : i2c_data;
    bus->address = request->address;
    bus->plain = request->plain;
    if (pel_linux_ioctl_number(bus->fd, I2C_SLAVE, bus->address) == 0)
        return lock_address(bus);
    const int error = errno;
    if (error == EBUSY)
        return pel_message_set(bus->message, error,
                               "a driver of the kernel has the chip at address "
                               "0x%02x of %s",
                               bus->address, bus->path);
    return error == ENOTTY ? pel_message_set(bus->message, error,
                                             "%s is no I2C device", bus->path)
                           : pel_bus_fails(bus, "address", error);
}
