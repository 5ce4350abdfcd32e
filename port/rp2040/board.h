/* A Raspberry Pi Pico without its SDK: start-up code, a panel, a second one by
 * I2C, a touch controller, buttons and an encoder, text to a serial line.
 *
 *     what                       GPIO
 *     panel, SPI0                SCK 18, MOSI 19, CS 17, D/C 20, RST 21
 *     panel, I2C0                SDA 4, SCL 5
 *     touch, SPI1                SCK 10, MOSI 11, MISO 8, CS 9
 *     button, contacts A and B   14, 12, 13, each to ground
 *     text, UART0                0
 */
#ifndef PORT_RP2040_BOARD_H
#define PORT_RP2040_BOARD_H

#include "../../drivers/bus.h"

PEL_BEGIN_DECLS

/* The panel at SPI0, with a DMA: ../spi_dma/rp2040.c. */
extern const struct pel_bus board_bus;
void board_start(void);

/* The one at I2C0, 400 kHz, address 0x3C. */
extern const struct pel_bus board_i2c;
void board_i2c_start(void);

/* The touch controller, 2 MHz. */
extern const struct pel_bus board_touch;
void board_touch_start(void);

enum { BOARD_BUTTON = 14, BOARD_A = 12, BOARD_B = 13 };

/* From now on two functions of the program are called, by interrupts that do
 * not interrupt each other: every millisecond, and at every edge of A and B. */
void board_inputs_start(void);
void board_millisecond(void);
void board_edge(void);

/* Is the contact closed? */
bool board_closed(int pin);

/* Microseconds since reset, which wrap after 71 minutes. */
uint32_t board_time(void);
void board_sleep(uint32_t us);

void board_write(const char *text);
void board_write_number(int32_t n);

PEL_END_DECLS
#endif
