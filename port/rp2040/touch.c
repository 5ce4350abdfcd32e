/* A touch controller at SPI1 (RP2040 data sheet, 4.4): commands and answers. */
#include "board.h"
#include "registers.inc"

enum { SPI = 0x40040000, DATA = 8, STATUS = 12, CS = 1 << 9 };

static uint8_t exchange(uint8_t byte)
{
    REGISTER(SPI + DATA) = byte;
    while (!(REGISTER(SPI + STATUS) & 1 << 2)) /* nothing has come */
        continue;
    return (uint8_t)REGISTER(SPI + DATA);
}

static enum pel_status touch_command(const struct pel_bus *bus,
                                     const uint8_t *bytes, size_t n,
                                     uint8_t *answer, size_t answers)
{
    (void)bus;
    REGISTER(0xD0000018) = CS;
    for (; n > 0; n--)
        exchange(*bytes++);
    for (; answers > 0; answers--)
        *answer++ = exchange(0);
    REGISTER(0xD0000014) = CS;
    return PEL_OK;
}

static enum pel_status touch_pause(const struct pel_bus *bus, bool reset,
                                   uint32_t ms)
{
    (void)bus, (void)reset;
    board_sleep(1000 * ms);
    return PEL_OK;
}

const struct pel_bus board_touch = {NULL, touch_command, NULL, touch_pause,
                                    NULL};

void board_touch_start(void)
{
    start_parts(PART_PINS | PART_PADS | PART_SPI1);
    for (int pin = 8; pin <= 11; pin++)
        set_pin(pin, pin == 9 ? FUNCTION_SIO : FUNCTION_SPI, 0);
    REGISTER(0xD0000014) = CS;
    REGISTER(0xD0000024) = CS;
    REGISTER(SPI + 0x10) = 64; /* 125 MHz / 64 = 1.95 MHz */
    REGISTER(SPI) = 7;         /* 8 bits, mode 0 */
    REGISTER(SPI + 4) = 1 << 1;
}
