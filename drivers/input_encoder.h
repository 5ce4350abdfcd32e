/* Rotary encoders: two contacts, A and B, that close one after the other. From
 * one detent to the next they pass 4 states (2 with some makes), in an order
 * that tells the direction; a contact that bounces goes back and forth between
 * two states, which adds up to nothing.
 *
 *     static struct pel_encoder knob = {.states = 4};
 *
 *     every millisecond at most, or at each edge of A and B:
 *         turned = pel_encoder_update(&knob, a_is_low(), b_is_low());
 */
#ifndef PEL_DRIVERS_INPUT_ENCODER_H
#define PEL_DRIVERS_INPUT_ENCODER_H

#include "input.h"

PEL_BEGIN_DECLS

struct pel_encoder {
    uint8_t states; /* from detent to detent: 4, or 2 */
    uint8_t last;   /* contacts: bit 1 A is closed, bit 0 B */
    int8_t steps;   /* since the last detent */
};

/* Tells the contacts (true: closed). 1: a detent clockwise, where A closes
 * before B; -1: one counter-clockwise; 0: none yet. A detent has both open, or
 * of 2 states both closed, too. Contacts that both changed since the last call
 * went on as before; whatever was missed, the count begins anew at the next
 * detent, so it never comes to lie between two. */
int pel_encoder_update(struct pel_encoder *encoder, bool a, bool b);

PEL_END_DECLS
#endif
