#include "input.h"

static uint16_t after(const struct pel_input_queue *queue, uint16_t i)
{
    return (uint16_t)(i + 1) == queue->size ? 0 : (uint16_t)(i + 1);
}

/* One place stays free, so that a full queue differs from an empty one. The
 * last one is for PEL_INPUT_LOST, which stands for all that come while it is
 * taken. */
bool pel_input_push(struct pel_input_queue *queue,
                    const struct pel_input *event)
{
    const uint16_t end = queue->end, next = after(queue, end);
    const uint16_t first = queue->first;
    const bool fits = next != first && after(queue, next) != first;
    if (!fits || event->kind == PEL_INPUT_LOST)
        queue->losses = (uint16_t)(queue->losses + 1);
    if (next == first)
        return false;
    queue->events[end] = *event;
    if (!fits)
        queue->events[end].kind = PEL_INPUT_LOST;
    queue->end = next;
    return fits;
}

bool pel_input_lost(const struct pel_input_queue *queue, uint16_t *seen)
{
    const uint16_t now = queue->losses;
    const bool lost = *seen != now;
    *seen = now;
    return lost;
}

bool pel_input_pop(struct pel_input_queue *queue, struct pel_input *event)
{
    const uint16_t first = queue->first;
    if (first == queue->end)
        return false;
    *event = queue->events[first];
    queue->first = after(queue, first);
    return true;
}

int pel_input_room(const struct pel_input_queue *queue)
{
    const int held = queue->end - queue->first;
    const int room = queue->size - 2 - (held < 0 ? held + queue->size : held);
    return room < 0 ? 0 : room;
}
