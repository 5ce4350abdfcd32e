/* Contacts at pins, and the interrupts that look at them: a timer's alarm
 * (RP2040 data sheet, 4.6) and the edges of two pins (2.19.3). */
#include "board.h"
#include "registers.inc"

enum { TIMER = 0x40054000, PINS = 0x40014000, BOTH_EDGES = 12 };

/* Of A and B in a register with 4 bits for each of 8 pins. */
enum {
    EDGES = BOTH_EDGES << 4 * (BOARD_A % 8) | BOTH_EDGES << 4 * (BOARD_B % 8)
};

bool board_closed(int pin)
{
    return !(REGISTER(0xD0000004) >> pin & 1);
}

/* An alarm that is set when its time has passed comes 71 minutes later. */
void isr_irq0(void);
void isr_irq0(void)
{
    const uint32_t next = REGISTER(TIMER + 0x10) + 1000;
    const int32_t left = (int32_t)(next - board_time());
    REGISTER(TIMER + 0x34) = 1;
    REGISTER(TIMER + 0x10) = left > 100 ? next : board_time() + 1000;
    board_millisecond();
}

void isr_irq13(void);
void isr_irq13(void)
{
    REGISTER(PINS + 0xF4) = EDGES;
    board_edge();
}

void board_inputs_start(void)
{
    start_parts(PART_PINS | PART_PADS | PART_TIMER);
    set_pin(BOARD_BUTTON, FUNCTION_SIO, 1);
    set_pin(BOARD_A, FUNCTION_SIO, 1);
    set_pin(BOARD_B, FUNCTION_SIO, 1);
    REGISTER(PINS + 0xF4) = EDGES;
    REGISTER(PINS + 0x104) = EDGES;
    REGISTER(TIMER + 0x38) = 1;
    REGISTER(TIMER + 0x10) = board_time() + 1000;
    REGISTER(0xE000E100) = 1 << 13 | 1;
}
