#include "evdev.h"

#include <errno.h>
#include <libevdev/libevdev.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "../../drivers/linux_io.h"
#include "evdev_keys.h"

static uint32_t time_of(const struct input_event *e)
{
    return (uint32_t)((uint64_t)e->input_event_sec * 1000 +
                      (uint64_t)e->input_event_usec / 1000);
}

static bool is_button(int code)
{
    return code >= BTN_MOUSE && code < BTN_JOYSTICK;
}

/* Contacts of fingers and pens, which places tell. */
static bool is_contact(int code)
{
    return code >= BTN_DIGI && code < BTN_WHEEL;
}

static void push_key(const struct pel_evdev *evdev, int code, int state,
                     uint32_t time, struct pel_input_queue *queue)
{
    /* Left, right and middle are the first three of the kernel. */
    static const uint16_t buttons[] = {1, 3, 2};
    struct pel_input e = {
        .time = time, .kind = PEL_INPUT_KEY, .state = (uint8_t)state};
    if (is_contact(code))
        return;
    if (is_button(code)) {
        const int i = code - BTN_MOUSE;
        e.kind = PEL_INPUT_BUTTON;
        e.code = i < 3 ? buttons[i] : (uint16_t)(i + 1);
    } else if (evdev->keys) {
        e.code = pel_evdev_key(code);
    } else {
        return;
    }
    pel_input_push(queue, &e);
}

static void push_place(struct pel_evdev *evdev, int i, uint32_t time,
                       struct pel_input_queue *queue)
{
    const bool down = evdev->finger[i].down, told = evdev->finger[i].told;
    const struct pel_input e = {.time = time,
                                .kind = evdev->touches ? PEL_INPUT_TOUCH
                                                       : PEL_INPUT_POINT,
                                .state = !evdev->touches || !down ? PEL_INPUT_UP
                                         : told ? PEL_INPUT_AGAIN
                                                : PEL_INPUT_DOWN,
                                .code = (uint16_t)i,
                                .x = evdev->finger[i].x,
                                .y = evdev->finger[i].y};
    if (!evdev->touches || down || told)
        pel_input_push(queue, &e);
    evdev->finger[i].told = down;
    evdev->finger[i].changed = false;
}

static void push_steps(struct pel_input_queue *queue, int kind, uint32_t time,
                       int16_t *x, int16_t *y)
{
    const struct pel_input e = {
        .time = time, .kind = (uint8_t)kind, .x = *x, .y = *y};
    if (*x || *y)
        pel_input_push(queue, &e);
    *x = *y = 0;
}

/* All that a report said of places and steps. */
static void push_report(struct pel_evdev *evdev, uint32_t time,
                        struct pel_input_queue *queue)
{
    for (int i = 0; i < PEL_EVDEV_FINGERS; i++)
        if (evdev->finger[i].changed)
            push_place(evdev, i, time, queue);
    push_steps(queue, PEL_INPUT_MOVE, time, &evdev->move_x, &evdev->move_y);
    push_steps(queue, PEL_INPUT_WHEEL, time, &evdev->wheel_x, &evdev->wheel_y);
}

static int16_t add(int sum, int value)
{
    sum += value;
    return (int16_t)(sum > INT16_MAX   ? INT16_MAX
                     : sum < INT16_MIN ? INT16_MIN
                                       : sum);
}

static void note_step(struct pel_evdev *evdev, int code, int value)
{
    if (code == REL_X)
        evdev->move_x = add(evdev->move_x, value);
    else if (code == REL_Y)
        evdev->move_y = add(evdev->move_y, value);
    else if (code == REL_HWHEEL)
        evdev->wheel_x = add(evdev->wheel_x, value);
    else if (code == REL_WHEEL)
        evdev->wheel_y = add(evdev->wheel_y, value);
}

/* A value of the axis as a pixel. */
static int16_t scale(const struct pel_evdev *evdev, unsigned axis, int value,
                     int size)
{
    const struct input_absinfo *info =
        libevdev_get_abs_info(evdev->device, axis);
    const int64_t range = (int64_t)info->maximum - info->minimum;
    const int64_t at = (int64_t)value - info->minimum;
    const int64_t px = range > 0 ? at * size / (range + 1) : 0;
    return (int16_t)(px < 0 ? 0 : px < size ? px : size - 1);
}

static void note_place(struct pel_evdev *evdev, unsigned code, int value)
{
    const bool many =
        libevdev_has_event_code(evdev->device, EV_ABS, ABS_MT_POSITION_X);
    if (code == ABS_MT_SLOT)
        evdev->slot = value;
    const int i = many ? evdev->slot : 0;
    if (i < 0 || i >= PEL_EVDEV_FINGERS)
        return;
    if (code == (many ? ABS_MT_POSITION_X : ABS_X))
        evdev->finger[i].x = scale(evdev, code, value, evdev->width);
    else if (code == (many ? ABS_MT_POSITION_Y : ABS_Y))
        evdev->finger[i].y = scale(evdev, code, value, evdev->height);
    else if (many && code == ABS_MT_TRACKING_ID)
        evdev->finger[i].down = value >= 0;
    else
        return;
    evdev->finger[i].changed = true;
}

static void handle(struct pel_evdev *evdev, const struct input_event *e,
                   struct pel_input_queue *queue)
{
    if (e->type == EV_ABS) {
        note_place(evdev, e->code, e->value);
    } else if (e->type == EV_REL) {
        note_step(evdev, e->code, e->value);
    } else if (e->type == EV_SYN && e->code == SYN_REPORT) {
        push_report(evdev, time_of(e), queue);
    } else if (e->type == EV_KEY && e->code == BTN_TOUCH &&
               libevdev_get_num_slots(evdev->device) < 0) {
        evdev->finger[0].down = e->value > 0;
        evdev->finger[0].changed = evdev->touches;
    } else if (e->type == EV_KEY) {
        push_key(evdev, e->code, e->value, time_of(e), queue);
    }
}

/* Presses or releases all that is held. */
static void push_held(struct pel_evdev *evdev, int state, uint32_t time,
                      struct pel_input_queue *queue)
{
    for (unsigned code = 0; code < KEY_MAX; code++)
        if (libevdev_get_event_value(evdev->device, EV_KEY, code))
            push_key(evdev, (int)code, state, time, queue);
    for (int i = 0; i < PEL_EVDEV_FINGERS && evdev->touches; i++) {
        evdev->finger[i].told = state == PEL_INPUT_UP && evdev->finger[i].down;
        evdev->finger[i].down =
            state == PEL_INPUT_DOWN && evdev->finger[i].down;
        push_place(evdev, i, time, queue);
    }
}

/* The kernel's own queue ran over: libevdev asks for the state of all things,
 * which is taken in without a word. */
static int resync(struct pel_evdev *evdev, struct pel_input_queue *queue)
{
    struct pel_input_queue nowhere = {0};
    struct pel_input places[3];
    struct input_event e;
    const struct pel_input lost = {.time = pel_linux_milliseconds(),
                                   .kind = PEL_INPUT_LOST};
    int status;
    nowhere.events = places;
    nowhere.size = 3;
    do {
        status =
            libevdev_next_event(evdev->device, LIBEVDEV_READ_FLAG_SYNC, &e);
        if (status == LIBEVDEV_READ_STATUS_SYNC)
            handle(evdev, &e, &nowhere);
    } while (status == LIBEVDEV_READ_STATUS_SYNC);
    pel_input_push(queue, &lost);
    push_held(evdev, PEL_INPUT_DOWN, lost.time, queue);
    return status == -EAGAIN ? 0 : status;
}

static void push_device(const struct pel_evdev *evdev, int state,
                        struct pel_input_queue *queue)
{
    const struct pel_input e = {.time = pel_linux_milliseconds(),
                                .kind = PEL_INPUT_DEVICE,
                                .state = (uint8_t)state,
                                .code = (uint16_t)evdev->number};
    pel_input_push(queue, &e);
}

/* Room for what one report may push. */
enum { ROOM = PEL_EVDEV_FINGERS + 4 };

bool pel_evdev_read(struct pel_evdev *evdev, struct pel_input_queue *queue)
{
    struct input_event e;
    int status = 0;
    while (status >= 0) {
        evdev->more = pel_input_room(queue) < ROOM;
        if (evdev->more)
            return true;
        status =
            libevdev_next_event(evdev->device, LIBEVDEV_READ_FLAG_NORMAL, &e);
        if (status == LIBEVDEV_READ_STATUS_SUCCESS)
            handle(evdev, &e, queue);
        else if (status == LIBEVDEV_READ_STATUS_SYNC)
            status = resync(evdev, queue);
    }
    if (status == -EAGAIN || status == -EINTR)
        return true;
    push_held(evdev, PEL_INPUT_UP, pel_linux_milliseconds(), queue);
    push_device(evdev, PEL_INPUT_UP, queue);
    pel_evdev_close(evdev);
    return false;
}

static bool tells_something(const struct pel_evdev *evdev)
{
    const struct libevdev *d = evdev->device;
    return libevdev_has_event_type(d, EV_REL) ||
           libevdev_has_event_code(d, EV_ABS, ABS_X) ||
           (evdev->keys && libevdev_has_event_type(d, EV_KEY));
}

int pel_evdev_open(struct pel_evdev *evdev, int number, bool keys,
                   struct pel_input_queue *queue, struct pel_message *message)
{
    char path[40];
    snprintf(path, sizeof(path), "/dev/input/event%d", number);
    const int fd = pel_linux_open(path, O_RDONLY | O_NONBLOCK);
    int error = errno;
    evdev->device = NULL;
    evdev->number = number;
    evdev->keys = keys;
    evdev->slot = 0;
    evdev->more = false;
    memset(evdev->finger, 0, sizeof(evdev->finger));
    if (fd < 0) {
        pel_message_open(message, path, error, "it is gone");
        return error;
    }
    error = -libevdev_new_from_fd(fd, &evdev->device);
    if (error) {
        close(fd);
        evdev->device = NULL;
        pel_message_errno(message, path, error);
        return error;
    }
    libevdev_set_clock_id(evdev->device, CLOCK_MONOTONIC);
    if (!tells_something(evdev)) {
        pel_evdev_close(evdev);
        pel_message_set(message, "%s has no keys, and points nowhere", path);
        return ENOTSUP;
    }
    evdev->touches =
        libevdev_has_event_code(evdev->device, EV_KEY, BTN_TOUCH) ||
        libevdev_get_num_slots(evdev->device) > 0;
    push_device(evdev, PEL_INPUT_DOWN, queue);
    push_held(evdev, PEL_INPUT_DOWN, pel_linux_milliseconds(), queue);
    return 0;
}

int pel_evdev_descriptor(const struct pel_evdev *evdev)
{
    return libevdev_get_fd(evdev->device);
}

void pel_evdev_close(struct pel_evdev *evdev)
{
    if (!evdev->device)
        return;
    close(libevdev_get_fd(evdev->device));
    libevdev_free(evdev->device);
    evdev->device = NULL;
}
