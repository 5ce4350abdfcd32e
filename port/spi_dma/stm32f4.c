/* STM32F401 or F411 from its registers on, at the 16 MHz after reset: SPI1 at
 * 8 MHz with stream 3 of DMA2. SCK is PA5, MOSI PA7, CS PA4, D/C PA2, RST PA3.
 * After RM0368. */
#include <stdbool.h>
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define CLOCK_DMA_PINS REGISTER(0x40023830)
#define CLOCK_SPI REGISTER(0x40023844)
#define PIN_MODE REGISTER(0x40020000)
#define PIN_SPEED REGISTER(0x40020008)
#define PIN REGISTER(0x40020018) /* low half: high; high half: low */
#define PIN_FUNCTION REGISTER(0x40020020)
#define SPI_CR1 REGISTER(0x40013000)
#define SPI_CR2 REGISTER(0x40013004)
#define SPI_SR REGISTER(0x40013008)
#define SPI_DR REGISTER(0x4001300C)
#define DMA_STATUS REGISTER(0x40026400)
#define DMA_CLEAR REGISTER(0x40026408)
#define DMA_CONTROL REGISTER(0x40026458)
#define DMA_COUNT REGISTER(0x4002645C)
#define DMA_TO REGISTER(0x40026460)
#define DMA_FROM REGISTER(0x40026464)
#define INTERRUPTS REGISTER(0xE000E104) /* 32 to 63 */
#define HIGH(pins) (PIN = (pins))
#define LOW(pins) (PIN = (pins) << 16)
#define TICKS 16000

enum { DC = 1 << 2, RST = 1 << 3, CS = 1 << 4, MOST = 65535 };

static void drain(void)
{
    while (!(SPI_SR & 1 << 1) || SPI_SR & 1 << 7)
        continue;
}

static void send_byte(uint8_t byte)
{
    SPI_DR = byte;
    drain();
}

/* Channel 3, memory moves on, from memory, interrupts at its end and at errors.
 */
static void dma_send(const uint8_t *bytes, int32_t n)
{
    DMA_CLEAR = 0x0F400000;
    DMA_FROM = (uint32_t)(uintptr_t)bytes;
    DMA_COUNT = (uint32_t)n;
    DMA_CONTROL = 3u << 25 | 1 << 10 | 1 << 6 | 1 << 4 | 1 << 2 | 1;
}

static void dma_stop(void)
{
    DMA_CONTROL = 0;
}

#include "spi_dma.inc"

/* Interrupt 59, by the name that it has in ST's table. */
void DMA2_Stream3_IRQHandler(void);
void DMA2_Stream3_IRQHandler(void)
{
    const bool failed = DMA_STATUS & 1 << 25;
    DMA_CLEAR = 0x0F400000;
    piece_sent(failed);
}

void board_start(void);
void board_start(void)
{
    CLOCK_DMA_PINS |= 1 << 22 | 1; /* DMA2, port A */
    CLOCK_SPI |= 1 << 12;          /* SPI1 */
    PIN = CS | DC | RST;
    PIN_FUNCTION |= 5 << 20 | 5u << 28;   /* PA5, PA7: SPI1, */
    PIN_MODE |= 2 << 10 | 2 << 14;        /* no longer inputs, */
    PIN_MODE |= 1 << 4 | 1 << 6 | 1 << 8; /* PA2 to PA4: outputs */
    PIN_SPEED |= 3 << 10 | 3 << 14;
    DMA_TO = (uint32_t)(uintptr_t)&SPI_DR;
    SPI_CR2 = 1 << 1;                            /* asks the DMA */
    SPI_CR1 = 1 << 9 | 1 << 8 | 1 << 6 | 1 << 2; /* on, master, mode 0 */
    INTERRUPTS = 1 << (59 - 32);
}
