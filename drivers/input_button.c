#include "input_button.h"

bool pel_button_update(struct pel_button *button, bool level, uint32_t time,
                       struct pel_input *event)
{
    if (level != button->level) {
        button->level = level;
        button->since = time;
    }
    if (level == button->pressed || time - button->since < button->hold)
        return false;
    button->pressed = level;
    event->time = button->since;
    event->kind = PEL_INPUT_KEY;
    event->state = level;
    event->code = button->code;
    event->x = event->y = 0;
    return true;
}
