/* In place of libevdev, where it was not there at build time: no device opens.
 */
#include "evdev.h"

#include <errno.h>

int pel_evdev_open(struct pel_evdev *evdev, int number, bool keys,
                   struct pel_input_queue *queue, struct pel_message *message)
{
    (void)number;
    (void)keys;
    (void)queue;
    evdev->device = 0;
    return pel_message_set(message, ENOSYS,
                           "built without libevdev, which reads keyboards and "
                           "touch screens: install libevdev-dev and make "
                           "again");
}

void pel_evdev_read(struct pel_evdev *evdev, struct pel_input_queue *queue)
{
    (void)evdev;
    (void)queue;
}

int pel_evdev_descriptor(const struct pel_evdev *evdev)
{
    (void)evdev;
    return -1;
}

void pel_evdev_close(struct pel_evdev *evdev)
{
    (void)evdev;
}
