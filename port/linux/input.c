#include "input.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/inotify.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include "../../drivers/linux_io.h"

static int watch(struct pel_input_linux *in, int fd)
{
    struct epoll_event e = {.events = EPOLLIN};
    if (fd >= 0 && epoll_ctl(in->poll, EPOLL_CTL_ADD, fd, &e) == 0)
        return 0;
    return pel_message_errno(&in->message, "cannot wait for input");
}

/* Opens /dev/input/eventN, if that is not open. Rights may come later than the
 * device, and then it is tried again. */
static void open_device(struct pel_input_linux *in, int number)
{
    struct pel_evdev *free = NULL;
    for (int i = PEL_INPUT_LINUX_DEVICES - 1; i >= 0; i--)
        if (!in->devices[i].device)
            free = &in->devices[i];
        else if (in->devices[i].number == number)
            return;
    if (!free) {
        pel_message_set(&in->note, 0,
                        "more than %d input devices: eventN with "
                        "N = %d is left out",
                        PEL_INPUT_LINUX_DEVICES, number);
        return;
    }
    free->width = in->options.width;
    free->height = in->options.height;
    free->matrix = in->has_matrix ? &in->matrix : NULL;
    int error;
    do
        error = pel_evdev_open(free, number, !in->options.no_keys, &in->queue,
                               &in->message);
    while (error == EINTR);
    if (!error) {
        error = watch(in, pel_evdev_descriptor(free));
        if (error) {
            pel_evdev_close(free);
            pel_input_push_now(&in->queue, PEL_INPUT_DEVICE, PEL_INPUT_UP,
                               number);
        }
    }
    if (error && error != ENOENT && error != ENODEV && error != ENOTSUP)
        in->note = in->message;
}

static void open_devices(struct pel_input_linux *in)
{
    char path[40];
    if (in->options.no_devices)
        return;
    inotify_add_watch(in->notify, "/dev/input", IN_CREATE | IN_ATTRIB);
    for (int i = 0; i < 64; i++) {
        snprintf(path, sizeof(path), "/dev/input/event%d", i);
        if (access(path, F_OK) == 0)
            open_device(in, i);
    }
}

static void arm(struct pel_input_linux *in, int milliseconds)
{
    struct itimerspec time = {{0, 0}, {0, 0}};
    if (milliseconds >= 0) {
        time.it_value.tv_sec = milliseconds / 1000;
        time.it_value.tv_nsec = milliseconds % 1000 * 1000000L + 1;
    }
    timerfd_settime(in->timer, 0, &time, NULL);
}

static void read_buttons(struct pel_input_linux *in)
{
    const bool open = in->buttons.open;
    arm(in, pel_buttons_read(&in->buttons, &in->queue));
    if (open && !in->buttons.open)
        pel_input_push_now(&in->queue, PEL_INPUT_DEVICE, PEL_INPUT_UP,
                           PEL_INPUT_LINUX_CHIP);
}

static int open_buttons(struct pel_input_linux *in)
{
    int descriptors[PEL_GPIO_MOST];
    int error = pel_buttons_open(&in->buttons, &in->message);
    if (error)
        return error;
    const int n = pel_gpio_descriptors(&in->buttons.gpio, descriptors);
    for (int i = 0; i < n && !error; i++)
        error = watch(in, descriptors[i]);
    if (error) {
        pel_buttons_close(&in->buttons);
        return error;
    }
    pel_input_push_now(&in->queue, PEL_INPUT_DEVICE, PEL_INPUT_DOWN,
                       PEL_INPUT_LINUX_CHIP);
    read_buttons(in);
    return 0;
}

/* Something came to /dev or /dev/input, went, or got other rights. */
static void note_file(struct pel_input_linux *in, const char *name)
{
    int number;
    if (strcmp(name, "input") == 0)
        open_devices(in);
    else if (sscanf(name, "event%d", &number) == 1)
        open_device(in, number);
    else if (in->options.buttons && !in->buttons.open &&
             strncmp(name, "gpiochip", 8) == 0)
        open_buttons(in);
}

static void read_notes(struct pel_input_linux *in)
{
    char notes[4096] __attribute__((aligned(8)));
    const ssize_t n = read(in->notify, notes, sizeof(notes));
    for (ssize_t at = 0; at < n;) {
        const struct inotify_event *e = (const void *)(notes + at);
        at += (ssize_t)(sizeof(*e) + e->len);
        if (e->mask & IN_Q_OVERFLOW)
            open_devices(in);
        else if (e->len > 0)
            note_file(in, e->name);
    }
}

/* Of what has nothing new this is a system call each: who polls wakes for what
 * is readable, and reads it all. */
static void read_all(struct pel_input_linux *in)
{
    read_notes(in);
    for (int i = 0; i < PEL_INPUT_LINUX_DEVICES; i++)
        if (in->devices[i].device)
            pel_evdev_read(&in->devices[i], &in->queue);
    if (in->buttons.open)
        read_buttons(in);
}

bool pel_input_linux_next(struct pel_input_linux *in, struct pel_input *event)
{
    if (pel_input_pop(&in->queue, event))
        return true;
    read_all(in);
    return pel_input_pop(&in->queue, event);
}

bool pel_input_linux_wait(struct pel_input_linux *in, int milliseconds,
                          struct pel_input *event)
{
    struct pollfd line = {.fd = in->poll, .events = POLLIN};
    const uint32_t start = pel_linux_milliseconds();
    while (!pel_input_linux_next(in, event)) {
        const uint32_t passed = pel_linux_milliseconds() - start;
        if (milliseconds >= 0 && passed >= (uint32_t)milliseconds)
            return false;
        if (poll(&line, 1, milliseconds < 0 ? -1 : milliseconds - (int)passed) <
            0)
            return false;
    }
    return true;
}

/* The descriptors. 0 or an errno, with the message. */
static int prepare(struct pel_input_linux *in)
{
    in->poll = epoll_create1(EPOLL_CLOEXEC);
    if (in->poll < 0)
        return pel_message_errno(&in->message, "cannot wait for input");
    in->notify = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    const int error = watch(in, in->notify);
    if (error)
        return error;
    in->timer = timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK);
    return watch(in, in->timer);
}

static int parse_touch(struct pel_input_linux *in)
{
    const char *text = in->options.touch;
    if (!text)
        text = getenv("PEL_TOUCH");
    in->has_matrix = text && text[0];
    return in->has_matrix
               ? pel_touch_matrix_parse(&in->matrix, text, &in->message)
               : 0;
}

int pel_input_linux_open(struct pel_input_linux *in,
                         const struct pel_input_linux_options *options)
{
    memset(in, 0, sizeof(*in));
    in->queue.events = in->events;
    in->queue.size = PEL_INPUT_LINUX_EVENTS;
    in->options = *options;
    in->poll = in->notify = in->timer = -1;
    int error = prepare(in);
    inotify_add_watch(in->notify, "/dev", IN_CREATE | IN_ATTRIB | IN_DELETE);
    if (!error)
        error = parse_touch(in);
    if (!error && options->buttons)
        error = pel_buttons_parse(&in->buttons, options->buttons, &in->message);
    if (!error && options->buttons)
        error = open_buttons(in);
    if (error)
        pel_input_linux_close(in);
    else
        open_devices(in);
    return error;
}

void pel_input_linux_close(struct pel_input_linux *in)
{
    const int descriptors[] = {in->timer, in->notify, in->poll};
    if (in->queue.size == 0)
        return;
    pel_buttons_close(&in->buttons);
    for (int i = 0; i < PEL_INPUT_LINUX_DEVICES; i++)
        pel_evdev_close(&in->devices[i]);
    for (int i = 0; i < 3; i++)
        if (descriptors[i] >= 0)
            close(descriptors[i]);
    in->queue.size = 0;
}
