/* libgpiod 2.x: one descriptor for all lines, whose edges come in order. */
#include "gpio_lib.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

struct lines {
    struct gpiod_line_request *request;
    struct gpiod_edge_event_buffer *buffer; /* NULL for outputs */
};

enum { EDGES = PEL_GPIO_MOST * PEL_GPIO_EDGES_AT_ONCE };

unsigned pel_gpio_chip_lines(void *chip)
{
    struct gpiod_chip_info *info = gpiod_chip_get_info(chip);
    const size_t count = info ? gpiod_chip_info_get_num_lines(info) : 0;
    if (info)
        gpiod_chip_info_free(info);
    return (unsigned)count;
}

void pel_gpio_chip_label(void *chip, char *label, size_t size)
{
    struct gpiod_chip_info *info = gpiod_chip_get_info(chip);
    snprintf(label, size, "%s", info ? gpiod_chip_info_get_label(info) : "");
    if (info)
        gpiod_chip_info_free(info);
}

int pel_gpio_chip_find(void *chip, const char *name)
{
    return gpiod_chip_get_line_offset_from_name(chip, name);
}

bool pel_gpio_chip_holder(void *chip, unsigned offset, char *name, size_t size)
{
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip, offset);
    const bool used = info && gpiod_line_info_is_used(info);
    const char *consumer = used ? gpiod_line_info_get_consumer(info) : NULL;
    if (used)
        snprintf(name, size, "%s", consumer ? consumer : "the kernel");
    if (info)
        gpiod_line_info_free(info);
    return used;
}

static void set(struct gpiod_line_settings *s,
                const struct pel_gpio_request *request)
{
    static const enum gpiod_line_bias biases[] = {
        [PEL_GPIO_PULL_UP] = GPIOD_LINE_BIAS_PULL_UP,
        [PEL_GPIO_PULL_DOWN] = GPIOD_LINE_BIAS_PULL_DOWN,
        [PEL_GPIO_FLOATING] = GPIOD_LINE_BIAS_DISABLED};
    if (request->use == PEL_GPIO_OUTPUT) {
        gpiod_line_settings_set_direction(s, GPIOD_LINE_DIRECTION_OUTPUT);
        return;
    }
    gpiod_line_settings_set_direction(s, GPIOD_LINE_DIRECTION_INPUT);
    gpiod_line_settings_set_edge_detection(s, GPIOD_LINE_EDGE_BOTH);
    gpiod_line_settings_set_bias(s, biases[request->use]);
    gpiod_line_settings_set_active_low(s, request->use != PEL_GPIO_PULL_DOWN);
}

/* The settings of each line, which differ in debouncing alone. */
static int add_lines(const struct pel_gpio *gpio,
                     const struct pel_gpio_request *request,
                     struct gpiod_line_settings *settings,
                     struct gpiod_line_config *lines)
{
    int failed = 0;
    set(settings, request);
    for (int i = 0; i < gpio->count && !failed; i++) {
        gpiod_line_settings_set_debounce_period_us(
            settings, request->bounces >> i & 1 ? 0 : request->debounce);
        failed = gpiod_line_config_add_line_settings(lines, &gpio->offsets[i],
                                                     1, settings);
    }
    return failed;
}

/* One request with bias, edges and debouncing, and room for as many edges as
 * are read at once; NULL and errno. */
static struct gpiod_line_request *request_lines(
    const struct pel_gpio *gpio, const struct pel_gpio_request *request)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *config = gpiod_request_config_new();
    struct gpiod_line_request *result = NULL;
    if (settings && lines && config) {
        gpiod_request_config_set_consumer(config, "pel");
        gpiod_request_config_set_event_buffer_size(config, EDGES);
        if (!add_lines(gpio, request, settings, lines))
            result = gpiod_chip_request_lines(gpio->chip, config, lines);
    }
    const int error = errno;
    gpiod_request_config_free(config);
    gpiod_line_config_free(lines);
    gpiod_line_settings_free(settings);
    errno = error;
    return result;
}

int pel_gpio_request_lines(struct pel_gpio *gpio,
                           const struct pel_gpio_request *request)
{
    struct lines *lines = calloc(1, sizeof(*lines));
    if (!lines)
        return ENOMEM;
    gpio->request = lines;
    lines->request = request_lines(gpio, request);
    if (lines->request && request->use != PEL_GPIO_OUTPUT)
        lines->buffer = gpiod_edge_event_buffer_new(EDGES);
    if (!lines->request || (request->use != PEL_GPIO_OUTPUT && !lines->buffer))
        return errno;
    gpio->debounces = request->debounce > 0;
    return 0;
}

void pel_gpio_release_lines(struct pel_gpio *gpio)
{
    struct lines *lines = gpio->request;
    if (lines->buffer)
        gpiod_edge_event_buffer_free(lines->buffer);
    if (lines->request)
        gpiod_line_request_release(lines->request);
    free(lines);
}

int pel_gpio_levels(struct pel_gpio *gpio, uint32_t *active)
{
    struct lines *lines = gpio->request;
    enum gpiod_line_value values[PEL_GPIO_MOST];
    if (gpiod_line_request_get_values(lines->request, values))
        return errno;
    *active = 0;
    for (int i = 0; i < gpio->count; i++)
        *active |= (uint32_t)(values[i] == GPIOD_LINE_VALUE_ACTIVE) << i;
    return 0;
}

int pel_gpio_set(struct pel_gpio *gpio, int line, bool active)
{
    struct lines *lines = gpio->request;
    return gpiod_line_request_set_value(lines->request, gpio->offsets[line],
                                        active ? GPIOD_LINE_VALUE_ACTIVE
                                               : GPIOD_LINE_VALUE_INACTIVE)
               ? errno
               : 0;
}

static uint8_t line_at(const struct pel_gpio *gpio, unsigned offset)
{
    int i = 0;
    while (i < gpio->count - 1 && gpio->offsets[i] != offset)
        i++;
    return (uint8_t)i;
}

int pel_gpio_edges(struct pel_gpio *gpio, struct pel_gpio_edge *edges, int most,
                   bool *lost)
{
    struct lines *lines = gpio->request;
    *lost = false;
    int n = gpiod_line_request_wait_edge_events(lines->request, 0);
    if (n > 0)
        n = gpiod_line_request_read_edge_events(
            lines->request, lines->buffer,
            (size_t)(most < EDGES ? most : EDGES));
    for (int i = 0; i < n; i++) {
        struct gpiod_edge_event *e =
            gpiod_edge_event_buffer_get_event(lines->buffer, (unsigned long)i);
        const uint32_t number = (uint32_t)gpiod_edge_event_get_global_seqno(e);
        *lost = *lost || number != gpio->sequence + 1;
        gpio->sequence = number;
        edges[i] = (struct pel_gpio_edge){
            .time = gpiod_edge_event_get_timestamp_ns(e),
            .line = line_at(gpio, gpiod_edge_event_get_line_offset(e)),
            .active = gpiod_edge_event_get_event_type(e) ==
                      GPIOD_EDGE_EVENT_RISING_EDGE};
    }
    return n >= 0 ? n : errno == EINTR ? 0 : -errno;
}

int pel_gpio_descriptors(const struct pel_gpio *gpio,
                         int descriptors[PEL_GPIO_MOST])
{
    const struct lines *lines = gpio->request;
    descriptors[0] = gpiod_line_request_get_fd(lines->request);
    return 1;
}
