#include "panel_calls.h"

#include "tests/support/check.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <linux/spi/spidev.h>
#include <stdarg.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <pel/pel.h>

enum { BUFSIZ_OF_SPIDEV = 4096, CACHE_LINE = 128 };

struct bus_log wire;
struct pel_display_panel panel;
struct pel_display display;
struct pel_message message;
struct paper_glass paper;
bool is_paper;
int mode_set, lines_open, levels[4];
int calls, fail_at, error_given;
size_t messages, lines_set, bytes_sent, bytes_copied;

int next_descriptor(void)
{
    const int next = dup(0);
    close(next);
    return next;
}

static int fails(void)
{
    if (++calls != fail_at)
        return 0;
    errno = error_given;
    return 1;
}

static void note(int kind, const uint8_t *bytes, size_t n)
{
    const struct pel_bus_rows rows = {bytes, (int32_t)n, 1, 0};
    if (is_paper) {
        const enum pel_status status =
            kind ? paper.bus.data(&paper.bus, &rows)
                 : paper.bus.command(&paper.bus, bytes, n, NULL, 0);
        assert_int_equal(status, PEL_OK);
        return;
    }
    for (size_t i = 0; i < n; i++)
        wire.log[wire.count++] = (uint16_t)(kind | bytes[i]);
    bytes_sent += n;
}

static bool in_frame(const uint8_t *bytes)
{
    const uint8_t *pixels = panel.frame.pixels;
    return pixels && bytes >= pixels &&
           bytes < pixels + (size_t)display.width * (size_t)display.height * 3;
}

static void take_spi(const struct spi_ioc_transfer *t, size_t n)
{
    size_t in_buffer = 0;
    for (size_t i = 0; i < n; i++) {
        const uint8_t *bytes = (const uint8_t *)(uintptr_t)t[i].tx_buf;
        in_buffer += (t[i].len + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
        bytes_copied += t[i].len > 16 && !in_frame(bytes) ? t[i].len : 0;
        note(levels[0] ? BUS_LOG_DATA : 0, bytes, t[i].len);
        assert_int_equal(t[i].speed_hz, is_paper ? 4000000 : 40000000);
    }
    assert_true(in_buffer <= BUFSIZ_OF_SPIDEV);
    messages++;
}

static void take_i2c(const struct i2c_rdwr_ioctl_data *data)
{
    assert_int_equal(data->nmsgs, 1);
    assert_int_equal(data->msgs->addr, 0x3D);
    note(data->msgs->buf[0] == 0x40 ? BUS_LOG_DATA : 0, data->msgs->buf + 1,
         (size_t)data->msgs->len - 1);
    assert_int_equal(data->msgs->buf[0] & ~0x40, 0);
    messages++;
}

int __real_open(const char *path, int flags, ...);

int __wrap_nanosleep(const struct timespec *time, struct timespec *left)
{
    (void)left;
    paper.ms += (uint32_t)time->tv_nsec / 1000000;
    return 0;
}

/* The lock of a chip of I2C. */
int __wrap_fcntl(int fd, int what, ...)
{
    va_list arguments;
    va_start(arguments, what);
    const struct flock *lock = va_arg(arguments, struct flock *);
    va_end(arguments);
    (void)fd;
    assert_int_equal(lock->l_start, 0x3D);
    return fails() ? -1 : 0;
}

int __wrap_ioctl(int fd, unsigned long request, ...)
{
    va_list arguments;
    va_start(arguments, request);
    void *argument = va_arg(arguments, void *);
    va_end(arguments);
    (void)fd;
    if (fails())
        return -1;
    if (request == I2C_RDWR)
        take_i2c(argument);
    else if (request == SPI_IOC_WR_MODE)
        mode_set = *(uint8_t *)argument;
    else if (_IOC_TYPE(request) == SPI_IOC_MAGIC && _IOC_NR(request) == 0)
        take_spi(argument, _IOC_SIZE(request) / SPI_MSGSIZE(1));
    return 0;
}

int __wrap_open(const char *path, int flags, ...)
{
    const bool device = strncmp(path, "/dev/", 5) == 0;
    if (device && fails())
        return -1;
    return __real_open(device ? "/dev/null" : path, flags);
}

int __wrap_pel_gpio_open(struct pel_gpio *gpio,
                         const struct pel_gpio_request *request,
                         struct pel_message *m)
{
    static const char *const names[] = {"GPIO25", "27", "GPIO18", "GPIO24"};
    memset(gpio, 0, sizeof *gpio);
    if (fails())
        return pel_message_errno(m, request->lines[0]);
    for (int i = 0; i < 4; i++)
        if (strcmp(names[i], request->lines[0]) == 0)
            gpio->request = &levels[i];
    assert_non_null(gpio->request);
    assert_true((gpio->request == &levels[1]) == (request->chip != NULL));
    assert_int_equal(request->use, gpio->request == &levels[3]
                                       ? PEL_GPIO_FLOATING
                                       : PEL_GPIO_OUTPUT);
    lines_open++;
    return 0;
}

void __wrap_pel_gpio_close(struct pel_gpio *gpio)
{
    lines_open -= gpio->request != NULL;
    gpio->request = NULL;
}

int __wrap_pel_gpio_set(struct pel_gpio *gpio, int line, bool active)
{
    int *level = gpio->request;
    assert_int_equal(line, 0);
    if (fails())
        return errno;
    if (level == &levels[1] && !active && !is_paper)
        wire.log[wire.count++] = BUS_LOG_RESET;
    if (level == &levels[1] && !active && is_paper)
        paper.bus.pause(&paper.bus, true, 0);
    *level = active;
    lines_set++;
    return 0;
}

/* Lines that float are active when low. */
int __wrap_pel_gpio_levels(struct pel_gpio *gpio, uint32_t *active)
{
    assert_ptr_equal(gpio->request, &levels[3]);
    if (fails())
        return errno;
    *active = !paper_glass_busy(&paper);
    return 0;
}
