/* Stellaris LM3S6965 evaluation board: an SSD0323 with glass of 128x64 on SSI0,
 * D/C at PC7; PD0 high selects it, low the SD card. The emulator needs no other
 * pins and no clocks set. */
#include "oled.h"

enum { CONTROL_0, CONTROL_1, DATA, STATUS, PRESCALER };
static volatile uint32_t *const ssi = (volatile uint32_t *)0x40008000;

/* The bits of `pins` of a port, each one a bit of the address. */
static void set_pins(uint32_t port, uint32_t pins, uint32_t values)
{
    *(volatile uint32_t *)(port + 0x400) |= pins; /* outputs, */
    *(volatile uint32_t *)(port + 0x51C) |= pins; /* digital */
    *(volatile uint32_t *)(port + (pins << 2)) = values;
}

static void put_all(uint32_t dc, const uint8_t *bytes, size_t n)
{
    set_pins(0x40006000, 0x80, dc ? 0x80 : 0);
    for (size_t i = 0; i < n; i++) {
        ssi[DATA] = bytes[i];
        while (ssi[STATUS] & 1 << 4) /* busy */
            ;
        (void)ssi[DATA];
    }
}

static enum pel_status command(const struct pel_bus *bus, const uint8_t *bytes,
                               size_t n, uint8_t *answer, size_t answers)
{
    (void)bus, (void)answer, (void)answers;
    put_all(0, bytes, n);
    return PEL_OK;
}

static enum pel_status data(const struct pel_bus *bus,
                            const struct pel_bus_rows *rows)
{
    (void)bus;
    for (int32_t i = 0; i < rows->count; i++)
        put_all(1, rows->bytes + i * rows->stride, (size_t)rows->length);
    return PEL_OK;
}

static const struct pel_bus bus = {
    .command = command, .data = data, .pause = oled_pause};

struct pel_panel oled_panel = {
    .chip = &pel_panel_ssd0323, .bus = &bus, .format = &pel_gray4};

void oled_start(void)
{
    set_pins(0x40007000, 1, 1);
    ssi[PRESCALER] = 2;
    ssi[CONTROL_0] = 7;      /* 8 bits */
    ssi[CONTROL_1] = 1 << 1; /* on */
}
