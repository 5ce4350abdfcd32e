#include "gpio_lib.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_CHIPS = 64 };

static int no_chip(struct pel_gpio *gpio, struct pel_message *message)
{
    const int error = errno;
    pel_message_open(message, gpio->path, error,
                     "is it there? ls /dev/gpiochip*");
    return error;
}

/* The first chip that has a line of this name. */
static int find_chip(struct pel_gpio *gpio, const char *line,
                     struct pel_message *message)
{
    int denied = 0;
    if (isdigit((unsigned char)line[0])) {
        pel_message_set(message,
                        "line %s is of which chip? expected gpiochip0:%s", line,
                        line);
        return EINVAL;
    }
    for (int i = 0; i < MOST_CHIPS; i++) {
        snprintf(gpio->path, sizeof(gpio->path), "/dev/gpiochip%d", i);
        gpio->chip = pel_gpio_chip_open(gpio->path);
        if (gpio->chip && pel_gpio_chip_find(gpio->chip, line) >= 0)
            return 0;
        if (!gpio->chip && errno == EACCES && !denied) {
            denied = EACCES;
            pel_message_open(message, gpio->path, EACCES, "");
        }
        pel_gpio_close(gpio);
    }
    if (denied)
        return denied;
    pel_message_set(message,
                    "no GPIO chip has a line '%s': gpioinfo lists them", line);
    return ENOENT;
}

static int open_chip(struct pel_gpio *gpio, const char *chip,
                     struct pel_message *message)
{
    snprintf(gpio->path, sizeof(gpio->path), "%s%s",
             strchr(chip, '/') ? "" : "/dev/", chip);
    gpio->chip = pel_gpio_chip_open(gpio->path);
    return gpio->chip ? 0 : no_chip(gpio, message);
}

static int find_line(struct pel_gpio *gpio, const char *name, unsigned *offset,
                     struct pel_message *message)
{
    char *end;
    const unsigned long number = strtoul(name, &end, 10);
    const int found = pel_gpio_chip_find(gpio->chip, name);
    *offset = found >= 0 ? (unsigned)found : (unsigned)number;
    if (found >= 0 || (isdigit((unsigned char)name[0]) && !*end &&
                       number < pel_gpio_chip_lines(gpio->chip)))
        return 0;
    pel_message_set(message, "%s has no line '%s': gpioinfo lists them",
                    gpio->path, name);
    return ENOENT;
}

/* Whose line it is that was refused. */
static void not_free(struct pel_gpio *gpio,
                     const struct pel_gpio_request *request, int error,
                     struct pel_message *message)
{
    char holder[64];
    pel_message_set(message, "lines of %s: %s", gpio->path, strerror(error));
    for (int i = 0; i < gpio->count && error == EBUSY; i++)
        if (pel_gpio_chip_holder(gpio->chip, gpio->offsets[i], holder,
                                 sizeof(holder))) {
            pel_message_set(message,
                            "line %s of %s is held by '%s': stop that, or take "
                            "another line",
                            request->lines[i], gpio->path, holder);
            return;
        }
}

int pel_gpio_open(struct pel_gpio *gpio, const struct pel_gpio_request *request,
                  struct pel_message *message)
{
    memset(gpio, 0, sizeof(*gpio));
    gpio->count = request->count;
    int error = request->chip ? open_chip(gpio, request->chip, message)
                              : find_chip(gpio, request->lines[0], message);
    for (int i = 0; i < request->count && !error; i++)
        error = find_line(gpio, request->lines[i], &gpio->offsets[i], message);
    if (!error) {
        error = pel_gpio_request_lines(gpio, request);
        if (error)
            not_free(gpio, request, error, message);
    }
    if (error)
        pel_gpio_close(gpio);
    return error;
}

void pel_gpio_close(struct pel_gpio *gpio)
{
    if (gpio->request)
        pel_gpio_release_lines(gpio);
    if (gpio->chip)
        pel_gpio_chip_close(gpio->chip);
    gpio->chip = gpio->request = NULL;
}
