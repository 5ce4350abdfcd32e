#include "input_encoder.h"

/* Steps between two states, `last` * 4 + now; clockwise is 0, 2, 3, 1, 0. 2: it
 * cannot be told which way. */
static const int8_t steps[16] = {0,  -1, 1, 2, 1, 0, 2,  -1,
                                 -1, 2,  0, 1, 2, 1, -1, 0};

int pel_encoder_update(struct pel_encoder *encoder, bool a, bool b)
{
    const int now = a * 2 + b, states = encoder->states;
    const bool detent = now == 0 || (now == 3 && states == 2);
    int step = steps[encoder->last * 4 + now], turned = 0;
    if (step == 2 && encoder->steps <= 0)
        step = encoder->steps < 0 ? -2 : 0;
    step += encoder->steps;
    /* At a detent more than half of the way counts, less is a contact that came
     * back; elsewhere more than all of it is a detent that nobody saw. */
    const int most = detent ? (states - 1) / 2 : states;
    if (step > most)
        turned = 1;
    else if (step < -most)
        turned = -1;
    encoder->last = (uint8_t)now;
    encoder->steps = (int8_t)(detent ? 0 : step - turned * states);
    return turned;
}
