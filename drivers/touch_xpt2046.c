/* After the XPT2046 data sheet (Shenzhen Xptek, 2007): control byte, table 1;
 * differential measurement, tables 3 and 4; 24 clocks for each, figure 13. */
#include "touch.h"

/* What is measured: 12 bits, differential, power down after it. */
enum { Z1 = 0xB0, Z2 = 0xC0, X = 0xD0, Y = 0x90 };

/* z1 + 4095 - z2 grows with the pressure, from about 0. */
enum { PRESSED = 400 };

/* One bit while it is busy, 12 bits, three that are 0. A line that nobody
 * drives has ones there. */
static enum pel_status measure(const struct pel_bus *bus, uint8_t what,
                               int *value)
{
    uint8_t answer[2];
    const enum pel_status status = bus->command(bus, &what, 1, answer, 2);
    *value = (int)(((unsigned)answer[0] << 8 | answer[1]) >> 3);
    if (status == PEL_OK && (answer[0] & 0x80 || answer[1] & 7))
        return PEL_ERROR_DEVICE;
    return status;
}

/* The middle one of three: the plates still swing in the first, and a finger
 * that lifts spoils the last. */
static enum pel_status measure_often(const struct pel_bus *bus, uint8_t what,
                                     int16_t *value)
{
    int v[3], low, high;
    for (int i = 0; i < 3; i++) {
        const enum pel_status status = measure(bus, what, &v[i]);
        if (status != PEL_OK)
            return status;
    }
    low = v[0] < v[1] ? v[0] : v[1];
    high = v[0] < v[1] ? v[1] : v[0];
    *value = (int16_t)(v[2] < low ? low : v[2] > high ? high : v[2]);
    return PEL_OK;
}

/* z2 is never 0: that is a line held low. */
enum pel_status pel_touch_xpt2046_read(
    const struct pel_bus *bus, struct pel_touch_point points[PEL_TOUCH_FINGERS],
    unsigned *down)
{
    int z1, z2;
    enum pel_status status = measure(bus, Z1, &z1);
    *down = 0;
    if (status == PEL_OK)
        status = measure(bus, Z2, &z2);
    if (status != PEL_OK)
        return status;
    if (z2 == 0)
        return PEL_ERROR_DEVICE;
    if (z1 + 4095 - z2 < PRESSED)
        return PEL_OK;
    status = measure_often(bus, X, &points[0].x);
    if (status == PEL_OK)
        status = measure_often(bus, Y, &points[0].y);
    *down = status == PEL_OK;
    return status;
}
