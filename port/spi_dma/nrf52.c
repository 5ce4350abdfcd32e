/* nRF52832 or nRF52840: SPIM2 at 8 MHz, which has a DMA of its own for RAM (not
 * for pictures in flash). SCK is P0.03, MOSI P0.04, CS P0.28, D/C P0.29, RST
 * P0.30. After the nRF52832 product specification. */
#include <stdbool.h>
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define PINS_HIGH REGISTER(0x50000508)
#define PINS_LOW REGISTER(0x5000050C)
#define PINS_OUT REGISTER(0x50000518)
#define SPI_START REGISTER(0x40023010)
#define SPI_STOP REGISTER(0x40023014)
#define SPI_ENDED REGISTER(0x40023118)
#define SPI_INTERRUPT REGISTER(0x40023304)
#define SPI_NO_INTERRUPT REGISTER(0x40023308)
#define SPI_ENABLE REGISTER(0x40023500)
#define SPI_SCK REGISTER(0x40023508)
#define SPI_MOSI REGISTER(0x4002350C)
#define SPI_FREQUENCY REGISTER(0x40023524)
#define SPI_FROM REGISTER(0x40023544)
#define SPI_COUNT REGISTER(0x40023548)
#define INTERRUPTS REGISTER(0xE000E104) /* 32 to 63 */
#define HIGH(pins) (PINS_HIGH = (pins))
#define LOW(pins) (PINS_LOW = (pins))
#define TICKS 64000

enum { SCK = 3, MOSI = 4, ENDED = 1 << 6 };
enum { CS = 1 << 28, DC = 1 << 29, RST = 1 << 30 };
enum { MOST = 255 }; /* of an nRF52840 65535 */

static void begin(const uint8_t *bytes, int32_t n)
{
    SPI_ENDED = 0;
    SPI_FROM = (uint32_t)(uintptr_t)bytes;
    SPI_COUNT = (uint32_t)n;
    SPI_START = 1;
}

/* Its end is that of the last bit. */
static void drain(void)
{
    while (!SPI_ENDED)
        continue;
}

static void send_byte(uint8_t byte)
{
    static volatile uint8_t copy; /* in RAM */
    copy = byte;
    begin((const uint8_t *)&copy, 1);
    drain();
}

static void dma_send(const uint8_t *bytes, int32_t n)
{
    begin(bytes, n);
    SPI_INTERRUPT = ENDED;
}

static void dma_stop(void)
{
    SPI_NO_INTERRUPT = ENDED;
    SPI_STOP = 1;
}

#include "spi_dma.inc"

/* Interrupt 35, by the name that it has in Nordic's table. */
void SPIM2_SPIS2_SPI2_IRQHandler(void);
void SPIM2_SPIS2_SPI2_IRQHandler(void)
{
    SPI_NO_INTERRUPT = ENDED;
    piece_sent(false);
}

void board_start(void);
void board_start(void)
{
    PINS_HIGH = CS | DC | RST;
    PINS_LOW = 1 << SCK | 1 << MOSI;
    PINS_OUT = CS | DC | RST | 1 << SCK | 1 << MOSI;
    SPI_SCK = SCK;
    SPI_MOSI = MOSI;
    SPI_FREQUENCY = 0x80000000; /* 8 MHz; mode 0 after reset */
    SPI_ENABLE = 7;
    INTERRUPTS = 1 << (35 - 32);
}
