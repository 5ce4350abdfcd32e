/* All input of a Linux machine in one queue: the kernel's input devices
 * (evdev.h) and buttons at GPIO lines (buttons.h). Devices may come and go; a
 * GPIO chip that went is taken again when it comes back.
 *
 *     static struct pel_input_linux input;
 *     const struct pel_input_linux_options options = {
 *         .buttons = "gpiochip0:5=left,6=right", .width = 240, .height = 240};
 *     if (pel_input_linux_open(&input, &options))
 *         puts(input.message.text), exit(2);
 *     while (pel_input_linux_wait(&input, -1, &event)) ...
 *     pel_input_linux_close(&input); */
#ifndef PEL_PORT_LINUX_INPUT_H
#define PEL_PORT_LINUX_INPUT_H

#include "buttons.h"
#include "evdev.h"

PEL_BEGIN_DECLS

enum {
    PEL_INPUT_LINUX_DEVICES = 24,
    PEL_INPUT_LINUX_EVENTS = 128,
    PEL_INPUT_LINUX_CHIP = 1024 /* code of the buttons' PEL_INPUT_DEVICE; N is
                                   that of /dev/input/eventN */
};

struct pel_input_linux_options {
    const char *buttons; /* see buttons.h; NULL: none */
    bool no_devices;     /* buttons alone */
    bool no_keys;        /* of keyboards: the program reads a terminal */
    int width, height;   /* px, where tablets and touch screens point to */
    const char *touch;   /* see touch_matrix.h; NULL: what PEL_TOUCH in the
                            environment says, or as the kernel tells */
};

struct pel_input_linux {
    struct pel_input_queue queue;
    struct pel_input events[PEL_INPUT_LINUX_EVENTS];
    struct pel_evdev devices[PEL_INPUT_LINUX_DEVICES];
    struct pel_buttons buttons;
    struct pel_input_linux_options options;
    struct pel_touch_matrix matrix; /* of options.touch */
    bool has_matrix;
    int poll;   /* of epoll: readable when there is something to read */
    int notify; /* of inotify, on /dev and /dev/input */
    int timer;  /* for buttons that bounce */
    struct pel_message message; /* the last error */
    struct pel_message note;    /* what could not be had, or "" */
};

/* 0 or an errno, with a message. Devices that cannot be opened are a note. */
int pel_input_linux_open(struct pel_input_linux *input,
                         const struct pel_input_linux_options *options);

/* Nothing when it is not open. */
void pel_input_linux_close(struct pel_input_linux *input);

/* The next event, at once. False when there is none. */
bool pel_input_linux_next(struct pel_input_linux *input,
                          struct pel_input *event);

/* The same, after at most `milliseconds`; -1: for ever. False too when a signal
 * came. */
bool pel_input_linux_wait(struct pel_input_linux *input, int milliseconds,
                          struct pel_input *event);

PEL_END_DECLS
#endif
