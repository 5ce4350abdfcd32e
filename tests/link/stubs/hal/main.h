/* What port/spi_dma/stm32_hal.c takes of CubeMX's main.h and of ST's HAL. */
#ifndef STUBS_HAL_MAIN_H
#define STUBS_HAL_MAIN_H

#include <stdint.h>

typedef enum { HAL_OK, HAL_ERROR, HAL_BUSY, HAL_TIMEOUT } HAL_StatusTypeDef;
typedef enum { GPIO_PIN_RESET, GPIO_PIN_SET } GPIO_PinState;
typedef struct {
    volatile uint32_t registers[10];
} GPIO_TypeDef;
typedef struct {
    void *Instance;
} SPI_HandleTypeDef;

#define CS_GPIO_Port ((GPIO_TypeDef *)0x40020000)
#define DC_GPIO_Port CS_GPIO_Port
#define RST_GPIO_Port CS_GPIO_Port
#define CS_Pin ((uint16_t)0x0010)
#define DC_Pin ((uint16_t)0x0004)
#define RST_Pin ((uint16_t)0x0008)

void HAL_GPIO_WritePin(GPIO_TypeDef *port, uint16_t pin, GPIO_PinState state);
HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *spi, uint8_t *data,
                                   uint16_t size, uint32_t timeout);
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *spi, uint8_t *data,
                                       uint16_t size);
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *spi);
void HAL_SPI_TxCpltCallback(SPI_HandleTypeDef *spi);
void HAL_SPI_ErrorCallback(SPI_HandleTypeDef *spi);
void HAL_Delay(uint32_t ms);

#endif
