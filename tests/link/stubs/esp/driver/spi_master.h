#ifndef STUBS_ESP_SPI_MASTER_H
#define STUBS_ESP_SPI_MASTER_H

typedef enum { SPI1_HOST, SPI2_HOST } spi_host_device_t;
typedef enum { SPI_DMA_CH_AUTO = 3 } spi_dma_chan_t;
typedef struct {
    int mosi_io_num, miso_io_num, sclk_io_num, quadwp_io_num, quadhd_io_num;
    int max_transfer_sz;
} spi_bus_config_t;
int spi_bus_initialize(spi_host_device_t host, const spi_bus_config_t *config,
                       spi_dma_chan_t channel);

#endif
