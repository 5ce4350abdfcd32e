/* From reset to main: memory, the clocks of the SDK (125 MHz from a crystal of
 * 12), a table of interrupts; and the serial line. Needs no C library; the
 * symbols come from ../cortex_m/sections.ld. After the RP2040 data sheet:
 * clocks 2.15, PLL 2.18, oscillator 2.16, ticks 4.7.2, UART 4.2. */
#include "board.h"
#include "registers.inc"

enum { OSCILLATOR = 0x40024000, PLL = 0x40028000, CLOCKS = 0x40008000 };
enum { UART = 0x40034000, TIME = 0x40054028, TICK = 0x4005802C };

extern uint32_t data_load[], data_begin[], data_end[];
extern uint32_t bss_begin[], bss_end[], stack_top[];
int main(void);
void reset(void);

/* 12 MHz * 125 / 6 / 2. */
static void start_pll(void)
{
    start_parts(1 << 12);
    REGISTER(PLL) = 1;
    REGISTER(PLL + 8) = 125;
    BITS_CLEAR(PLL + 4) = 1 << 5 | 1; /* power of the PLL and its oscillator, */
    while (!(REGISTER(PLL) >> 31))
        continue;
    REGISTER(PLL + 12) = 6 << 16 | 2 << 12;
    BITS_CLEAR(PLL + 4) = 1 << 3; /* then of the dividers */
}

static void start_clocks(void)
{
    REGISTER(OSCILLATOR + 12) = 47; /* 1 ms to swing in */
    REGISTER(OSCILLATOR) = 0xFABAA0;
    while (!(REGISTER(OSCILLATOR + 4) >> 31))
        continue;
    start_pll();
    REGISTER(CLOCKS + 0x30) = 2; /* reference: the crystal */
    while (REGISTER(CLOCKS + 0x38) != 1 << 2)
        continue;
    REGISTER(CLOCKS + 0x3C) = 0; /* system: the reference, */
    while (REGISTER(CLOCKS + 0x44) != 1)
        continue;
    REGISTER(CLOCKS + 0x3C) = 1; /* then the PLL */
    while (REGISTER(CLOCKS + 0x44) != 1 << 1)
        continue;
    REGISTER(CLOCKS + 0x48) = 1 << 11; /* peripherals: the system's */
    REGISTER(TICK) = 1 << 9 | 12;      /* microseconds of the crystal's */
}

/* 115,200 baud: 125,000,000 / 16 / (67 + 52/64). */
static void start_text(void)
{
    start_parts(PART_PINS | PART_PADS | PART_TIMER | PART_UART0);
    set_pin(0, FUNCTION_UART, 0);
    REGISTER(UART + 0x24) = 67;
    REGISTER(UART + 0x28) = 52;
    REGISTER(UART + 0x2C) = 7 << 4; /* 8 bits, a queue */
    REGISTER(UART + 0x30) = 3 << 8 | 1;
}

void board_write(const char *text)
{
    for (; *text; text++) {
        while (REGISTER(UART + 0x18) & 1 << 5) /* its queue is full */
            continue;
        REGISTER(UART) = (uint8_t)*text;
    }
}

void board_write_number(int32_t n)
{
    char digits[12], *p = digits + sizeof digits - 1;
    uint32_t rest = n < 0 ? 0 - (uint32_t)n : (uint32_t)n;
    *p = 0;
    do
        *--p = (char)('0' + rest % 10);
    while (rest /= 10);
    if (n < 0)
        *--p = '-';
    board_write(p);
}

uint32_t board_time(void)
{
    return REGISTER(TIME);
}

void board_sleep(uint32_t us)
{
    for (const uint32_t from = board_time(); board_time() - from <= us;)
        continue;
}

void reset(void)
{
    /* volatile: a compiler makes calls to memcpy and memset of such loops. */
    const uint32_t *from = data_load;
    for (volatile uint32_t *to = data_begin; to < data_end; to++)
        *to = *from++;
    for (volatile uint32_t *to = bss_begin; to < bss_end; to++)
        *to = 0;
    start_clocks();
    start_text();
    main();
    for (;;)
        continue;
}

static void unexpected(void)
{
    board_write("unexpected interrupt\n");
    for (;;)
        continue;
}

/* Of the interrupts of the chip (2.3.2) those that this folder uses, by the
 * names of the SDK: timer 0, DMA, pins. */
void isr_irq0(void);
void isr_irq11(void);
void isr_irq13(void);

typedef void (*vector)(void);
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    vector exception[15];
    vector interrupt[14];
} vectors = {stack_top,
             {reset, unexpected, unexpected, 0, 0, 0, 0, 0, 0, 0, unexpected, 0,
              0, unexpected, unexpected},
             {isr_irq0, unexpected, unexpected, unexpected, unexpected,
              unexpected, unexpected, unexpected, unexpected, unexpected,
              unexpected, isr_irq11, unexpected, isr_irq13}};
