/* Input of a Linux machine whose devices are played here: which places count,
 * what is held when a device opens and after a loss, and what cannot be
 * watched. Linked with --wrap of what is defined below. */
#include "tests/support/check.h"

#include <errno.h>
#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "port/linux/input.h"
#include "tests/device/linux/input_devices.h"

static const struct device *device; /* NULL: there is none */
static const struct step *next;
static int fail_watch; /* the epoll_ctl that fails, from 1 */
static uint32_t levels;
static int line = -1; /* of the buttons */
static bool edges_lost;
static const char *turns; /* of an encoder: its contacts, A * 2 + B */

int __real_epoll_ctl(int poll, int what, int fd, struct epoll_event *event);

int __wrap_access(const char *path, int mode)
{
    (void)mode;
    return device && strcmp(path, "/dev/input/event0") == 0 ? 0 : -1;
}

/* Always readable. */
static int descriptor = -1;
int __wrap_open(const char *path, int flags, ...)
{
    (void)path, (void)flags;
    return descriptor = eventfd(1, EFD_CLOEXEC);
}

int __wrap_epoll_ctl(int poll, int what, int fd, struct epoll_event *event)
{
    errno = ENOSPC;
    return --fail_watch == 0 ? -1 : __real_epoll_ctl(poll, what, fd, event);
}

static void set_value(struct libevdev *d, const struct step *s)
{
    if (s->type >= SLOT)
        libevdev_set_slot_value(d, (unsigned)(s->type - SLOT),
                                (unsigned)s->code, s->value);
    else
        libevdev_set_event_value(d, (unsigned)s->type, (unsigned)s->code,
                                 s->value);
}

int __wrap_libevdev_new_from_fd(int fd, struct libevdev **result)
{
    const struct input_absinfo info = {.maximum = MOST};
    struct libevdev *d = libevdev_new();
    (void)fd;
    for (unsigned i = 0; i <= INPUT_PROP_MAX; i++)
        if (device->properties >> i & 1)
            libevdev_enable_property(d, i);
    for (int i = 0; i < 8 && device->codes[i]; i++)
        if (device->codes[i] & ABS)
            libevdev_enable_event_code(
                d, EV_ABS, (unsigned)(device->codes[i] - ABS), &info);
        else
            libevdev_enable_event_code(d, EV_KEY, (unsigned)device->codes[i],
                                       NULL);
    for (const struct step *s = device->held; s->type; s++)
        set_value(d, s);
    next = device->comes;
    *result = d;
    return 0;
}

int __wrap_libevdev_get_fd(const struct libevdev *d)
{
    (void)d;
    return descriptor;
}

int __wrap_libevdev_set_clock_id(struct libevdev *d, int clock)
{
    (void)d, (void)clock;
    return 0;
}

int __wrap_libevdev_next_event(struct libevdev *d, unsigned flags,
                               struct input_event *e)
{
    if (flags == LIBEVDEV_READ_FLAG_SYNC || (!next->type && !next->value))
        return -EAGAIN;
    *e = (struct input_event){.type = (uint16_t)next->type,
                              .code = (uint16_t)next->code,
                              .value = next->value};
    next++;
    if (e->type == SYNC)
        return LIBEVDEV_READ_STATUS_SYNC;
    if (e->type)
        set_value(d, next - 1);
    return LIBEVDEV_READ_STATUS_SUCCESS;
}

int __wrap_pel_gpio_open(struct pel_gpio *gpio,
                         const struct pel_gpio_request *request,
                         struct pel_message *message)
{
    (void)message;
    memset(gpio, 0, sizeof *gpio);
    gpio->count = request->count;
    line = eventfd(1, EFD_CLOEXEC);
    return 0;
}

void __wrap_pel_gpio_close(struct pel_gpio *gpio)
{
    (void)gpio;
    close(line);
    line = -1;
}

int __wrap_pel_gpio_levels(struct pel_gpio *gpio, uint32_t *active)
{
    (void)gpio;
    *active = levels;
    return 0;
}

int __wrap_pel_gpio_edges(struct pel_gpio *gpio, struct pel_gpio_edge *edges,
                          int most, bool *lost)
{
    int n = 0;
    (void)gpio, (void)most;
    *lost = edges_lost;
    edges_lost = false;
    for (; turns && turns[1]; turns++, n++) {
        const int bit = (turns[0] ^ turns[1]) & 3;
        edges[n] = (struct pel_gpio_edge){.line = bit == 1,
                                          .active = (turns[1] & bit) != 0};
        levels ^= 3u - (uint32_t)bit;
    }
    turns = NULL;
    return n;
}

int __wrap_pel_gpio_descriptors(const struct pel_gpio *gpio,
                                int descriptors[PEL_GPIO_MOST])
{
    (void)gpio;
    descriptors[0] = line;
    return 1;
}

static struct pel_input_linux input;
static char told[2000];
static int side = MOST + 1; /* px */

static void open_input(const struct device *d, const char *buttons, int fails)
{
    const struct pel_input_linux_options options = {
        .buttons = buttons, .width = side, .height = side};
    device = d;
    fail_watch = fails;
    const int error = pel_input_linux_open(&input, &options);
    assert_int_equal(error, buttons && fails ? ENOSPC : 0);
}

/* All that is told, in letters. */
static const char *hear(void)
{
    static const char *const devices_are[] = {"gone ", "here "};
    struct pel_input e;
    size_t n = 0;
    for (told[0] = 0; pel_input_linux_next(&input, &e); n = strlen(told)) {
        char *text = told + n;
        const size_t size = sizeof told - n;
        if (e.kind == PEL_INPUT_LOST)
            snprintf(text, size, "lost ");
        else if (e.kind == PEL_INPUT_DEVICE)
            snprintf(text, size, "%s", devices_are[e.state]);
        else if (e.kind == PEL_INPUT_KEY || e.kind == PEL_INPUT_BUTTON)
            snprintf(text, size, "%c%d,%d ",
                     e.kind == PEL_INPUT_KEY ? 'K' : 'B', e.code, e.state);
        else if (e.kind == PEL_INPUT_WHEEL)
            snprintf(text, size, "W%d ", e.y);
        else if (e.kind == PEL_INPUT_POINT)
            snprintf(text, size, "P(%d,%d) ", e.x, e.y);
        else
            snprintf(text, size, "T%d(%d,%d)%d ", e.code, e.x, e.y, e.state);
    }
    return told;
}

TEST(devices)
{
    for (int i = 0; i < DEVICES; i++) {
        open_input(&devices[i], NULL, 0);
        if (strcmp(hear(), devices[i].told) != 0)
            fail_msg("%s: told %s, expected %s", devices[i].name, told,
                     devices[i].told);
        pel_input_linux_close(&input);
    }
}

/* A touch screen, and a finger at its corner. */
static const struct device touched = {"",
                                      1 << INPUT_PROP_DIRECT,
                                      {BTN_TOUCH, PLACES},
                                      {{0}},
                                      {CORNER, {EV_KEY, BTN_TOUCH, 1}, REPORT},
                                      ""};

/* A finger is where the matrix says, inside of the screen. */
TEST(places_by_a_matrix)
{
    static const struct {
        const char *touch, *told;
    } rows[] = {{"swap", "here T0(100,500)1 "},
                {"invert-x", "here T0(499,100)1 "},
                {"invert-y", "here T0(500,899)1 "},
                {"rotate=90", "here T0(100,499)1 "},
                {"rotate=180", "here T0(499,899)1 "},
                {"rotate=270", "here T0(899,500)1 "},
                {"rotate=90,rotate=270", "here T0(500,100)1 "},
                {"range=0:1:0.2:0.9", "here T0(500,0)1 "},
                {"range=0.25:0.85:0:1", "here T0(417,100)1 "},
                {"range=0:0.4:0:1", "here T0(999,100)1 "}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        setenv("PEL_TOUCH", rows[i].touch, 1);
        open_input(&touched, NULL, 0);
        if (strcmp(hear(), rows[i].told) != 0)
            fail_msg("%s: told %s, expected %s", rows[i].touch, told,
                     rows[i].told);
        pel_input_linux_close(&input);
    }
    unsetenv("PEL_TOUCH");
}

/* A unit of the glass is several pixels: its middle, by a matrix or not. */
TEST(units_larger_than_pixels)
{
    for (int i = 0; i < 2; i++) {
        setenv("PEL_TOUCH", i ? "rotate=0" : "", 1);
        side = 5 * (MOST + 1);
        open_input(&touched, NULL, 0);
        assert_string_equal(hear(), "here T0(2502,502)1 ");
        pel_input_linux_close(&input);
    }
    side = MOST + 1;
    unsetenv("PEL_TOUCH");
}

/* A report that was not complete is not the next device's. */
TEST(steps_of_a_device_that_went)
{
    static const struct device mouse = {
        .codes = {BTN_LEFT},
        .comes = {{EV_REL, REL_X, 5}, {EV_REL, REL_WHEEL, 1}}};
    static const struct device again = {.codes = {BTN_LEFT}, .comes = {REPORT}};
    open_input(&mouse, NULL, 0);
    assert_string_equal(hear(), "here ");
    pel_evdev_close(&input.devices[0]);
    device = &again;
    pel_evdev_open(&input.devices[0], 0, true, &input.queue, &input.message);
    assert_string_equal(hear(), "here ");
    pel_input_linux_close(&input);
}

/* Whatever was lost, a finger and a button that are held are told again. */
TEST(what_is_held_after_a_loss)
{
    const struct pel_input point = {.kind = PEL_INPUT_POINT};
    levels = 1;
    open_input(&devices[0], "gpiochip0:5=a,6=b,debounce=0", 0);
    assert_string_equal(hear(), "here K97,1 here T1(300,200)1 T1(310,200)2 ");
    edges_lost = true;
    assert_string_equal(hear(), "lost K97,1 T1(310,200)1 ");
    while (pel_input_push(&input.queue, &point))
        continue;
    assert_non_null(strstr(hear(), "lost T1(310,200)1 K97,1 "));
    levels = 2;
    assert_string_equal(hear(), "K97,0 K98,1 ");
    pel_input_linux_close(&input);
    levels = 0;
}

/* Back and forth, each click is told, wherever the contacts rest. */
TEST(encoders)
{
    static const struct {
        const char *text, *turns;
        uint32_t levels;
    } rows[] = {{"gpiochip0:17/27=wheel", "02310132023101320", 0},
                {"gpiochip0:17/27=wheel,closed", "31023201310232013", 3}};
    for (int i = 0; i < 2; i++) {
        levels = rows[i].levels;
        open_input(NULL, rows[i].text, 0);
        turns = rows[i].turns;
        assert_string_equal(hear(), "here W1 W-1 W1 W-1 ");
        assert_int_equal(levels, rows[i].levels);
        pel_input_linux_close(&input);
    }
    levels = 0;
}

TEST(what_cannot_be_watched)
{
    open_input(&devices[0], NULL, 3);
    assert_string_equal(hear(), "here T1(300,200)1 gone ");
    assert_non_null(strstr(input.note.text, "cannot wait for input: No space"));
    pel_input_linux_close(&input);
    open_input(NULL, "gpiochip0:5=a", 3);
    assert_non_null(strstr(input.message.text, "cannot wait for input: No"));
    assert_int_equal(line, -1);
}
