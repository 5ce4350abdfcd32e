/* touch_device: a touch screen of the kernel's uinput, on which two fingers do
 * what guest_input.sh expects; then it is taken away. */
#include <libevdev/libevdev-uinput.h>
#include <libevdev/libevdev.h>
#include <stdio.h>
#include <unistd.h>

enum { MOST = 9999 };

static struct libevdev_uinput *create(void)
{
    struct libevdev_uinput *screen = NULL;
    struct libevdev *device = libevdev_new();
    const struct input_absinfo place = {.maximum = MOST},
                               slots = {.maximum = 4},
                               finger = {.maximum = 65535};
    libevdev_set_name(device, "touch screen of the test");
    libevdev_enable_property(device, INPUT_PROP_DIRECT);
    libevdev_enable_event_code(device, EV_KEY, BTN_TOUCH, NULL);
    libevdev_enable_event_code(device, EV_ABS, ABS_X, &place);
    libevdev_enable_event_code(device, EV_ABS, ABS_Y, &place);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_SLOT, &slots);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_TRACKING_ID, &finger);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_POSITION_X, &place);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_POSITION_Y, &place);
    libevdev_uinput_create_from_device(device, LIBEVDEV_UINPUT_OPEN_MANAGED,
                                       &screen);
    libevdev_free(device);
    return screen;
}

int main(void)
{
    static const struct {
        unsigned type, code;
        int value;
    } does[] = {
        {EV_ABS, ABS_MT_SLOT, 0},
        {EV_ABS, ABS_MT_TRACKING_ID, 7},
        {EV_ABS, ABS_MT_POSITION_X, 1000},
        {EV_ABS, ABS_MT_POSITION_Y, 1000},
        {EV_KEY, BTN_TOUCH, 1},
        {EV_SYN, SYN_REPORT, 0},
        {EV_ABS, ABS_MT_SLOT, 1},
        {EV_ABS, ABS_MT_TRACKING_ID, 8},
        {EV_ABS, ABS_MT_POSITION_X, 9000},
        {EV_ABS, ABS_MT_POSITION_Y, 5000},
        {EV_SYN, SYN_REPORT, 0},
        {EV_ABS, ABS_MT_SLOT, 0},
        {EV_ABS, ABS_MT_POSITION_X, 2000},
        {EV_SYN, SYN_REPORT, 0},
        {EV_ABS, ABS_MT_TRACKING_ID, -1},
        {EV_SYN, SYN_REPORT, 0},
    };
    struct libevdev_uinput *screen = create();
    if (!screen)
        return 2;
    usleep(500000); /* until it was opened */
    for (size_t i = 0; i < sizeof(does) / sizeof(does[0]); i++)
        libevdev_uinput_write_event(screen, does[i].type, does[i].code,
                                    does[i].value);
    usleep(300000);
    libevdev_uinput_destroy(screen); /* while a finger rests */
    return 0;
}
