/* In place of libgpiod, where it was not there at build time: no line opens. */
#include "gpio.h"

#include <errno.h>
#include <string.h>

int pel_gpio_open(struct pel_gpio *gpio, const struct pel_gpio_request *request,
                  struct pel_message *message)
{
    (void)request;
    memset(gpio, 0, sizeof(*gpio));
    return pel_message_set(message, ENOSYS,
                           "built without libgpiod, which has the GPIO lines: "
                           "install libgpiod-dev and make again");
}

void pel_gpio_close(struct pel_gpio *gpio)
{
    (void)gpio;
}

int pel_gpio_levels(struct pel_gpio *gpio, uint32_t *active)
{
    (void)gpio;
    *active = 0;
    return ENODEV;
}

int pel_gpio_set(struct pel_gpio *gpio, int line, bool active)
{
    (void)gpio;
    (void)line;
    (void)active;
    return ENODEV;
}

int pel_gpio_edges(struct pel_gpio *gpio, struct pel_gpio_edge *edges, int most,
                   bool *lost)
{
    (void)gpio;
    (void)edges;
    (void)most;
    *lost = false;
    return -ENODEV;
}

int pel_gpio_descriptors(const struct pel_gpio *gpio,
                         int descriptors[PEL_GPIO_MOST])
{
    (void)gpio;
    (void)descriptors;
    return 0;
}
