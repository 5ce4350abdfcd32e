/* STM32G030 to G0C1 from its registers on, at the 16 MHz after reset: SPI1 at 8
 * MHz with channel 1 of DMA1. SCK is PA5, MOSI PA7, CS PA4, D/C PA2, RST PA3.
 * After RM0444. */
#include <stdbool.h>
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define CLOCK_PINS REGISTER(0x40021034)
#define CLOCK_DMA REGISTER(0x40021038)
#define CLOCK_SPI REGISTER(0x40021040)
#define PIN_MODE REGISTER(0x50000000)
#define PIN_SPEED REGISTER(0x50000008)
#define PIN REGISTER(0x50000018) /* low half: high; high half: low */
#define SPI_CR1 REGISTER(0x40013000)
#define SPI_CR2 REGISTER(0x40013004)
#define SPI_SR REGISTER(0x40013008)
#define SPI_DR (*(volatile uint8_t *)0x4001300C) /* a byte, not two */
#define DMA_STATUS REGISTER(0x40020000)
#define DMA_CLEAR REGISTER(0x40020004)
#define DMA_CONTROL REGISTER(0x40020008)
#define DMA_COUNT REGISTER(0x4002000C)
#define DMA_TO REGISTER(0x40020010)
#define DMA_FROM REGISTER(0x40020014)
#define DMA_REQUEST REGISTER(0x40020800)
#define INTERRUPTS REGISTER(0xE000E100)
#define HIGH(pins) (PIN = (pins))
#define LOW(pins) (PIN = (pins) << 16)
#define TICKS 16000

enum { DC = 1 << 2, RST = 1 << 3, CS = 1 << 4, MOST = 65535 };

/* Its queue is empty, and it is not busy. */
static void drain(void)
{
    while (SPI_SR & (3 << 11 | 1 << 7))
        continue;
}

static void send_byte(uint8_t byte)
{
    SPI_DR = byte;
    drain();
}

/* Memory moves on, from memory, interrupts at its end and at errors. */
static void dma_send(const uint8_t *bytes, int32_t n)
{
    DMA_CONTROL = 0;
    DMA_FROM = (uint32_t)(uintptr_t)bytes;
    DMA_COUNT = (uint32_t)n;
    DMA_CONTROL = 1 << 7 | 1 << 4 | 1 << 3 | 1 << 1 | 1;
}

static void dma_stop(void)
{
    DMA_CONTROL = 0;
}

#include "spi_dma.inc"

/* Interrupt 9, by the name that it has in ST's table. */
void DMA1_Channel1_IRQHandler(void);
void DMA1_Channel1_IRQHandler(void)
{
    const bool failed = DMA_STATUS & 1 << 3;
    DMA_CLEAR = 15;
    piece_sent(failed);
}

void board_start(void);
void board_start(void)
{
    CLOCK_PINS |= 1;      /* port A */
    CLOCK_DMA |= 1;       /* DMA1 */
    CLOCK_SPI |= 1 << 12; /* SPI1 */
    PIN = CS | DC | RST;
    PIN_MODE &= ~(0x3Fu << 4 | 3u << 10 | 3u << 14); /* were analog: */
    PIN_MODE |= 1 << 4 | 1 << 6 | 1 << 8;            /* PA2 to PA4 outputs, */
    PIN_MODE |= 2 << 10 | 2 << 14;                   /* PA5, PA7 SPI1 */
    PIN_SPEED |= 3 << 10 | 3 << 14;
    DMA_REQUEST = 17; /* SPI1 sends */
    DMA_TO = (uint32_t)(uintptr_t)&SPI_DR;
    SPI_CR2 = 7 << 8 | 1 << 1;                   /* 8 bits, asks the DMA */
    SPI_CR1 = 1 << 9 | 1 << 8 | 1 << 6 | 1 << 2; /* on, master, mode 0 */
    INTERRUPTS = 1 << 9;
}
