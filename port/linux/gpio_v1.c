/* libgpiod 1.x: a descriptor for each line that has edges. */
#include "gpio_lib.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

unsigned pel_gpio_chip_lines(void *chip)
{
    return gpiod_chip_num_lines(chip);
}

void pel_gpio_chip_label(void *chip, char *label, size_t size)
{
    snprintf(label, size, "%s", gpiod_chip_label(chip));
}

int pel_gpio_chip_find(void *chip, const char *name)
{
    struct gpiod_line *line = gpiod_chip_find_line(chip, name);
    return line ? (int)gpiod_line_offset(line) : -1;
}

bool pel_gpio_chip_holder(void *chip, unsigned offset, char *name, size_t size)
{
    struct gpiod_line *line = gpiod_chip_get_line(chip, offset);
    if (!line || gpiod_line_update(line) || !gpiod_line_is_used(line))
        return false;
    const char *consumer = gpiod_line_consumer(line);
    snprintf(name, size, "%s", consumer ? consumer : "the kernel");
    return true;
}

static struct gpiod_line *line_of(struct pel_gpio *gpio, int i)
{
    struct gpiod_line_bulk *bulk = gpio->request;
    return gpiod_line_bulk_get_line(bulk, (unsigned)i);
}

int pel_gpio_request_lines(struct pel_gpio *gpio,
                           const struct pel_gpio_request *request)
{
    static const int flags[] = {
        [PEL_GPIO_PULL_UP] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP |
                             GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW,
        [PEL_GPIO_PULL_DOWN] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN,
        [PEL_GPIO_FLOATING] = GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE |
                              GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW,
        [PEL_GPIO_OUTPUT] = 0};
    const struct gpiod_line_request_config config = {
        .consumer = "pel",
        .request_type = request->use == PEL_GPIO_OUTPUT
                            ? GPIOD_LINE_REQUEST_DIRECTION_OUTPUT
                            : GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES,
        .flags = flags[request->use]};
    static const int low[PEL_GPIO_MOST];
    struct gpiod_line_bulk *bulk = calloc(1, sizeof(*bulk));
    if (!bulk)
        return ENOMEM;
    if (gpiod_chip_get_lines(gpio->chip, gpio->offsets, (unsigned)gpio->count,
                             bulk) ||
        gpiod_line_request_bulk(bulk, &config, low)) {
        const int error = errno;
        free(bulk);
        return error;
    }
    gpio->request = bulk;
    return 0;
}

void pel_gpio_release_lines(struct pel_gpio *gpio)
{
    gpiod_line_release_bulk(gpio->request);
    free(gpio->request);
}

int pel_gpio_levels(struct pel_gpio *gpio, uint32_t *active)
{
    int values[PEL_GPIO_MOST];
    if (gpiod_line_get_value_bulk(gpio->request, values))
        return errno;
    *active = 0;
    for (int i = 0; i < gpio->count; i++)
        *active |= (uint32_t)(values[i] != 0) << i;
    return 0;
}

int pel_gpio_set(struct pel_gpio *gpio, int line, bool active)
{
    return gpiod_line_set_value(line_of(gpio, line), active) ? errno : 0;
}

/* Adds an edge in the order of times. */
static void insert(struct pel_gpio_edge *edges, int n,
                   struct pel_gpio_edge edge)
{
    for (; n > 0 && edges[n - 1].time > edge.time; n--)
        edges[n] = edges[n - 1];
    edges[n] = edge;
}

/* What a line has, added to the `n` edges: how many now, or an errno below 0.
 */
static int read_line(struct pel_gpio *gpio, int i, struct pel_gpio_edge *edges,
                     int n, bool *lost)
{
    struct gpiod_line_event events[PEL_GPIO_EDGES_AT_ONCE];
    struct gpiod_line *line = line_of(gpio, i);
    int got = gpiod_line_event_wait(line, &(struct timespec){0, 0});
    if (got > 0)
        got = gpiod_line_event_read_multiple(line, events,
                                             PEL_GPIO_EDGES_AT_ONCE);
    if (got < 0)
        return errno == EINTR ? n : -errno;
    *lost = *lost || got == PEL_GPIO_EDGES_AT_ONCE;
    for (int k = 0; k < got; k++)
        insert(edges, n++,
               (struct pel_gpio_edge){
                   .time = (uint64_t)events[k].ts.tv_sec * 1000000000 +
                           (uint64_t)events[k].ts.tv_nsec,
                   .line = (uint8_t)i,
                   .active =
                       events[k].event_type == GPIOD_LINE_EVENT_RISING_EDGE});
    return n;
}

/* Until all lines have none: what one of them gets while others are read is
 * later than all that were. */
int pel_gpio_edges(struct pel_gpio *gpio, struct pel_gpio_edge *edges, int most,
                   bool *lost)
{
    int n = 0, before;
    *lost = false;
    do {
        before = n;
        for (int i = 0; i < gpio->count && n >= 0; i++)
            n = read_line(gpio, i, edges, n, lost);
    } while (n > before && n + gpio->count * PEL_GPIO_EDGES_AT_ONCE <= most);
    return n;
}

int pel_gpio_descriptors(const struct pel_gpio *gpio,
                         int descriptors[PEL_GPIO_MOST])
{
    for (int i = 0; i < gpio->count; i++)
        descriptors[i] = gpiod_line_event_get_fd(
            gpiod_line_bulk_get_line(gpio->request, (unsigned)i));
    return gpio->count;
}
