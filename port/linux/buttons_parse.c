#include "buttons.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "key_names.h"

static int refuse(struct pel_message *message, const char *what,
                  const char *expected)
{
    return pel_message_set(message, EINVAL, "buttons: '%s': expected %s", what,
                           expected);
}

static int add_line(struct pel_buttons *b, const char *line,
                    struct pel_buttons_part part, struct pel_message *message)
{
    if (!*line)
        return refuse(message, line, "a line's number or name before =");
    if (b->request.count == PEL_GPIO_MOST)
        return refuse(message, line, "at most 32 lines");
    b->parts[b->request.count] = part;
    b->request.lines[b->request.count++] = line;
    return 0;
}

static int parse_encoder(struct pel_buttons *b, char *a, char *slash,
                         const char *what, struct pel_message *message)
{
    struct pel_buttons_part part = {.is_encoder = true,
                                    .is_x = strcmp(what, "wheel-x") == 0};
    if (!part.is_x && strcmp(what, "wheel") != 0)
        return refuse(message, what, "wheel or wheel-x");
    *slash = '\0';
    const int error = add_line(b, a, part, message);
    part.is_b = true;
    return error ? error : add_line(b, slash + 1, part, message);
}

/* A number that is set for all lines, or -1. */
static int parse_number(const char *word, const char *text, int low, int high,
                        struct pel_message *message)
{
    char *end;
    const long number = strtol(text, &end, 10);
    if (end != text && !*end && number >= low && number <= high)
        return (int)number;
    return pel_message_set(message, -1, "buttons: %s=%s: expected %d to %d",
                           word, text, low, high);
}

/* Below 0: refused. */
struct settings {
    int debounce, states;
    bool closed;
};

static int parse_use(struct pel_buttons *b, const char *word,
                     struct pel_message *message)
{
    static const char *const uses[] = {[PEL_GPIO_PULL_UP] = "pull-up",
                                       [PEL_GPIO_PULL_DOWN] = "pull-down",
                                       [PEL_GPIO_FLOATING] = "floating"};
    for (int i = 0; i <= PEL_GPIO_FLOATING; i++)
        if (strcmp(word, uses[i]) == 0) {
            b->request.use = (enum pel_gpio_use)i;
            return 0;
        }
    return refuse(message, word,
                  "LINE=KEY, A/B=wheel, pull-up, pull-down, "
                  "floating, debounce=MS, states=4 or closed");
}

static int parse_word(struct pel_buttons *b, char *word,
                      struct settings *settings, struct pel_message *message)
{
    char *value = strchr(word, '='), *slash;
    if (strcmp(word, "closed") == 0) {
        settings->closed = true;
        return 0;
    }
    if (!value)
        return parse_use(b, word, message);
    *value++ = '\0';
    if (strcmp(word, "debounce") == 0) {
        settings->debounce = parse_number(word, value, 0, 1000, message);
        return settings->debounce < 0 ? EINVAL : 0;
    }
    if (strcmp(word, "states") == 0) {
        settings->states = *value - '0';
        return strcmp(value, "2") == 0 || strcmp(value, "4") == 0
                   ? 0
                   : refuse(message, value, "states=2 or states=4");
    }
    slash = strchr(word, '/');
    if (slash)
        return parse_encoder(b, word, slash, value, message);
    const int key = pel_key_find(value);
    if (key < 0)
        return refuse(message, value, "a key: left, enter, f1, space, a, ...");
    return add_line(
        b, word, (struct pel_buttons_part){.button = {.code = (uint16_t)key}},
        message);
}

int pel_buttons_parse(struct pel_buttons *b, const char *text,
                      struct pel_message *message)
{
    struct settings settings = {.debounce = 5, .states = 4};
    char *rest = b->text, *word;
    int error = 0;
    memset(b, 0, sizeof(*b));
    if (strlen(text) >= sizeof(b->text))
        return refuse(message, text, "less");
    memcpy(b->text, text, strlen(text) + 1);
    word = strchr(rest, ':');
    if (word) {
        *word = '\0';
        b->request.chip = rest;
        rest = word + 1;
    }
    while (!error && (word = strsep(&rest, ",")) != NULL)
        error = parse_word(b, word, &settings, message);
    if (!error && b->request.count == 0)
        return refuse(message, text, "gpiochip0:5=left,6=right or the like");
    b->request.debounce = (uint32_t)settings.debounce * 1000;
    for (int i = 0; i < b->request.count; i++) {
        const uint32_t bit = (uint32_t)1 << i;
        b->parts[i].button.hold = (uint16_t)settings.debounce;
        b->parts[i].encoder.states = (uint8_t)settings.states;
        if (!b->parts[i].is_encoder)
            continue;
        b->request.bounces |= bit;
        b->closed |= settings.closed ? bit : 0;
    }
    return error;
}
