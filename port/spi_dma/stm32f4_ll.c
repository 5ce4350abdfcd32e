/* STM32F4 with ST's LL drivers, as CubeMX sets it up: SPI1 of 8 bits, sending
 * by stream 3 of DMA2, whose interrupt CubeMX leaves to this file; outputs
 * named CS, DC and RST. */
#include <main.h>

#include <stdbool.h>

enum { MOST = 65535 };

static void select_chip(bool data)
{
    if (data)
        LL_GPIO_SetOutputPin(DC_GPIO_Port, DC_Pin);
    else
        LL_GPIO_ResetOutputPin(DC_GPIO_Port, DC_Pin);
    LL_GPIO_ResetOutputPin(CS_GPIO_Port, CS_Pin);
}

static void release_chip(void)
{
    LL_GPIO_SetOutputPin(CS_GPIO_Port, CS_Pin);
}

static void reset_line(bool high)
{
    if (high)
        LL_GPIO_SetOutputPin(RST_GPIO_Port, RST_Pin);
    else
        LL_GPIO_ResetOutputPin(RST_GPIO_Port, RST_Pin);
}

static void drain(void)
{
    while (!LL_SPI_IsActiveFlag_TXE(SPI1) || LL_SPI_IsActiveFlag_BSY(SPI1))
        continue;
}

static void send_byte(uint8_t byte)
{
    LL_SPI_TransmitData8(SPI1, byte);
    drain();
}

static void clear_flags(void)
{
    LL_DMA_ClearFlag_TC3(DMA2);
    LL_DMA_ClearFlag_HT3(DMA2);
    LL_DMA_ClearFlag_TE3(DMA2);
    LL_DMA_ClearFlag_DME3(DMA2);
    LL_DMA_ClearFlag_FE3(DMA2);
}

static void dma_send(const uint8_t *bytes, int32_t n)
{
    clear_flags();
    LL_DMA_SetMemoryAddress(DMA2, LL_DMA_STREAM_3, (uint32_t)(uintptr_t)bytes);
    LL_DMA_SetDataLength(DMA2, LL_DMA_STREAM_3, (uint32_t)n);
    LL_DMA_EnableStream(DMA2, LL_DMA_STREAM_3);
}

static void dma_stop(void)
{
    LL_DMA_DisableStream(DMA2, LL_DMA_STREAM_3);
}

static void sleep_ms(uint32_t ms)
{
    LL_mDelay(ms);
}

#include "spi_dma.inc"

void DMA2_Stream3_IRQHandler(void);
void DMA2_Stream3_IRQHandler(void)
{
    const bool failed = LL_DMA_IsActiveFlag_TE3(DMA2);
    clear_flags();
    piece_sent(failed);
}

/* After CubeMX's MX_GPIO_Init, MX_DMA_Init and MX_SPI1_Init. */
void board_start(void);
void board_start(void)
{
    release_chip();
    LL_DMA_SetPeriphAddress(DMA2, LL_DMA_STREAM_3, LL_SPI_DMA_GetRegAddr(SPI1));
    LL_DMA_EnableIT_TC(DMA2, LL_DMA_STREAM_3);
    LL_DMA_EnableIT_TE(DMA2, LL_DMA_STREAM_3);
    LL_SPI_EnableDMAReq_TX(SPI1);
    LL_SPI_Enable(SPI1);
}
