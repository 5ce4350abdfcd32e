#include "evdev.h"

#include <errno.h>
#include <libevdev/libevdev.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* What the places of a device mean. */
enum { NOTHING, POINTER, PEN, FINGERS };

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

static int16_t within(int64_t px, int size)
{
    return (int16_t)(px < 0 ? 0 : px < size ? px : size - 1);
}

/* The pixel that the middle of a unit of an axis is in. */
static int16_t pixel_of(const struct pel_evdev *evdev, unsigned axis, int value,
                        int size)
{
    const struct input_absinfo *info =
        libevdev_get_abs_info(evdev->device, axis);
    if (!info)
        return 0;
    const int64_t range = (int64_t)info->maximum - info->minimum;
    const int64_t at = 2 * ((int64_t)value - info->minimum) + 1;
    return within(range > 0 ? at * size / (2 * range + 2) : 0, size);
}

/* The middle of its unit, 0..1. */
static double part_of(const struct pel_evdev *evdev, unsigned axis, int value)
{
    const struct input_absinfo *info =
        libevdev_get_abs_info(evdev->device, axis);
    return info && info->maximum > info->minimum
               ? ((double)value - info->minimum + .5) /
                     ((double)info->maximum - info->minimum + 1)
               : 0;
}

/* Within -1..most, rounded down. */
static int64_t floored(double px, int most)
{
    return px < 0 ? -1 : px < most ? (int64_t)px : most;
}

/* Sets the place of a finger, or a pointer or a pen, from values of two axes.
 */
static void set_place(const struct pel_evdev *evdev,
                      struct pel_evdev_finger *finger, const unsigned axis[2],
                      const int value[2])
{
    const int width = evdev->width, height = evdev->height;
    finger->x = pixel_of(evdev, axis[0], value[0], width);
    finger->y = pixel_of(evdev, axis[1], value[1], height);
    if (!evdev->matrix || evdev->places != FINGERS)
        return;
    const struct pel_touch_place told = {part_of(evdev, axis[0], value[0]),
                                         part_of(evdev, axis[1], value[1])};
    const struct pel_touch_place p =
        pel_touch_matrix_place(evdev->matrix, told);
    finger->x = within(floored(p.x * width, width), width);
    finger->y = within(floored(p.y * height, height), height);
}

static const unsigned many_axes[2] = {ABS_MT_POSITION_X, ABS_MT_POSITION_Y};

/* As libevdev has it now; of a list, as told last. */
static struct pel_evdev_finger finger_now(const struct pel_evdev *evdev, int i)
{
    static const unsigned one_axes[2] = {ABS_X, ABS_Y};
    const struct libevdev *d = evdev->device;
    struct pel_evdev_finger now = evdev->finger[i];
    int value[2];
    if (evdev->list.is)
        return now;
    for (int k = 0; k < 2; k++)
        value[k] = evdev->slots
                       ? libevdev_get_slot_value(d, (unsigned)i, many_axes[k])
                       : libevdev_get_event_value(d, EV_ABS, one_axes[k]);
    set_place(evdev, &now, evdev->slots ? many_axes : one_axes, value);
    now.down =
        evdev->slots
            ? libevdev_get_slot_value(d, (unsigned)i, ABS_MT_TRACKING_ID) >= 0
            : evdev->places >= PEN &&
                  libevdev_get_event_value(d, EV_KEY, BTN_TOUCH);
    return now;
}

static void push_place(struct pel_evdev *evdev, int i,
                       struct pel_evdev_finger now, uint32_t time,
                       struct pel_input_queue *queue)
{
    const bool was = evdev->finger[i].down;
    struct pel_input e = {.time = time,
                          .kind = PEL_INPUT_POINT,
                          .code = (uint16_t)i,
                          .x = now.x,
                          .y = now.y};
    if (evdev->places == FINGERS) {
        e.kind = PEL_INPUT_TOUCH;
        e.state = !now.down ? PEL_INPUT_UP
                  : was     ? PEL_INPUT_AGAIN
                            : PEL_INPUT_DOWN;
    }
    if (evdev->places != FINGERS || now.down || was)
        pel_input_push(queue, &e);
    if (evdev->places == PEN && now.down != was)
        pel_input_push(queue, &(struct pel_input){.time = time,
                                                  .kind = PEL_INPUT_BUTTON,
                                                  .state = now.down,
                                                  .code = 1});
    evdev->finger[i] = now;
}

/* SYN_MT_REPORT: what came before is a finger, or none. */
static void end_finger(struct pel_evdev *evdev)
{
    struct pel_evdev_list *const l = &evdev->list;
    const int value[2] = {l->x, l->y};
    if (l->placed && l->n < PEL_EVDEV_FINGERS) {
        l->finger[l->n].down = true;
        set_place(evdev, &l->finger[l->n++], many_axes, value);
    }
    l->placed = false;
    l->told = true;
}

static void push_list(struct pel_evdev *evdev, uint32_t time,
                      struct pel_input_queue *queue)
{
    int at[PEL_EVDEV_FINGERS];
    pel_evdev_match(evdev->finger, &evdev->list, at);
    for (int i = 0; i < PEL_EVDEV_FINGERS; i++) {
        const struct pel_evdev_finger *const told = &evdev->finger[i];
        struct pel_evdev_finger now = *told;
        now.down = false;
        if (at[i] >= 0)
            now = evdev->list.finger[at[i]];
        if (now.down != told->down ||
            (now.down && (now.x != told->x || now.y != told->y)))
            push_place(evdev, i, now, time, queue);
    }
    evdev->list.n = 0;
    evdev->list.told = false;
}

/* A report without a list says nothing of fingers, unless no touch is left. */
static bool tells_list(const struct pel_evdev *evdev)
{
    const struct libevdev *const d = evdev->device;
    return evdev->list.is &&
           (evdev->list.told ||
            (libevdev_has_event_code(d, EV_KEY, BTN_TOUCH) &&
             !libevdev_get_event_value(d, EV_KEY, BTN_TOUCH)));
}

static void push_steps(struct pel_input_queue *queue, int kind, uint32_t time,
                       int16_t x, int16_t y)
{
    const struct pel_input e = {
        .time = time, .kind = (uint8_t)kind, .x = x, .y = y};
    if (x || y)
        pel_input_push(queue, &e);
}

/* All that a report said of places and steps. */
static void push_report(struct pel_evdev *evdev, uint32_t time,
                        struct pel_input_queue *queue)
{
    if (tells_list(evdev))
        push_list(evdev, time, queue);
    for (int i = 0; i < evdev->fingers; i++) {
        const struct pel_evdev_finger *told = &evdev->finger[i];
        const struct pel_evdev_finger now = finger_now(evdev, i);
        if (now.x != told->x || now.y != told->y || now.down != told->down)
            push_place(evdev, i, now, time, queue);
    }
    push_steps(queue, PEL_INPUT_MOVE, time, evdev->steps[REL_X],
               evdev->steps[REL_Y]);
    push_steps(queue, PEL_INPUT_WHEEL, time, evdev->steps[REL_HWHEEL],
               evdev->steps[REL_WHEEL]);
    memset(evdev->steps, 0, sizeof(evdev->steps));
}

static int16_t add(int sum, int value)
{
    sum += value;
    return (int16_t)(sum > INT16_MAX   ? INT16_MAX
                     : sum < INT16_MIN ? INT16_MIN
                                       : sum);
}

static void handle(struct pel_evdev *evdev, const struct input_event *e,
                   struct pel_input_queue *queue)
{
    if (evdev->list.is && e->type == EV_ABS)
        pel_evdev_list_take(&evdev->list, e->code, e->value);
    else if (e->type == EV_SYN && e->code == SYN_MT_REPORT)
        end_finger(evdev);
    else if (e->type == EV_REL && e->code < PEL_EVDEV_STEPS)
        evdev->steps[e->code] = add(evdev->steps[e->code], e->value);
    else if (e->type == EV_SYN && e->code == SYN_REPORT)
        push_report(evdev, time_of(e), queue);
    else if (e->type == EV_KEY)
        push_key(evdev, e->code, e->value, time_of(e), queue);
}

/* Presses or releases all that is held. */
static void push_held(struct pel_evdev *evdev, int state, uint32_t time,
                      struct pel_input_queue *queue)
{
    for (unsigned code = 0; code < KEY_MAX; code++)
        if (libevdev_get_event_value(evdev->device, EV_KEY, code))
            push_key(evdev, (int)code, state, time, queue);
    for (int i = 0; i < evdev->fingers; i++) {
        struct pel_evdev_finger *told = &evdev->finger[i], now = *told;
        now.down = false;
        if (state == PEL_INPUT_DOWN) {
            now = finger_now(evdev, i);
            told->down = false;
        }
        if (now.down != told->down)
            push_place(evdev, i, now, time, queue);
    }
}

/* The kernel's own queue ran over: libevdev asks for the state of all things,
 * which is taken in without a word. */
static int resync(struct pel_evdev *evdev, struct pel_input_queue *queue)
{
    struct input_event e;
    int status;
    do
        status =
            libevdev_next_event(evdev->device, LIBEVDEV_READ_FLAG_SYNC, &e);
    while (status == LIBEVDEV_READ_STATUS_SYNC);
    memset(evdev->steps, 0, sizeof(evdev->steps));
    evdev->list.n = 0;
    evdev->list.placed = false;
    pel_input_push_now(queue, PEL_INPUT_LOST, 0, 0);
    return status == -EAGAIN ? 0 : status;
}

/* Room for what one report may push. */
enum { ROOM = PEL_EVDEV_FINGERS + 4 };

void pel_evdev_read(struct pel_evdev *evdev, struct pel_input_queue *queue)
{
    struct input_event e;
    int status = 0;
    while (status >= 0) {
        if (pel_input_room(queue) < ROOM)
            return;
        if (pel_input_lost(queue, &evdev->losses))
            push_held(evdev, PEL_INPUT_DOWN, pel_linux_milliseconds(), queue);
        status =
            libevdev_next_event(evdev->device, LIBEVDEV_READ_FLAG_NORMAL, &e);
        if (status == LIBEVDEV_READ_STATUS_SUCCESS)
            handle(evdev, &e, queue);
        else if (status == LIBEVDEV_READ_STATUS_SYNC)
            status = resync(evdev, queue);
    }
    if (status == -EAGAIN || status == -EINTR)
        return;
    push_held(evdev, PEL_INPUT_UP, pel_linux_milliseconds(), queue);
    pel_input_push_now(queue, PEL_INPUT_DEVICE, PEL_INPUT_UP, evdev->number);
    pel_evdev_close(evdev);
}

/* As udev tells them apart: a touch pad has fingers that are not on a screen, a
 * pointer with a place has the buttons of a mouse. */
static bool has_list(const struct libevdev *d)
{
    return libevdev_get_num_slots(d) <= 0 &&
           libevdev_has_event_code(d, EV_ABS, ABS_MT_POSITION_X);
}

static int places_of(const struct libevdev *d)
{
    const bool many = libevdev_get_num_slots(d) > 0 || has_list(d);
    const bool direct = libevdev_has_property(d, INPUT_PROP_DIRECT);
    const bool touched =
        many || libevdev_has_event_code(d, EV_KEY, BTN_TOUCH) || direct;
    if (libevdev_has_property(d, INPUT_PROP_ACCELEROMETER) ||
        !(many || libevdev_has_event_code(d, EV_ABS, ABS_X)))
        return NOTHING;
    if (!many && libevdev_has_event_code(d, EV_KEY, BTN_TOOL_PEN))
        return PEN;
    if (!direct && (libevdev_has_event_code(d, EV_KEY, BTN_TOOL_FINGER) ||
                    (touched && libevdev_has_property(d, INPUT_PROP_POINTER))))
        return NOTHING;
    if (!many && libevdev_has_event_code(d, EV_KEY, BTN_LEFT))
        return POINTER;
    return touched ? FINGERS : NOTHING;
}

static bool tells_something(const struct pel_evdev *evdev)
{
    const struct libevdev *d = evdev->device;
    return evdev->places != NOTHING || libevdev_has_event_type(d, EV_REL) ||
           libevdev_has_event_code(d, EV_KEY, BTN_LEFT) ||
           (evdev->keys && libevdev_has_event_type(d, EV_KEY));
}

int pel_evdev_open(struct pel_evdev *evdev, int number, bool keys,
                   struct pel_input_queue *queue, struct pel_message *message)
{
    char path[40];
    snprintf(path, sizeof(path), "/dev/input/event%d", number);
    const int fd = pel_linux_open(path, O_RDONLY | O_NONBLOCK);
    int error = errno;
    *evdev = (struct pel_evdev){.number = number,
                                .width = evdev->width,
                                .height = evdev->height,
                                .matrix = evdev->matrix,
                                .keys = keys,
                                .losses = queue->losses};
    if (fd < 0)
        return pel_message_open(message, path, error, "it is gone");
    errno = -libevdev_new_from_fd(fd, &evdev->device);
    if (errno) {
        error = pel_message_errno(message, path);
        close(fd);
        evdev->device = NULL;
        return error;
    }
    libevdev_set_clock_id(evdev->device, CLOCK_MONOTONIC);
    evdev->places = (uint8_t)places_of(evdev->device);
    if (evdev->places == FINGERS)
        evdev->slots = pel_max(libevdev_get_num_slots(evdev->device), 0);
    evdev->list.is = evdev->places == FINGERS && has_list(evdev->device);
    evdev->fingers = evdev->places == NOTHING ? 0
                     : evdev->list.is         ? PEL_EVDEV_FINGERS
                     : evdev->slots ? pel_min(evdev->slots, PEL_EVDEV_FINGERS)
                                    : 1;
    if (!tells_something(evdev)) {
        pel_evdev_close(evdev);
        return pel_message_set(message, ENOTSUP,
                               "%s has no keys, and points nowhere", path);
    }
    for (int i = 0; i < evdev->fingers; i++)
        evdev->finger[i] = finger_now(evdev, i);
    pel_input_push_now(queue, PEL_INPUT_DEVICE, PEL_INPUT_DOWN, number);
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
