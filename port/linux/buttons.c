#include "buttons.h"

#include <errno.h>
#include <string.h>

#include "evdev.h"

enum { MOST_EDGES = PEL_GPIO_MOST * 32 };

/* Tells a part the levels of its lines, of which one is `line`. */
static void update(struct pel_buttons *b, int line, uint32_t time,
                   struct pel_input_queue *queue)
{
    struct pel_buttons_part *part = &b->parts[line];
    struct pel_input event;
    if (!part->is_encoder) {
        if (pel_button_update(&part->button, b->active >> line & 1, time,
                              &event))
            pel_input_push(queue, &event);
        return;
    }
    if (part->is_b)
        part = &b->parts[--line];
    const int turned = pel_encoder_update(&part->encoder, b->active >> line & 1,
                                          b->active >> (line + 1) & 1);
    event = (struct pel_input){.time = time,
                               .kind = PEL_INPUT_WHEEL,
                               .x = (int16_t)(part->is_x ? turned : 0),
                               .y = (int16_t)(part->is_x ? 0 : turned)};
    if (turned)
        pel_input_push(queue, &event);
}

int pel_buttons_open(struct pel_buttons *b, struct pel_message *message)
{
    int error = pel_gpio_open(&b->gpio, &b->request, message);
    if (error == ENOENT && b->request.chip && b->label[0]) {
        struct pel_gpio_request again = b->request;
        again.chip = b->label;
        error = pel_gpio_open(&b->gpio, &again, message);
    }
    if (error)
        return error;
    memcpy(b->label, b->gpio.label, sizeof(b->label));
    do
        error = pel_gpio_levels(&b->gpio, &b->active);
    while (error == EINTR);
    if (error) {
        errno = error;
        pel_message_errno(message, b->gpio.path);
        pel_gpio_close(&b->gpio);
        return error;
    }
    b->active ^= b->closed;
    b->encoders = 0;
    for (int i = 0; i < b->request.count; i++) {
        struct pel_buttons_part *part = &b->parts[i];
        b->encoders |= (uint32_t)part->is_encoder << i;
        if (b->gpio.debounces)
            part->button.hold = 0;
        part->encoder.steps = 0;
        part->encoder.last =
            (uint8_t)((b->active >> i & 1) * 2 + (b->active >> i >> 1 & 1));
    }
    b->open = true;
    return 0;
}

void pel_buttons_close(struct pel_buttons *b)
{
    if (b->open)
        pel_gpio_close(&b->gpio);
    b->open = false;
}

/* The chip is gone: nothing is held any more. */
static int vanish(struct pel_buttons *b, struct pel_input_queue *queue)
{
    pel_buttons_close(b);
    b->active = 0;
    for (int i = 0; i < b->request.count; i++) {
        struct pel_button *button = &b->parts[i].button;
        if (button->pressed)
            pel_input_push_now(queue, PEL_INPUT_KEY, PEL_INPUT_UP,
                               button->code);
        button->pressed = button->level = false;
    }
    return -1;
}

/* ms until the first of the levels that do not count yet may count. */
static int next_time(const struct pel_buttons *b, uint32_t now)
{
    int next = -1;
    for (int i = 0; i < b->request.count; i++) {
        const struct pel_button *button = &b->parts[i].button;
        const uint32_t passed = now - button->since;
        if (b->parts[i].is_encoder || button->level == button->pressed)
            continue;
        const int left =
            passed < button->hold ? (int)(button->hold - passed) : 0;
        next = next < 0 || left < next ? left : next;
    }
    return next;
}

/* Edges tell each state of an encoder on the way. A button's level is read
 * again after them, so that none is missed for ever; and so are all where edges
 * are missing. */
int pel_buttons_read(struct pel_buttons *b, struct pel_input_queue *queue)
{
    struct pel_gpio_edge edges[MOST_EDGES];
    uint32_t active;
    bool lost;
    if (!b->open)
        return -1;
    const int n = pel_gpio_edges(&b->gpio, edges, MOST_EDGES, &lost);
    for (int i = 0; i < n; i++) {
        const uint32_t bit = (uint32_t)1 << edges[i].line;
        b->active = edges[i].active ? b->active | bit : b->active & ~bit;
        b->active ^= bit & b->closed;
        update(b, edges[i].line, (uint32_t)(edges[i].time / 1000000), queue);
    }
    const int error = n < 0 ? -n : pel_gpio_levels(&b->gpio, &active);
    const uint32_t now = pel_linux_milliseconds();
    if (error)
        return error == EINTR ? 0 : vanish(b, queue);
    active ^= b->closed;
    if (lost)
        pel_input_push_now(queue, PEL_INPUT_LOST, 0, 0);
    else
        active = (active & ~b->encoders) | (b->active & b->encoders);
    b->active = active;
    lost = pel_input_lost(queue, &b->losses);
    for (int i = 0; i < b->request.count; i++) {
        b->parts[i].button.pressed &= !lost;
        update(b, i, now, queue);
    }
    return next_time(b, now);
}
