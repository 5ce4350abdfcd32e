/* The lines of docs/guide.md that take a finger's place: the last one on the
 * glass, not where another kind of event was. */
#include <pel/pel.h>
#include "drivers/input.h"

int main(void)
{
    static struct pel_input events[8];
    static struct pel_input_queue queue = PEL_INPUT_QUEUE(events);
    static const struct pel_input told[] = {
        {.kind = PEL_INPUT_TOUCH, .state = PEL_INPUT_DOWN, .x = 7, .y = 9},
        {.kind = PEL_INPUT_TOUCH, .state = PEL_INPUT_AGAIN, .x = 94, .y = 26},
        {.kind = PEL_INPUT_TOUCH, .state = PEL_INPUT_UP, .x = 90, .y = 20},
        {.kind = PEL_INPUT_POINT, .x = 1, .y = 2}};
    struct pel_input event;
    struct pel_point finger = {0, 0};
    for (size_t i = 0; i < sizeof told / sizeof *told; i++)
        pel_input_push(&queue, &told[i]);
#include "touch.inc"
    return finger.x != PEL_PX(94) || finger.y != PEL_PX(26);
}
