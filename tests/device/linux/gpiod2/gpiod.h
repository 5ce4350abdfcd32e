/* What port/linux/gpio.c and gpio_v2.c need of libgpiod 2, by its documentation
 * (core API, 2.1), on the kernel's second interface: a stand-in where only
 * version 1 is packaged. */
#ifndef TESTS_GPIOD2_H
#define TESTS_GPIOD2_H

#include <errno.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <poll.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum gpiod_line_value {
    GPIOD_LINE_VALUE_ERROR = -1,
    GPIOD_LINE_VALUE_INACTIVE = 0,
    GPIOD_LINE_VALUE_ACTIVE = 1
};
enum gpiod_line_direction {
    GPIOD_LINE_DIRECTION_INPUT = 2,
    GPIOD_LINE_DIRECTION_OUTPUT
};
enum gpiod_line_edge { GPIOD_LINE_EDGE_BOTH = 4 };
enum gpiod_line_bias {
    GPIOD_LINE_BIAS_DISABLED = 3,
    GPIOD_LINE_BIAS_PULL_UP,
    GPIOD_LINE_BIAS_PULL_DOWN
};
enum gpiod_edge_event_type {
    GPIOD_EDGE_EVENT_RISING_EDGE = 1,
    GPIOD_EDGE_EVENT_FALLING_EDGE
};

struct gpiod_chip {
    int fd;
};
struct gpiod_chip_info {
    struct gpiochip_info info;
};
struct gpiod_line_info {
    struct gpio_v2_line_info info;
};
struct gpiod_line_settings {
    uint64_t flags;
    uint32_t debounce;
};
struct gpiod_line_config {
    struct gpio_v2_line_request request;
};
struct gpiod_request_config {
    char consumer[GPIO_MAX_NAME_SIZE];
    size_t event_buffer_size;
};
struct gpiod_line_request {
    struct gpio_v2_line_request request;
};
struct gpiod_edge_event {
    struct gpio_v2_line_event event;
};
struct gpiod_edge_event_buffer {
    size_t capacity;
    struct gpiod_edge_event events[];
};

#define GPIOD_NEW(type)                         \
    static inline struct type *type##_new(void) \
    {                                           \
        return calloc(1, sizeof(struct type));  \
    }
#define GPIOD_FREE(type)                             \
    static inline void type##_free(struct type *old) \
    {                                                \
        free(old);                                   \
    }
GPIOD_FREE(gpiod_chip_info)
GPIOD_FREE(gpiod_line_info)
GPIOD_NEW(gpiod_line_settings)
GPIOD_FREE(gpiod_line_settings)
GPIOD_NEW(gpiod_line_config)
GPIOD_FREE(gpiod_line_config)
GPIOD_NEW(gpiod_request_config)
GPIOD_FREE(gpiod_request_config)
GPIOD_FREE(gpiod_edge_event_buffer)

#define GPIOD_GET(result, name, type, value)   \
    static inline result name(struct type *of) \
    {                                          \
        return value;                          \
    }
GPIOD_GET(const char *, gpiod_chip_info_get_label, gpiod_chip_info,
          of->info.label)
GPIOD_GET(size_t, gpiod_chip_info_get_num_lines, gpiod_chip_info,
          of->info.lines)
GPIOD_GET(bool, gpiod_line_info_is_used, gpiod_line_info,
          (of->info.flags & GPIO_V2_LINE_FLAG_USED) != 0)
GPIOD_GET(const char *, gpiod_line_info_get_consumer, gpiod_line_info,
          of->info.consumer[0] ? of->info.consumer : NULL)
GPIOD_GET(int, gpiod_line_request_get_fd, gpiod_line_request, of->request.fd)
GPIOD_GET(uint64_t, gpiod_edge_event_get_timestamp_ns, gpiod_edge_event,
          of->event.timestamp_ns)
GPIOD_GET(unsigned int, gpiod_edge_event_get_line_offset, gpiod_edge_event,
          of->event.offset)
GPIOD_GET(unsigned long, gpiod_edge_event_get_global_seqno, gpiod_edge_event,
          of->event.seqno)
GPIOD_GET(enum gpiod_edge_event_type, gpiod_edge_event_get_event_type,
          gpiod_edge_event,
          of->event.id == GPIO_V2_LINE_EVENT_RISING_EDGE
              ? GPIOD_EDGE_EVENT_RISING_EDGE
              : GPIOD_EDGE_EVENT_FALLING_EDGE)

static inline void gpiod_chip_close(struct gpiod_chip *chip)
{
    const int error = errno;
    if (chip->fd >= 0)
        close(chip->fd);
    free(chip);
    errno = error;
}

static inline struct gpiod_chip *gpiod_chip_open(const char *path)
{
    struct gpiod_chip *chip = calloc(1, sizeof(*chip));
    struct gpiochip_info info;
    if (!chip)
        return NULL;
    chip->fd = open(path, O_RDWR | O_CLOEXEC);
    if (chip->fd >= 0 && ioctl(chip->fd, GPIO_GET_CHIPINFO_IOCTL, &info) == 0)
        return chip;
    gpiod_chip_close(chip);
    return NULL;
}

/* A copy of what an ioctl tells, to be freed. */
static inline void *gpiod_ask(int fd, unsigned long what, const void *question,
                              size_t size)
{
    void *answer = malloc(size);
    if (!answer)
        return NULL;
    memcpy(answer, question, size);
    if (ioctl(fd, what, answer) == 0)
        return answer;
    free(answer);
    return NULL;
}

static inline struct gpiod_chip_info *gpiod_chip_get_info(
    struct gpiod_chip *chip)
{
    const struct gpiod_chip_info nothing = {{{0}, {0}, 0}};
    return gpiod_ask(chip->fd, GPIO_GET_CHIPINFO_IOCTL, &nothing,
                     sizeof(nothing));
}

static inline struct gpiod_line_info *gpiod_chip_get_line_info(
    struct gpiod_chip *chip, unsigned int offset)
{
    struct gpiod_line_info question;
    memset(&question, 0, sizeof(question));
    question.info.offset = offset;
    return gpiod_ask(chip->fd, GPIO_V2_GET_LINEINFO_IOCTL, &question,
                     sizeof(question));
}

static inline int gpiod_chip_get_line_offset_from_name(struct gpiod_chip *chip,
                                                       const char *name)
{
    for (unsigned i = 0;; i++) {
        struct gpiod_line_info *info = gpiod_chip_get_line_info(chip, i);
        if (!info)
            return -1;
        const bool found = strcmp(info->info.name, name) == 0;
        free(info);
        if (found)
            return (int)i;
    }
}

static inline int gpiod_line_settings_set_direction(
    struct gpiod_line_settings *settings, enum gpiod_line_direction direction)
{
    settings->flags |= direction == GPIOD_LINE_DIRECTION_OUTPUT
                           ? GPIO_V2_LINE_FLAG_OUTPUT
                           : GPIO_V2_LINE_FLAG_INPUT;
    return 0;
}

static inline int gpiod_line_settings_set_edge_detection(
    struct gpiod_line_settings *settings, enum gpiod_line_edge edge)
{
    if (edge == GPIOD_LINE_EDGE_BOTH)
        settings->flags |=
            GPIO_V2_LINE_FLAG_EDGE_RISING | GPIO_V2_LINE_FLAG_EDGE_FALLING;
    return 0;
}

static inline int gpiod_line_settings_set_bias(
    struct gpiod_line_settings *settings, enum gpiod_line_bias bias)
{
    settings->flags |=
        bias == GPIOD_LINE_BIAS_PULL_UP     ? GPIO_V2_LINE_FLAG_BIAS_PULL_UP
        : bias == GPIOD_LINE_BIAS_PULL_DOWN ? GPIO_V2_LINE_FLAG_BIAS_PULL_DOWN
                                            : GPIO_V2_LINE_FLAG_BIAS_DISABLED;
    return 0;
}

static inline void gpiod_line_settings_set_active_low(
    struct gpiod_line_settings *settings, bool active_low)
{
    if (active_low)
        settings->flags |= GPIO_V2_LINE_FLAG_ACTIVE_LOW;
}

static inline void gpiod_line_settings_set_debounce_period_us(
    struct gpiod_line_settings *settings, unsigned long period)
{
    settings->debounce = (uint32_t)period;
}

static inline int gpiod_line_config_add_line_settings(
    struct gpiod_line_config *config, const unsigned int *offsets,
    size_t num_offsets, struct gpiod_line_settings *settings)
{
    struct gpio_v2_line_request *request = &config->request;
    struct gpio_v2_line_config *lines = &request->config;
    const uint64_t of_these = ((uint64_t)1 << num_offsets) - 1;
    const uint32_t first = request->num_lines;
    uint32_t i = 0;
    memcpy(request->offsets + first, offsets, num_offsets * sizeof(*offsets));
    request->num_lines += (uint32_t)num_offsets;
    lines->flags = settings->flags;
    while (i < lines->num_attrs &&
           lines->attrs[i].attr.debounce_period_us != settings->debounce)
        i++;
    if (!settings->debounce)
        return 0;
    lines->num_attrs += i == lines->num_attrs;
    lines->attrs[i].mask |= of_these << first;
    lines->attrs[i].attr.id = GPIO_V2_LINE_ATTR_ID_DEBOUNCE;
    lines->attrs[i].attr.debounce_period_us = settings->debounce;
    return 0;
}

static inline void gpiod_request_config_set_event_buffer_size(
    struct gpiod_request_config *config, size_t size)
{
    config->event_buffer_size = size;
}

static inline void gpiod_request_config_set_consumer(
    struct gpiod_request_config *config, const char *consumer)
{
    strncpy(config->consumer, consumer, sizeof(config->consumer) - 1);
}

static inline struct gpiod_line_request *gpiod_chip_request_lines(
    struct gpiod_chip *chip, struct gpiod_request_config *request,
    struct gpiod_line_config *lines)
{
    struct gpiod_line_request question = {lines->request};
    memcpy(question.request.consumer, request->consumer,
           sizeof(question.request.consumer));
    question.request.event_buffer_size = (uint32_t)request->event_buffer_size;
    return gpiod_ask(chip->fd, GPIO_V2_GET_LINE_IOCTL, &question,
                     sizeof(question));
}

static inline void gpiod_line_request_release(
    struct gpiod_line_request *request)
{
    close(request->request.fd);
    free(request);
}

static inline int gpiod_line_request_get_values(
    struct gpiod_line_request *request, enum gpiod_line_value *values)
{
    const uint32_t n = request->request.num_lines;
    struct gpio_v2_line_values v = {.mask = ((uint64_t)1 << n) - 1};
    if (ioctl(request->request.fd, GPIO_V2_LINE_GET_VALUES_IOCTL, &v))
        return -1;
    for (uint32_t i = 0; i < n; i++)
        values[i] = v.bits >> i & 1 ? GPIOD_LINE_VALUE_ACTIVE
                                    : GPIOD_LINE_VALUE_INACTIVE;
    return 0;
}

static inline int gpiod_line_request_set_value(
    struct gpiod_line_request *request, unsigned int offset,
    enum gpiod_line_value value)
{
    uint32_t i = 0;
    while (request->request.offsets[i] != offset)
        i++;
    struct gpio_v2_line_values v = {.mask = (uint64_t)1 << i,
                                    .bits = (uint64_t)value << i};
    return ioctl(request->request.fd, GPIO_V2_LINE_SET_VALUES_IOCTL, &v);
}

static inline int gpiod_line_request_wait_edge_events(
    struct gpiod_line_request *request, int64_t timeout_ns)
{
    struct pollfd line = {.fd = request->request.fd, .events = POLLIN};
    return poll(&line, 1, (int)(timeout_ns / 1000000));
}

static inline int gpiod_line_request_read_edge_events(
    struct gpiod_line_request *request, struct gpiod_edge_event_buffer *buffer,
    size_t max_events)
{
    const size_t size = sizeof(buffer->events[0]);
    if (max_events > buffer->capacity)
        max_events = buffer->capacity;
    const ssize_t n =
        read(request->request.fd, buffer->events, max_events * size);
    return n < 0 ? -1 : (int)((size_t)n / size);
}

static inline struct gpiod_edge_event_buffer *gpiod_edge_event_buffer_new(
    size_t capacity)
{
    struct gpiod_edge_event_buffer *buffer =
        calloc(1, sizeof(*buffer) + capacity * sizeof(buffer->events[0]));
    if (buffer)
        buffer->capacity = capacity;
    return buffer;
}

static inline struct gpiod_edge_event *gpiod_edge_event_buffer_get_event(
    struct gpiod_edge_event_buffer *buffer, unsigned long index)
{
    return &buffer->events[index];
}

#endif
