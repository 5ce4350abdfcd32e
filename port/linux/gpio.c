#include "gpio_lib.h"

#include <ctype.h>
#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_CHIPS = 64 };

static int open_path(struct pel_gpio *gpio)
{
    gpio->chip = gpiod_chip_open(gpio->path);
    if (!gpio->chip)
        return errno;
    pel_gpio_chip_label(gpio->chip, gpio->label, sizeof(gpio->label));
    return 0;
}

/* The first chip with this label, or NULL: with a line of this name. ENOENT
 * without a message when there is none. */
static int find_chip(struct pel_gpio *gpio, const char *label, const char *line,
                     struct pel_message *message)
{
    int result = ENOENT;
    for (int i = 0; i < MOST_CHIPS; i++) {
        snprintf(gpio->path, sizeof(gpio->path), "/dev/gpiochip%d", i);
        const int error = open_path(gpio);
        errno = error;
        if (!error && (label ? strcmp(gpio->label, label) == 0
                             : pel_gpio_chip_find(gpio->chip, line) >= 0))
            return 0;
        const bool again = errno == EINTR;
        if (error == EACCES && result != EACCES) {
            pel_message_open(message, gpio->path, error, "");
            result = error;
        }
        pel_gpio_close(gpio);
        if (again)
            return EINTR;
    }
    return result;
}

static int open_by_line(struct pel_gpio *gpio, const char *line,
                        struct pel_message *message)
{
    if (isdigit((unsigned char)line[0]))
        return pel_message_set(message, EINVAL,
                               "line %s is of which chip? expected "
                               "gpiochip0:%s",
                               line, line);
    const int error = find_chip(gpio, NULL, line, message);
    return error == ENOENT
               ? pel_message_set(message, error,
                                 "no GPIO chip has a line '%s': gpioinfo lists "
                                 "them",
                                 line)
               : error;
}

static int open_chip(struct pel_gpio *gpio, const char *chip,
                     struct pel_message *message)
{
    snprintf(gpio->path, sizeof(gpio->path), "%s%s",
             strchr(chip, '/') ? "" : "/dev/", chip);
    int error = open_path(gpio);
    if (!error)
        return 0;
    pel_message_open(message, gpio->path, error,
                     "and no chip has that label: gpiodetect lists them");
    return error == ENOENT ? find_chip(gpio, chip, NULL, message) : error;
}

/* A name first: a line may be called by another's number. */
static int find_line(struct pel_gpio *gpio, const char *name, unsigned *offset,
                     struct pel_message *message)
{
    char *end;
    const unsigned long number = strtoul(name, &end, 10);
    errno = 0;
    const int found = pel_gpio_chip_find(gpio->chip, name);
    *offset = found >= 0 ? (unsigned)found : (unsigned)number;
    if (found >= 0)
        return 0;
    if (errno != EINTR && isdigit((unsigned char)name[0]) && !*end &&
        number < pel_gpio_chip_lines(gpio->chip))
        return 0;
    return pel_message_set(message, errno == EINTR ? EINTR : ENOENT,
                           "%s has no line '%s': gpioinfo lists them",
                           gpio->path, name);
}

/* Whose line it is that was refused. */
static int not_free(struct pel_gpio *gpio,
                    const struct pel_gpio_request *request, int error,
                    struct pel_message *message)
{
    char holder[64];
    for (int i = 0; i < gpio->count && error == EBUSY; i++)
        if (pel_gpio_chip_holder(gpio->chip, gpio->offsets[i], holder,
                                 sizeof(holder)))
            return pel_message_set(message, error,
                                   "line %s of %s is held by '%s': stop that, "
                                   "or take another line",
                                   request->lines[i], gpio->path, holder);
    return pel_message_set(message, error, "lines of %s: %s", gpio->path,
                           strerror(error));
}

static int try_open(struct pel_gpio *gpio,
                    const struct pel_gpio_request *request,
                    struct pel_message *message)
{
    memset(gpio, 0, sizeof(*gpio));
    gpio->count = request->count;
    int error = request->chip ? open_chip(gpio, request->chip, message)
                              : open_by_line(gpio, request->lines[0], message);
    for (int i = 0; i < request->count && !error; i++)
        error = find_line(gpio, request->lines[i], &gpio->offsets[i], message);
    const int refused = error ? 0 : pel_gpio_request_lines(gpio, request);
    if (refused)
        error = not_free(gpio, request, refused, message);
    if (error)
        pel_gpio_close(gpio);
    return error;
}

int pel_gpio_open(struct pel_gpio *gpio, const struct pel_gpio_request *request,
                  struct pel_message *message)
{
    int error;
    do
        error = try_open(gpio, request, message);
    while (error == EINTR);
    return error;
}

void pel_gpio_close(struct pel_gpio *gpio)
{
    if (gpio->request)
        pel_gpio_release_lines(gpio);
    if (gpio->chip)
        gpiod_chip_close(gpio->chip);
    gpio->chip = gpio->request = NULL;
}
