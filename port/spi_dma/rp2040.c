/* RP2040 at 125 MHz, as its SDK's start-up code or port/rp2040 leaves it: SPI0
 * at 62.5 MHz with channel 0 of the DMA. SCK is GPIO 18, MOSI 19, CS 17, D/C
 * 20, RST 21. Addresses + 0x2000 set bits, + 0x3000 clear them. After the
 * RP2040 data sheet: SIO 2.3.1.7, DMA 2.5.7, resets 2.14, pins 2.19.2, SPI 4.4.
 */
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define PINS_HIGH REGISTER(0xD0000014)
#define PINS_LOW REGISTER(0xD0000018)
#define PINS_OUT REGISTER(0xD0000024)
#define PIN_FUNCTION(pin) REGISTER(0x40014004 + 8 * (pin))
#define RESETS_CLEAR REGISTER(0x4000F000)
#define RESETS_DONE REGISTER(0x4000C008)
#define SPI_CR0 REGISTER(0x4003C000)
#define SPI_CR1 REGISTER(0x4003C004)
#define SPI_DR REGISTER(0x4003C008)
#define SPI_SR REGISTER(0x4003C00C)
#define SPI_DIVISOR REGISTER(0x4003C010)
#define SPI_DMA REGISTER(0x4003C024)
#define DMA_FROM REGISTER(0x50000000)
#define DMA_TO REGISTER(0x50000004)
#define DMA_COUNT REGISTER(0x50000008)
#define DMA_CONTROL REGISTER(0x5000000C)
#define DMA_ENABLE REGISTER(0x50000404)
#define DMA_STATUS REGISTER(0x5000040C)
#define DMA_ABORT REGISTER(0x50000444)
#define TIME REGISTER(0x40054028) /* microseconds */
#define INTERRUPTS REGISTER(0xE000E100)
#define HIGH(pins) (PINS_HIGH = (pins))
#define LOW(pins) (PINS_LOW = (pins))

enum { SCK = 18, MOSI = 19 };
enum { CS = 1 << 17, DC = 1 << 20, RST = 1 << 21 };
enum { DMA = 1 << 2, PINS = 1 << 5, PADS = 1 << 8 };
enum { SPI = 1 << 16, TIMER = 1 << 21 };
enum { MOST = INT32_MAX };

static void drain(void)
{
    while (SPI_SR & 1 << 4)
        continue;
}

static void send_byte(uint8_t byte)
{
    SPI_DR = byte;
    drain();
}

/* Enabled, bytes, reads move on, paced by SPI0; chained to itself: to none. */
static void dma_send(const uint8_t *bytes, int32_t n)
{
    DMA_FROM = (uint32_t)(uintptr_t)bytes;
    DMA_COUNT = (uint32_t)n;
    DMA_CONTROL = 1 | 1 << 4 | 0 << 11 | 16 << 15;
}

static void dma_stop(void)
{
    DMA_ABORT = 1;
    while (DMA_ABORT & 1)
        continue;
}

static void sleep_ms(uint32_t ms)
{
    for (const uint32_t from = TIME; TIME - from <= 1000 * ms;)
        continue;
}

#include "spi_dma.inc"

/* DMA_IRQ_0, by the name that it has in the SDK's table. */
void isr_irq11(void);
void isr_irq11(void)
{
    DMA_STATUS = 1;
    piece_sent(DMA_CONTROL >> 29 != 0);
}

void board_start(void);
void board_start(void)
{
    const uint32_t parts = DMA | PINS | PADS | SPI | TIMER;
    RESETS_CLEAR = parts;
    while ((RESETS_DONE & parts) != parts)
        continue;
    PINS_HIGH = CS | DC | RST;
    PINS_OUT = CS | DC | RST;
    PIN_FUNCTION(SCK) = PIN_FUNCTION(MOSI) = 1;                 /* SPI */
    PIN_FUNCTION(17) = PIN_FUNCTION(20) = PIN_FUNCTION(21) = 5; /* outputs */
    SPI_DIVISOR = 2;
    SPI_CR0 = 7; /* 8 bits, mode 0 */
    SPI_DMA = 1 << 1;
    SPI_CR1 = 1 << 1;
    DMA_TO = (uint32_t)(uintptr_t)&SPI_DR;
    DMA_ENABLE = 1;
    INTERRUPTS = 1 << 11;
}
