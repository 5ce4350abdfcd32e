/* ESP32 and its kind by esp_lcd of ESP-IDF, which has the DMA, the queue and
 * the lines: SCK is GPIO 18, MOSI 23, CS 5, D/C 16, RST 17. Pixels lie in
 * memory that the DMA reads, as static arrays do. */
#include <driver/gpio.h>
#include <driver/spi_master.h>
#include <esp_lcd_panel_io.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>

#include "../../drivers/bus.h"

enum { SCK = 18, MOSI = 23, CS = 5, DC = 16, RST = 17, MOST = 32768 };

static esp_lcd_panel_io_handle_t io;

static enum pel_status status_of(esp_err_t error)
{
    return error == ESP_OK ? PEL_OK : PEL_ERROR_DEVICE;
}

/* A command without bytes waits for what is queued. */
static enum pel_status bus_wait(const struct pel_bus *bus)
{
    (void)bus;
    return status_of(esp_lcd_panel_io_tx_param(io, -1, NULL, 0));
}

static enum pel_status bus_command(const struct pel_bus *bus,
                                   const uint8_t *bytes, size_t n,
                                   uint8_t *answer, size_t answers)
{
    enum pel_status status = answers ? PEL_ERROR_DEVICE : PEL_OK;
    (void)bus, (void)answer;
    for (; n > 0 && status == PEL_OK; n--)
        status = status_of(esp_lcd_panel_io_tx_param(io, *bytes++, NULL, 0));
    return status;
}

static enum pel_status bus_data(const struct pel_bus *bus,
                                const struct pel_bus_rows *rows)
{
    enum pel_status status = bus_wait(bus);
    for (int32_t i = 0; i < rows->count && status == PEL_OK; i++)
        status = status_of(esp_lcd_panel_io_tx_color(
            io, -1, rows->bytes + i * rows->stride, (size_t)rows->length));
    return status;
}

static enum pel_status bus_pause(const struct pel_bus *bus, bool reset,
                                 uint32_t ms)
{
    const enum pel_status status = bus_wait(bus);
    if (reset) {
        gpio_set_level(RST, 0);
        vTaskDelay(2);
        gpio_set_level(RST, 1);
    }
    vTaskDelay(pdMS_TO_TICKS(ms) + 1);
    return status;
}

const struct pel_bus board_bus = {NULL, bus_command, bus_data, bus_pause,
                                  bus_wait};

void board_start(void);
void board_start(void)
{
    const spi_bus_config_t bus = {.mosi_io_num = MOSI,
                                  .miso_io_num = -1,
                                  .sclk_io_num = SCK,
                                  .quadwp_io_num = -1,
                                  .quadhd_io_num = -1,
                                  .max_transfer_sz = MOST};
    const esp_lcd_panel_io_spi_config_t panel = {.cs_gpio_num = CS,
                                                 .dc_gpio_num = DC,
                                                 .spi_mode = 0,
                                                 .pclk_hz = 40000000,
                                                 .trans_queue_depth = 10,
                                                 .lcd_cmd_bits = 8,
                                                 .lcd_param_bits = 8};
    gpio_set_direction(RST, GPIO_MODE_OUTPUT);
    ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO));
    ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi(
        (esp_lcd_spi_bus_handle_t)SPI2_HOST, &panel, &io));
}
