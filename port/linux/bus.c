#include "bus.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../../drivers/linux_io.h"

int pel_bus_fails(struct pel_bus_linux *bus, const char *what, int error)
{
    return pel_message_set(bus->message, error, "%s: %s: %s", bus->path, what,
                           strerror(error));
}

static int set_line(struct pel_bus_linux *bus, struct pel_gpio *line, bool high)
{
    const int error = line->request ? pel_gpio_set(line, 0, high) : 0;
    return error ? pel_message_set(bus->message, error, "a line of %s: %s",
                                   line->path, strerror(error))
                 : 0;
}

static void sleep_ms(uint32_t ms)
{
    struct timespec left = {(time_t)(ms / 1000), (long)(ms % 1000) * 1000000};
    while (nanosleep(&left, &left) < 0 && errno == EINTR)
        continue;
}

static enum pel_status bus_pause(const struct pel_bus *pel_bus, bool reset,
                                 uint32_t ms)
{
    struct pel_bus_linux *bus = pel_bus->context;
    int error = reset ? set_line(bus, &bus->reset, false) : 0;
    if (!error && reset && bus->reset.request) {
        sleep_ms(1);
        error = set_line(bus, &bus->reset, true);
    }
    sleep_ms(error ? 0 : ms);
    return error ? PEL_ERROR_DEVICE : PEL_OK;
}

int pel_bus_line_open(struct pel_gpio *line, const char *name,
                      enum pel_gpio_use use, struct pel_message *message)
{
    char chip[64];
    struct pel_gpio_request request = {.lines = {name}, .count = 1, .use = use};
    const char *colon = name ? strchr(name, ':') : NULL;
    if (!name)
        return 0;
    if (colon) {
        snprintf(chip, sizeof(chip), "%.*s", (int)(colon - name), name);
        request.chip = chip;
        request.lines[0] = colon + 1;
    }
    return pel_gpio_open(line, &request, message);
}

static int open_lines(struct pel_bus_linux *bus,
                      const struct pel_bus_request *request)
{
    const char *const names[] = {request->dc, request->reset, request->light};
    struct pel_gpio *const lines[] = {&bus->dc, &bus->reset, &bus->light};
    int error = 0;
    for (int i = 0; i < 3 && !error; i++)
        error = pel_bus_line_open(lines[i], names[i], PEL_GPIO_OUTPUT,
                                  bus->message);
    return error;
}

static int open_device(struct pel_bus_linux *bus,
                       const struct pel_bus_request *request)
{
    const bool spi = request->spi;
    snprintf(bus->path, sizeof(bus->path), "%s",
             spi ? request->spi : request->i2c);
    bus->fd = pel_linux_open(bus->path, O_RDWR);
    if (bus->fd >= 0)
        return spi ? pel_bus_spi_start(bus, request)
                   : pel_bus_i2c_start(bus, request);
    return pel_message_open(
        bus->message, bus->path, errno,
        spi ? "is SPI on? dtparam=spi=on in config.txt of a Pi"
            : "is I2C on? dtparam=i2c_arm=on in config.txt of a "
              "Pi, and modprobe i2c-dev");
}

int pel_bus_linux_open(struct pel_bus_linux *bus,
                       const struct pel_bus_request *request,
                       struct pel_message *message)
{
    memset(bus, 0, sizeof(*bus));
    bus->bus.context = bus;
    bus->bus.pause = bus_pause;
    bus->message = message;
    bus->data = -1;
    bus->fd = -1;
    /* Lines first: a chip whose lines another program has is left alone. */
    int error = open_lines(bus, request);
    if (!error)
        error = open_device(bus, request);
    if (!error)
        error = set_line(bus, &bus->light, true);
    if (error)
        pel_bus_linux_close(bus);
    return error;
}

void pel_bus_linux_close(struct pel_bus_linux *bus)
{
    if (bus->light.request)
        pel_gpio_set(&bus->light, 0, false);
    pel_gpio_close(&bus->light);
    pel_gpio_close(&bus->reset);
    pel_gpio_close(&bus->dc);
    if (bus->bus.context && bus->fd >= 0)
        close(bus->fd);
    bus->fd = -1;
}
