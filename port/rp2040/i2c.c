/* A display at I2C0 (RP2040 data sheet, 4.3): bytes behind a control byte, 0x00
 * for commands and 0x40 for data. There is no reset line. */
#include "board.h"
#include "registers.inc"

enum { I2C = 0x40044000, ADDRESS = 0x3C, SDA = 4, SCL = 5 };
enum { CON = 0x00, TARGET = 0x04, DATA = 0x10, HIGH = 0x1C, LOW = 0x20 };
enum { RAW_STATUS = 0x34, CLEAR_ABORT = 0x54, CLEAR_STOP = 0x60 };
enum { ENABLE = 0x6C, STATUS = 0x70, HOLD = 0x7C, SPIKES = 0xA0 };
enum { ABORTED = 1 << 6, STOPPED = 1 << 9, ROOM = 1 << 1, STOP = 1 << 9 };

/* Ends when a bit of a register is set. A byte takes 23 us; a chip may hold the
 * clock. */
static bool await(uint32_t address, uint32_t bit)
{
    for (const uint32_t from = board_time(); board_time() - from < 10000;)
        if (REGISTER(address) & bit)
            return true;
    return false;
}

static bool put(uint32_t what)
{
    const bool room = await(I2C + STATUS, ROOM);
    REGISTER(I2C + DATA) = what;
    return room && !(REGISTER(I2C + RAW_STATUS) & ABORTED);
}

/* Empties the queue of what came behind the byte that nobody took. */
static void restart(void)
{
    REGISTER(I2C + ENABLE) = 0;
    board_sleep(100); /* a byte ends before */
    REGISTER(I2C + ENABLE) = 1;
}

static enum pel_status send(uint8_t control, const uint8_t *bytes, int32_t n)
{
    bool good = put(control);
    for (; good && n > 0; n--)
        good = put(*bytes++ | (n == 1 ? STOP : 0));
    good = await(I2C + RAW_STATUS, STOPPED) && good &&
           !(REGISTER(I2C + RAW_STATUS) & ABORTED);
    if (!good)
        restart();
    (void)REGISTER(I2C + CLEAR_ABORT);
    (void)REGISTER(I2C + CLEAR_STOP);
    return good ? PEL_OK : PEL_ERROR_DEVICE;
}

static enum pel_status i2c_command(const struct pel_bus *bus,
                                   const uint8_t *bytes, size_t n,
                                   uint8_t *answer, size_t answers)
{
    (void)bus, (void)answer;
    return answers ? PEL_ERROR_DEVICE : send(0x00, bytes, (int32_t)n);
}

static enum pel_status i2c_data(const struct pel_bus *bus,
                                const struct pel_bus_rows *rows)
{
    enum pel_status status = PEL_OK;
    (void)bus;
    for (int32_t i = 0; i < rows->count && status == PEL_OK; i++)
        status = send(0x40, rows->bytes + i * rows->stride, rows->length);
    return status;
}

static enum pel_status i2c_pause(const struct pel_bus *bus, bool reset,
                                 uint32_t ms)
{
    (void)bus, (void)reset;
    board_sleep(1000 * ms);
    return PEL_OK;
}

const struct pel_bus board_i2c = {NULL, i2c_command, i2c_data, i2c_pause, NULL};

/* 400 kHz: 125 of 312 cycles high; SDA holds for 300 ns, spikes of 90 ns are
 * none. */
void board_i2c_start(void)
{
    start_parts(PART_PINS | PART_PADS | PART_I2C0);
    set_pin(SDA, FUNCTION_I2C, 1);
    set_pin(SCL, FUNCTION_I2C, 1);
    REGISTER(I2C + ENABLE) = 0;
    REGISTER(I2C + CON) = 1 << 6 | 1 << 5 | 2 << 1 | 1; /* master, fast */
    REGISTER(I2C + TARGET) = ADDRESS;
    REGISTER(I2C + HIGH) = 125;
    REGISTER(I2C + LOW) = 187;
    REGISTER(I2C + SPIKES) = 11;
    REGISTER(I2C + HOLD) = 38;
    REGISTER(I2C + ENABLE) = 1;
}
