/* A button and an encoder. */
#include "drivers/input_button.h"
#include "drivers/input_encoder.h"

int main(void)
{
    static struct pel_button button = {.code = PEL_KEY_ENTER, .hold = 3};
    static struct pel_encoder knob = {.states = 4};
    static struct pel_input event;
    int told = 0;
    for (uint32_t time = 0; time < 16; time++) {
        told += pel_button_update(&button, time & 4, time, &event);
        told += pel_encoder_update(&knob, time & 2, (time + 1) & 2);
    }
    return told == 0;
}
