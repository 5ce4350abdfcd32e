#include "bus.h"

#include <errno.h>
#include <linux/spi/spidev.h>
#include <stdio.h>
#include <string.h>

#include "../../drivers/linux_io.h"

/* spidev starts each piece at a multiple of the processor's cache lines in its
 * buffer: 128 bytes at most. */
enum { MOST_PIECES = 32, ALIGN = 128, USUAL_BUFSIZ = 4096, SPEED = 32000000 };

/* Pieces of memory that go out in one system call. */
struct message {
    struct spi_ioc_transfer piece[MOST_PIECES];
    unsigned count;
    uint32_t bytes; /* of spidev's buffer */
};

static int send(struct pel_bus_linux *bus, struct message *m)
{
    const unsigned long request =
        _IOC(_IOC_WRITE, SPI_IOC_MAGIC, 0, SPI_MSGSIZE(m->count));
    const bool failed =
        m->count && pel_linux_ioctl(bus->fd, request, m->piece) < 0;
    m->count = m->bytes = 0;
    return failed ? pel_bus_fails(bus, "transfer", errno) : 0;
}

static void add(struct pel_bus_linux *bus, struct message *m,
                const uint8_t *out, uint8_t *in, uint32_t n)
{
    m->piece[m->count++] = (struct spi_ioc_transfer){.tx_buf = (uintptr_t)out,
                                                     .rx_buf = (uintptr_t)in,
                                                     .len = n,
                                                     .speed_hz = bus->speed,
                                                     .bits_per_word = 8};
    m->bytes += (n + ALIGN - 1) / ALIGN * ALIGN;
}

/* A row, cut where a message is full. */
static int add_row(struct pel_bus_linux *bus, struct message *m,
                   const uint8_t *bytes, uint32_t n)
{
    while (n > 0) {
        int error =
            m->count == MOST_PIECES || m->bytes == bus->most ? send(bus, m) : 0;
        if (error)
            return error;
        const uint32_t room = bus->most - m->bytes;
        const uint32_t now = n < room ? n : room;
        add(bus, m, bytes, NULL, now);
        bytes += now;
        n -= now;
    }
    return 0;
}

/* Sets D/C where it is not yet what it has to be. */
static int set_dc(struct pel_bus_linux *bus, int data)
{
    if (!bus->dc.request || bus->data == data)
        return 0;
    const int error = pel_gpio_set(&bus->dc, 0, data);
    bus->data = error ? -1 : data;
    return error ? pel_bus_fails(bus, "its line D/C", error) : 0;
}

static enum pel_status spi_command(const struct pel_bus *pel_bus,
                                   const uint8_t *bytes, size_t n,
                                   uint8_t *answer, size_t answers)
{
    struct pel_bus_linux *bus = pel_bus->context;
    struct message m = {.count = 0};
    if (set_dc(bus, 0))
        return PEL_ERROR_DEVICE;
    add(bus, &m, bytes, NULL, (uint32_t)n);
    if (answers)
        add(bus, &m, NULL, answer, (uint32_t)answers);
    return send(bus, &m) ? PEL_ERROR_DEVICE : PEL_OK;
}

static enum pel_status spi_data(const struct pel_bus *pel_bus,
                                const struct pel_bus_rows *rows)
{
    struct pel_bus_linux *bus = pel_bus->context;
    struct message m = {.count = 0};
    int error = set_dc(bus, 1);
    for (int32_t i = 0; i < rows->count && !error; i++)
        error = add_row(bus, &m, rows->bytes + (ptrdiff_t)i * rows->stride,
                        (uint32_t)rows->length);
    if (!error)
        error = send(bus, &m);
    return error ? PEL_ERROR_DEVICE : PEL_OK;
}

static uint32_t read_bufsiz(void)
{
    unsigned bytes = 0;
    FILE *file = fopen("/sys/module/spidev/parameters/bufsiz", "re");
    if (file) {
        if (fscanf(file, "%u", &bytes) != 1)
            bytes = 0;
        fclose(file);
    }
    return bytes >= ALIGN ? bytes / ALIGN * ALIGN : USUAL_BUFSIZ;
}

int pel_bus_spi_start(struct pel_bus_linux *bus,
                      const struct pel_bus_request *request)
{
    uint8_t mode = request->mode;
    bus->bus.command = spi_command;
    bus->bus.data = spi_data;
    bus->speed = request->speed ? request->speed : SPEED;
    bus->most = read_bufsiz();
    if (pel_linux_ioctl(bus->fd, SPI_IOC_WR_MODE, &mode) == 0)
        return 0;
    if (errno == ENOTTY || (errno == EINVAL && mode == 0))
        return pel_message_set(bus->message, ENOTTY, "%s is no SPI device",
                               bus->path);
    return pel_bus_fails(bus, "mode", errno);
}
