/* pel input: prints what the keyboards, pointers, touch screens and buttons of
 * a Linux machine tell. */
#include <math.h>
#include <stdio.h>

#include "port/linux/input.h"
#include "port/linux/key_names.h"
#include "sim/cli/arguments.h"
#include "sim/cli/calibrate.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"

struct input_options {
    const char *buttons;
    const char *touch, *calibrate;
    struct device_options device;
    double size[2];
    double seconds; /* 0: for ever */
    bool no_devices;
};

static const struct option_row options[] = {
    {"buttons", "CHIP:LINES",
     "buttons and encoders at GPIO lines: gpiochip0:5=left,6=right,13=enter; "
     "a line's name will do (GPIO5=left); 17/27=wheel is an encoder; "
     "pull-down, "
     "floating, debounce=5 are for all lines",
     OPTION_TEXT, .offset = offsetof(struct input_options, buttons)},
    {"size", "WxH", "where tablets and touch screens point to (1000x1000)",
     OPTION_NUMBERS, .offset = offsetof(struct input_options, size), .n = 2,
     .separator = 'x', .low = 1, .high = 32767, .expected = "320x240"},
    {"touch", "HOW",
     "touch screens that are out of place: swap, invert-x, invert-y, "
     "rotate=90, "
     "range=0.05:0.95:0:1, with commas between them, or a FILE of --calibrate "
     "or libinput (/PATH); what PEL_TOUCH in the environment says",
     OPTION_TEXT, .offset = offsetof(struct input_options, touch)},
    {"calibrate", "FILE",
     "show crosses to touch on the device, and write that file", OPTION_TEXT,
     .offset = offsetof(struct input_options, calibrate)},
    {"device", "NAME", "of --calibrate: fb:/dev/fb0, drm:/dev/dri/card0 (auto)",
     OPTION_TEXT, .offset = offsetof(struct input_options, device.name)},
    {"seconds", "S", "end after that time", OPTION_NUMBERS,
     .offset = offsetof(struct input_options, seconds), .n = 1, .low = 0.001,
     .high = 1e6, .expected = "10"},
    {"only-buttons", NULL, "leave out keyboards, pointers, touch screens",
     OPTION_FLAG, .offset = offsetof(struct input_options, no_devices)},
    {.help = NULL},
};

static void print(const struct pel_input *e)
{
    static const char *const states[] = {"up", "down", "again"};
    const char *state = states[e->state];
    char name[PEL_KEY_NAME_SIZE];
    printf("%lu.%03lu ", (unsigned long)e->time / 1000,
           (unsigned long)e->time % 1000);
    switch (e->kind) {
    case PEL_INPUT_KEY:
        printf("key %s %s\n", pel_key_name(e->code, name), state);
        break;
    case PEL_INPUT_BUTTON:
        printf("button %d %s\n", e->code, state);
        break;
    case PEL_INPUT_MOVE:
        printf("move %d %d\n", e->x, e->y);
        break;
    case PEL_INPUT_POINT:
        printf("point %d %d\n", e->x, e->y);
        break;
    case PEL_INPUT_TOUCH:
        printf("touch %d at %d %d %s\n", e->code, e->x, e->y, state);
        break;
    case PEL_INPUT_WHEEL:
        printf("wheel %d %d\n", e->x, e->y);
        break;
    case PEL_INPUT_DEVICE:
        printf(e->code == PEL_INPUT_LINUX_CHIP ? "buttons" : "event%d",
               e->code);
        printf(" %s\n", e->state ? "here" : "gone");
        break;
    default:
        puts("lost");
    }
}

static void print_all(struct pel_input_linux *input, double seconds)
{
    const double end = milliseconds() + seconds * 1000;
    struct pel_input event;
    int left = -1;
    while (left != 0) {
        if (seconds > 0)
            left = (int)fmax(end - milliseconds(), 0);
        if (pel_input_linux_wait(input, left, &event))
            print(&event);
    }
}

int command_input(int argc, char **argv)
{
    static struct pel_input_linux input;
    struct input_options o = {.size = {1000, 1000}, .device.name = "auto"};
    const struct command_line line = {
        .arguments = "",
        .about = "Prints what keyboards, mice, tablets, touch screens and "
                 "buttons do.\v"
                 "A line is the time in seconds and what happened. Ends with "
                 "Ctrl-C.",
        .tables = {{options, &o, NULL}}};
    arguments_parse(&line, argc, argv);
    if (o.calibrate)
        return calibrate(&o.device, o.calibrate) ? STATUS_OK : STATUS_ERROR;
    const struct pel_input_linux_options linux_options = {
        .buttons = o.buttons,
        .touch = o.touch,
        .no_devices = o.no_devices,
        .width = (int)o.size[0],
        .height = (int)o.size[1]};
    if (pel_input_linux_open(&input, &linux_options)) {
        message_error("%s", input.message.text);
        return STATUS_ERROR;
    }
    if (input.note.text[0])
        message_error("%s", input.note.text);
    setvbuf(stdout, NULL, _IOLBF, 0);
    print_all(&input, o.seconds);
    pel_input_linux_close(&input);
    return STATUS_OK;
}
