/* GPIO lines of one chip, through libgpiod: gpio_v1.c for its versions 1.x,
 * gpio_v2.c for 2.x, gpio_none.c without it. Lines are free again when the
 * process ends, whatever the end. */
#ifndef PEL_PORT_LINUX_GPIO_H
#define PEL_PORT_LINUX_GPIO_H

#include <poll.h>
#include <stdbool.h>
#include <stdint.h>

#include "../../drivers/linux_message.h"

PEL_BEGIN_DECLS

enum { PEL_GPIO_MOST = 32 };

enum pel_gpio_use {
    PEL_GPIO_PULL_UP,   /* input, active when low: a button to ground */
    PEL_GPIO_PULL_DOWN, /* input, active when high: a button to 3.3 V */
    PEL_GPIO_FLOATING,  /* input, active when low; the board has a resistor */
    PEL_GPIO_OUTPUT     /* active when high, which it is not at first */
};

struct pel_gpio_request {
    const char *chip; /* "gpiochip0", its path or its label; NULL: the first
                         that has a line of the first name */
    const char *lines[PEL_GPIO_MOST]; /* names, or numbers on the chip */
    int count;
    enum pel_gpio_use use;
    uint32_t debounce; /* us, by the kernel where libgpiod can ask it to, */
    uint32_t bounces;  /* but not of line i where bit i is set: an encoder's */
};

struct pel_gpio {
    char path[64], label[64]; /* of the chip */
    unsigned offsets[PEL_GPIO_MOST];
    int count;
    bool debounces;       /* the kernel does */
    void *chip, *request; /* of libgpiod, or memory of ours for it */
    uint32_t sequence;    /* of the last edge */
};

/* Takes the lines for this program ("pel" for others who ask). 0 or an errno,
 * with a message; of a line that another program holds with its name: EBUSY. */
int pel_gpio_open(struct pel_gpio *gpio, const struct pel_gpio_request *request,
                  struct pel_message *message);

/* Nothing when they are not open. */
void pel_gpio_close(struct pel_gpio *gpio);

/* Which lines are active, bit i for line i of the request. 0 or an errno:
 * ENODEV when the chip is gone. */
int pel_gpio_levels(struct pel_gpio *gpio, uint32_t *active);

/* Makes an output active or not. 0 or an errno. */
int pel_gpio_set(struct pel_gpio *gpio, int line, bool active);

struct pel_gpio_edge {
    uint64_t time; /* ns, CLOCK_MONOTONIC */
    uint8_t line;  /* of the request */
    bool active;
};

/* Edges of inputs that came since, at most `most` >= 32 * 16, in the order of
 * their times: their number, or an errno below 0. `lost`: there were more. */
int pel_gpio_edges(struct pel_gpio *gpio, struct pel_gpio_edge *edges, int most,
                   bool *lost);

/* What to poll for edges: the descriptors' number, at most PEL_GPIO_MOST. */
int pel_gpio_descriptors(const struct pel_gpio *gpio,
                         int descriptors[PEL_GPIO_MOST]);

PEL_END_DECLS
#endif
