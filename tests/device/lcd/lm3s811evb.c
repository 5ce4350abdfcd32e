/* Stellaris LM3S811 evaluation board: an SSD0303 with glass of 96x16 on I2C. It
 * takes what an SH1106 takes. The emulator needs no pins and no clock set. */
#include "oled.h"

enum { ADDRESS, STATUS, DATA, SETTINGS = 8, FAILED = 2 };
enum { RUN = 1, START = 2, STOP = 4 };
static volatile uint32_t *const i2c = (volatile uint32_t *)0x40020000;

static bool put(uint8_t byte, uint32_t how)
{
    i2c[DATA] = byte;
    i2c[STATUS] = RUN | how;
    while (i2c[STATUS] & 1) /* busy */
        ;
    return !(i2c[STATUS] & FAILED);
}

/* `control` tells what the bytes after it are. */
static bool put_all(uint8_t control, const uint8_t *bytes, int32_t n)
{
    i2c[ADDRESS] = 0x3D << 1;
    bool done = put(control, START);
    for (int32_t i = 0; done && i < n; i++)
        done = put(bytes[i], i + 1 < n ? 0 : STOP);
    return done;
}

/* The emulated chip knows control byte 0x80, one byte of a command, but not
 * 0x00, many of them. */
static enum pel_status command(const struct pel_bus *bus, const uint8_t *bytes,
                               size_t n, uint8_t *answer, size_t answers)
{
    (void)bus, (void)answer, (void)answers;
    bool done = true;
    for (size_t i = 0; done && i < n; i++)
        done = put_all(0x80, bytes + i, 1);
    return done ? PEL_OK : PEL_ERROR_DEVICE;
}

static enum pel_status data(const struct pel_bus *bus,
                            const struct pel_bus_rows *rows)
{
    (void)bus;
    bool done = true;
    for (int32_t i = 0; done && i < rows->count; i++)
        done = put_all(0x40, rows->bytes + i * rows->stride, rows->length);
    return done ? PEL_OK : PEL_ERROR_DEVICE;
}

static const struct pel_bus bus = {
    .command = command, .data = data, .pause = oled_pause};

/* The glass is wired to columns 36 to 131; that of an SH1106 begins at 2. */
struct pel_panel oled_panel = {.chip = &pel_panel_sh1106,
                               .bus = &bus,
                               .format = &pel_mono1_pages,
                               .width = 96,
                               .height = 16,
                               .left = 34};

void oled_start(void)
{
    i2c[SETTINGS] = 1 << 4; /* a master */
}
