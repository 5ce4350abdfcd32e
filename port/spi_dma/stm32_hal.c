/* Any STM32 with ST's HAL, as CubeMX sets it up: hspi1, an SPI of 8 bits, its
 * DMA for sending with the interrupts of both on; outputs named CS, DC and RST.
 */
#include <main.h>

#include <stdbool.h>

extern SPI_HandleTypeDef hspi1;

enum { MOST = 65535 };

static void select_chip(bool data)
{
    HAL_GPIO_WritePin(DC_GPIO_Port, DC_Pin,
                      data ? GPIO_PIN_SET : GPIO_PIN_RESET);
    HAL_GPIO_WritePin(CS_GPIO_Port, CS_Pin, GPIO_PIN_RESET);
}

static void release_chip(void)
{
    HAL_GPIO_WritePin(CS_GPIO_Port, CS_Pin, GPIO_PIN_SET);
}

static void reset_line(bool high)
{
    HAL_GPIO_WritePin(RST_GPIO_Port, RST_Pin,
                      high ? GPIO_PIN_SET : GPIO_PIN_RESET);
}

static void send_byte(uint8_t byte)
{
    HAL_SPI_Transmit(&hspi1, &byte, 1, 10);
}

/* What it does not begin, `wait` gives up after its time. */
static void dma_send(const uint8_t *bytes, int32_t n)
{
    HAL_SPI_Transmit_DMA(&hspi1, (uint8_t *)bytes, (uint16_t)n);
}

static void dma_stop(void)
{
    HAL_SPI_Abort(&hspi1);
}

/* The HAL has waited. */
static void drain(void)
{
}

static void sleep_ms(uint32_t ms)
{
    HAL_Delay(ms);
}

#include "spi_dma.inc"

void HAL_SPI_TxCpltCallback(SPI_HandleTypeDef *spi)
{
    if (spi == &hspi1)
        piece_sent(false);
}

void HAL_SPI_ErrorCallback(SPI_HandleTypeDef *spi)
{
    if (spi == &hspi1)
        piece_sent(true);
}

/* After CubeMX's MX_GPIO_Init, MX_DMA_Init and MX_SPI1_Init. */
void board_start(void);
void board_start(void)
{
    release_chip();
}
