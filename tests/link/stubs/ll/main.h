/* What port/spi_dma/stm32f4_ll.c takes of CubeMX's main.h and of ST's LL
 * drivers.
 */
#ifndef STUBS_LL_MAIN_H
#define STUBS_LL_MAIN_H

#include <stdint.h>

typedef struct {
    volatile uint32_t registers[10];
} GPIO_TypeDef;
typedef struct {
    volatile uint32_t registers[9];
} SPI_TypeDef;
typedef struct {
    volatile uint32_t registers[4];
} DMA_TypeDef;

#define SPI1 ((SPI_TypeDef *)0x40013000)
#define DMA2 ((DMA_TypeDef *)0x40026400)
#define LL_DMA_STREAM_3 3u
#define CS_GPIO_Port ((GPIO_TypeDef *)0x40020000)
#define DC_GPIO_Port CS_GPIO_Port
#define RST_GPIO_Port CS_GPIO_Port
#define CS_Pin (1u << 4)
#define DC_Pin (1u << 2)
#define RST_Pin (1u << 3)

void LL_GPIO_SetOutputPin(GPIO_TypeDef *port, uint32_t pins);
void LL_GPIO_ResetOutputPin(GPIO_TypeDef *port, uint32_t pins);
uint32_t LL_SPI_IsActiveFlag_TXE(SPI_TypeDef *spi);
uint32_t LL_SPI_IsActiveFlag_BSY(SPI_TypeDef *spi);
void LL_SPI_TransmitData8(SPI_TypeDef *spi, uint8_t byte);
uint32_t LL_SPI_DMA_GetRegAddr(SPI_TypeDef *spi);
void LL_SPI_EnableDMAReq_TX(SPI_TypeDef *spi);
void LL_SPI_Enable(SPI_TypeDef *spi);
uint32_t LL_DMA_IsActiveFlag_TE3(DMA_TypeDef *dma);
void LL_DMA_ClearFlag_TC3(DMA_TypeDef *dma);
void LL_DMA_ClearFlag_HT3(DMA_TypeDef *dma);
void LL_DMA_ClearFlag_TE3(DMA_TypeDef *dma);
void LL_DMA_ClearFlag_DME3(DMA_TypeDef *dma);
void LL_DMA_ClearFlag_FE3(DMA_TypeDef *dma);
void LL_DMA_SetMemoryAddress(DMA_TypeDef *dma, uint32_t stream, uint32_t from);
void LL_DMA_SetPeriphAddress(DMA_TypeDef *dma, uint32_t stream, uint32_t to);
void LL_DMA_SetDataLength(DMA_TypeDef *dma, uint32_t stream, uint32_t n);
void LL_DMA_EnableStream(DMA_TypeDef *dma, uint32_t stream);
void LL_DMA_DisableStream(DMA_TypeDef *dma, uint32_t stream);
void LL_DMA_EnableIT_TC(DMA_TypeDef *dma, uint32_t stream);
void LL_DMA_EnableIT_TE(DMA_TypeDef *dma, uint32_t stream);
void LL_mDelay(uint32_t ms);

#endif
