/* A panel on a Linux board whose system calls are played here: what spidev,
 * i2c-dev and the lines get makes the glass show the frame, straight from the
 * frame's memory, in messages that spidev takes; and every call fails once with
 * every errno. */
#include "tests/support/check.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <linux/spi/spidev.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <pel/pel.h>
#include "drivers/display_linux_panel.h"
#include "tests/support/panel_glass.h"
#include "tests/support/paper_glass.h"

enum { BUFSIZ_OF_SPIDEV = 4096, CACHE_LINE = 128, DEVICES = 6, FAILING = 4 };

static struct bus_log wire; /* what went over it */
static struct panel_glass glass;
static struct pel_display_panel panel;
static struct pel_display display;
static struct pel_message message;
static struct paper_glass paper; /* takes what is sent, if `is_paper` */
static bool is_paper;
static int mode_set, lines_open, levels[4]; /* D/C, reset, light, BUSY */
static int calls, fail_at, error_given;
static size_t messages, lines_set, bytes_sent, bytes_copied;

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

#define ST7789 .family = PANEL_DCS, .columns = 240, .rows = 320
#define OLED                                                                  \
    .family = PANEL_PAGES, .columns = 128, .rows = 64, .columns_backward = 1, \
    .rows_backward = 1

/* Each with the size of the display and its glass; the first is 240x240. */
static const struct {
    const char *name;
    int size[2];
    struct panel_glass glass;
} devices[DEVICES] = {
    {"st7789,spi=/dev/spidev0.0,speed=40M,size=240x240,dc=GPIO25,"
     "reset=gpiochip0:27,light=GPIO18",
     {240, 240},
     {ST7789}},
    {"st7789,spi=/dev/spidev0.0,speed=40000000,size=135x240,rotation=90,"
     "mode=3,dc=GPIO25,brightness=200",
     {240, 135},
     {ST7789, .left = 52, .top = 40}},
    {"ssd1306,i2c=/dev/i2c-1,address=0x3d", {128, 64}, {OLED}},
    {"ssd1306,i2c=/dev/i2c-1,address=61,size=128x32,rotation=270,inverted",
     {32, 128},
     {OLED}},
    {"ili9488,spi=/dev/spidev0.0,speed=40M,mode=3,dc=GPIO25,rotation=180",
     {320, 480},
     {.family = PANEL_DCS,
      .columns = 320,
      .rows = 480,
      .columns_backward = true}},
    {"st7735,spi=/dev/spidev0.0,speed=40M,mode=3,dc=GPIO25,size=80x160,"
     "rotation=270",
     {160, 80},
     {.family = PANEL_DCS,
      .columns = 132,
      .rows = 162,
      .columns_backward = true,
      .rows_backward = true,
      .left = 26,
      .top = 1}},
};

static int open_device(int i)
{
    struct pel_panel_request request;
    wire.count = 0;
    calls = lines_open = 0;
    messages = lines_set = bytes_sent = bytes_copied = 0;
    message.text[0] = 0;
    assert_int_equal(pel_panel_parse(&request, devices[i].name, &message), 0);
    const int error = pel_display_panel_open(&panel, &request, &message);
    assert_int_equal(wire.count, 0);
    return error ? error : pel_display_panel_start(&display, &panel, &request);
}

/* A frame of noise, or a part of it; NULL: all. */
static enum pel_status flush(const struct pel_rect *part)
{
    const struct pel_rect whole = {0, 0, display.width, display.height};
    struct pel_surface s;
    part = part ? part : &whole;
    assert_int_equal(pel_display_begin(&display, part, &s), PEL_OK);
    uint8_t *bytes = s.pixels;
    const int32_t n = display.width * display.height * display.format->bits / 8;
    for (int32_t i = 0; i < n; i++)
        bytes[i] = (uint8_t)rand();
    return pel_display_flush(&display, &s);
}

static void look(int i)
{
    glass = devices[i].glass;
    panel_glass_reset(&glass);
    panel_glass_take(&glass, &wire, 0);
}

static void check_glass(int i)
{
    int at[2];
    look(i);
    assert_true(glass.on && glass.awake);
    if (!panel_glass_shows(&glass, &panel.frame, panel.panel.rotation, at))
        fail_msg("%s: pixel %d, %d", devices[i].name, at[0], at[1]);
}

TEST(frames)
{
    for (int i = 0; i < DEVICES; i++) {
        assert_int_equal(open_device(i), 0);
        assert_int_equal(display.width, devices[i].size[0]);
        assert_int_equal(display.height, devices[i].size[1]);
        assert_int_equal(levels[2], i == 0);
        assert_int_equal(mode_set, i == 0 ? 0 : 3);
        assert_int_equal(flush(NULL), PEL_OK);
        check_glass(i);
        pel_display_panel_close(&panel);
        assert_int_equal(lines_open, 0);
        assert_int_equal(levels[2], 0);
    }
}

/* What a 240x240 frame, and a window of 10x100, cost. */
TEST(system_calls)
{
    const struct pel_rect part = {7, 50, 17, 150};
    assert_int_equal(open_device(0), 0);
    messages = lines_set = bytes_sent = 0;
    assert_int_equal(flush(NULL), PEL_OK);
    assert_int_equal(bytes_sent, 240 * 240 * 2 + 11);
    assert_int_equal(messages, 5 + (240 * 240 * 2 + 4095) / 4096);
    assert_int_equal(lines_set, 5);
    assert_int_equal(bytes_copied, 0);
    messages = 0;
    assert_int_equal(flush(&part), PEL_OK);
    assert_int_equal(messages, 5 + (100 + 31) / 32);
    assert_int_equal(bytes_copied, 0);
    pel_display_panel_close(&panel);
}

/* Another one where a file was left open. */
static int next_descriptor(void)
{
    const int next = dup(0);
    close(next);
    return next;
}

TEST(every_call_that_fails)
{
    static const int errors[] = {EIO,    EINVAL,   ENODEV,    EBUSY,
                                 EACCES, ENOENT,   ENXIO,     EREMOTEIO,
                                 ENOMEM, EMSGSIZE, ETIMEDOUT, ESHUTDOWN,
                                 ENOTTY, EINTR,    EAGAIN};
    const int files = next_descriptor();
    for (size_t k = 0; k < FAILING * sizeof errors / sizeof *errors; k++) {
        const int i = (int)k % FAILING;
        error_given = errors[k / FAILING];
        calls = fail_at = 0;
        do {
            fail_at++;
            int error = open_device(i);
            const bool refused = error;
            if (!error)
                error = flush(NULL);
            const bool failed = calls >= fail_at;
            const bool told = message.text[0];
            pel_display_panel_close(&panel);
            look(i); /* whatever it was told, it is dark */
            assert_false(refused && (glass.on || glass.awake));
            if (error_given != EINTR)
                assert_int_equal(failed, error != 0);
            assert_int_equal(error != 0, told);
            assert_int_equal(lines_open, 0);
            assert_int_equal(next_descriptor(), files);
        } while (calls >= fail_at);
    }
    fail_at = 0;
}

/* A second program is refused before it has changed anything. */
TEST(chips_of_others)
{
    mode_set = -1;
    fail_at = 1; /* the line D/C */
    error_given = EBUSY;
    assert_int_equal(open_device(1), EBUSY);
    assert_int_equal(calls, 1);
    fail_at = 3; /* the lock */
    error_given = EAGAIN;
    assert_int_equal(open_device(2), EAGAIN);
    assert_non_null(strstr(message.text, "another program has the chip at"));
    assert_int_equal(calls, 3);
    assert_int_equal(mode_set, -1);
    fail_at = 0;
}

TEST(i2c_of_other_chips)
{
    static const uint8_t bytes[129];
    const struct pel_bus_request request = {
        .i2c = "/dev/i2c-1", .address = 0x3D, .plain = true};
    struct pel_bus_linux bus;
    assert_int_equal(pel_bus_linux_open(&bus, &request, &message), 0);
    assert_null(bus.bus.data);
    assert_int_equal(bus.bus.command(&bus.bus, bytes, 129, NULL, 0),
                     PEL_ERROR_SIZE);
    assert_non_null(strstr(message.text, "more than 128 bytes"));
    pel_bus_linux_close(&bus);
}

TEST(glass_that_is_refused)
{
    struct pel_panel_request request;
    static const char *const names[][2] = {
        {"st7789,spi=/dev/a,dc=GPIO25,size=241x10", "beyond the memory"},
        {"ssd1306,i2c=/dev/a,address=61,size=128x60", "multiples of 8 rows"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        wire.count = 0;
        assert_int_equal(pel_panel_parse(&request, names[i][0], &message), 0);
        assert_int_equal(pel_display_panel_open(&panel, &request, &message), 0);
        assert_int_equal(pel_display_panel_start(&display, &panel, &request),
                         EINVAL);
        assert_non_null(strstr(message.text, names[i][1]));
        pel_display_panel_close(&panel);
        assert_int_equal(wire.count, 0);
    }
}

/* E-paper, with the size of the glass. */
static const struct {
    const char *name;
    enum paper_family family;
    int size[2];
    bool color, gray;
} papers[] = {
    {"ssd1680", PAPER_SSD, {122, 250}, false, false},
    {"ssd1680_gray2", PAPER_SSD, {122, 250}, false, true},
    {"ssd1681_inks2", PAPER_SSD, {200, 200}, true, false},
    {"uc8151_gray2", PAPER_UC8151, {128, 296}, false, true},
    {"uc8179", PAPER_UC8179, {800, 480}, false, false},
};
enum { PAPERS = sizeof papers / sizeof *papers };

static bool is_mono(int i)
{
    return !papers[i].color && !papers[i].gray;
}

static int open_paper(int i)
{
    struct pel_panel_request request;
    char name[160];
    paper.family = papers[i].family;
    paper.width = papers[i].size[0];
    paper.height = papers[i].size[1];
    paper.color = papers[i].color;
    paper.gray = papers[i].gray;
    paper_glass_init(&paper);
    is_paper = true;
    calls = lines_open = 0;
    message.text[0] = 0;
    snprintf(name, sizeof name,
             "%s,spi=/dev/spidev0.0,speed=4M,dc=GPIO25,reset=gpiochip0:27,"
             "busy=GPIO24%s",
             papers[i].name, is_mono(i) ? ",partial" : "");
    assert_int_equal(pel_panel_parse(&request, name, &message), 0);
    const int error = pel_display_panel_open(&panel, &request, &message);
    return error ? error : pel_display_panel_start(&display, &panel, &request);
}

static void close_paper(void)
{
    pel_display_panel_close(&panel);
    assert_int_equal(lines_open, 0);
    is_paper = false;
}

/* The whole of it black, or white. */
static enum pel_status show(bool white)
{
    const struct pel_rect whole = {0, 0, display.width, display.height};
    struct pel_surface s;
    assert_int_equal(pel_display_begin(&display, &whole, &s), PEL_OK);
    pel_clear(&s, white ? PEL_RGB(255, 255, 255) : PEL_RGB(0, 0, 0));
    enum pel_status status = pel_display_flush(&display, &s);
    return status == PEL_OK ? pel_display_flip(&display) : status;
}

TEST(paper_shows_frames)
{
    for (int i = 0; i < PAPERS; i++) {
        const int later = is_mono(i) ? PEL_EPAPER_PARTIAL : PEL_EPAPER_FULL;
        assert_int_equal(open_paper(i), 0);
        assert_int_equal(display.width, papers[i].size[0]);
        for (int n = 0; n < 4; n++) {
            assert_int_equal(show(n % 2), PEL_OK);
            assert_int_equal(paper.refreshes, n + 1);
            assert_int_equal(panel.paper.refresh, later);
            const int shown = n % 2            ? paper.white
                              : papers[i].gray ? PAPER_GRAY
                                               : PAPER_BLACK;
            for (int k = 0; k < paper.width * paper.height; k++)
                assert_int_equal(paper.shown[k], shown);
        }
        close_paper();
        assert_true(paper.asleep);
    }
}

/* A line BUSY that is another one, and calls that fail. */
TEST(paper_that_stays_busy)
{
    assert_int_equal(open_paper(0), 0);
    assert_int_equal(show(true), PEL_OK);
    paper.stuck = true;
    paper.ms = 0;
    assert_int_equal(show(false), PEL_ERROR_DEVICE);
    assert_in_range(paper.ms, 60000, 61000);
    assert_non_null(strstr(message.text, "busy for a minute"));
    close_paper();
    paper.stuck = false;
}

TEST(paper_and_every_call_that_fails)
{
    const int files = next_descriptor();
    error_given = EIO;
    for (int i = 0; i < 2; i++) {
        bool over = false;
        for (int n = 1; !over; n++) {
            fail_at = n;
            int error = open_paper(i);
            if (!error)
                error = show(false);
            if (!error)
                error = show(true);
            over = calls < fail_at;
            if (over != (error == 0))
                fail_msg("%s: call %d", papers[i].name, n);
            assert_int_equal(error != 0, message.text[0] != 0);
            fail_at = 0;
            paper.busy = 0;
            close_paper();
            assert_int_equal(next_descriptor(), files);
        }
    }
}

TEST(paper_that_is_refused)
{
    static const char *const names[][2] = {
        {"ssd1680,spi=/dev/a,dc=GPIO25", "busy=LINE"},
        {"ssd1680,spi=/dev/a,dc=GPIO25,busy=GPIO24,inverted", "e-paper"},
        {"ssd1680_gray2,spi=/dev/a,dc=GPIO25,busy=GPIO24,partial", "black"},
        {"ssd1680,spi=/dev/a,dc=GPIO25,busy=GPIO24,size=9999x9", "memory"},
        {"ssd1234,spi=/dev/a,dc=GPIO25", "uc8179_gray2"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        struct pel_panel_request request;
        calls = 0;
        assert_int_equal(pel_panel_parse(&request, names[i][0], &message), 0);
        int error = pel_display_panel_open(&panel, &request, &message);
        if (!error)
            error = pel_display_panel_start(&display, &panel, &request);
        assert_int_equal(error, EINVAL);
        assert_non_null(strstr(message.text, names[i][1]));
        pel_display_panel_close(&panel);
    }
}
