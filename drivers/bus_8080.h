/* A parallel bus of 8 or 16 lines, as an 8080 had it: D/C (RS), WR, and the
 * data lines; also the memory controllers FSMC and FMC of an STM32, to which a
 * panel is two addresses:
 *
 *     static void words(const struct pel_bus_8080 *bus, bool data,
 *                       const uint16_t *word, size_t n)
 *     {
 *         volatile uint16_t *const to = // bank 1, RS at address line A16
 *             (volatile uint16_t *)(data ? 0x60020000 : 0x60000000);
 *         (void)bus;
 *         for (; n > 0; n--)
 *             *to = *word++;
 *     }
 *     static struct pel_bus_8080 parallel = {.bus = PEL_BUS_8080(&parallel),
 *                                            .words = words,
 *                                            .pause = pause,
 *                                            .lines = 16,
 *                                            .write = 0x2C};
 *     static struct pel_panel panel = {.bus = &parallel.bus,
 *                                      .chip = &pel_panel_ili9341,
 *                                      .format = &pel_rgb565_be};
 *
 * A command and its parameters are a word for each byte, in the lower lines.
 * What comes with D/C high behind the command `write` are pixels, which take
 * all lines: with 16, the two bytes of a pel_rgb565_be pixel are one word. An
 * ILI9488, whose driver sends three bytes a pixel, goes by 8 lines. Nothing can
 * be read. A call returns when all words were handed over. */
#ifndef PEL_DRIVERS_BUS_8080_H
#define PEL_DRIVERS_BUS_8080_H

#include "bus.h"

PEL_BEGIN_DECLS

struct pel_bus_8080 {
    struct pel_bus bus; /* PEL_BUS_8080 */

    /* Puts 1 to 32 words on the lines, each with a pulse of WR, D/C high for
     * `data`. The words are the caller's again when it returns. */
    void (*words)(const struct pel_bus_8080 *bus, bool data,
                  const uint16_t *word, size_t n);

    /* As that of struct pel_bus, and required as there: without it a pause is
     * PEL_ERROR_DEVICE. */
    enum pel_status (*pause)(const struct pel_bus_8080 *bus, bool reset,
                             uint32_t ms);
    uint8_t lines; /* 8 or 16 */
    uint8_t write; /* the chip's command before pixels: 2Ch; SSD1351 5Ch */
    bool pixels;   /* the bus's: that was the last command */
};

/* The functions of `bus`. PEL_ERROR_DEVICE for what asks for an answer. */
enum pel_status pel_bus_8080_command(const struct pel_bus *bus,
                                     const uint8_t *bytes, size_t n,
                                     uint8_t *answer, size_t answers);
enum pel_status pel_bus_8080_data(const struct pel_bus *bus,
                                  const struct pel_bus_rows *rows);
enum pel_status pel_bus_8080_pause(const struct pel_bus *bus, bool reset,
                                   uint32_t ms);
#define PEL_BUS_8080(self)                                                   \
    {                                                                        \
        (self), pel_bus_8080_command, pel_bus_8080_data, pel_bus_8080_pause, \
            NULL                                                             \
    }
PEL_END_DECLS
#endif
