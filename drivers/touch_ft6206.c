/* After the FT6x06 application note (FocalTech, 2012), register table: 0x02
 * points, 0x03 and 0x09 six bytes for each, the event and X in two, the
 * finger's number and Y in two. */
#include "touch.h"

enum { POINTS = 0x02, POINT_BYTES = 6 };

/* 0 points is 0, and 255 is told before the first touch. */
enum pel_status pel_touch_ft6206_read(
    const struct pel_bus *bus, struct pel_touch_point points[PEL_TOUCH_FINGERS],
    unsigned *down)
{
    static const uint8_t from = POINTS;
    uint8_t answer[1 + PEL_TOUCH_FINGERS * POINT_BYTES];
    const enum pel_status status =
        bus->command(bus, &from, 1, answer, sizeof(answer));
    *down = 0;
    if (status != PEL_OK || (answer[0] & 15) > PEL_TOUCH_FINGERS)
        return status;
    for (int i = 0; i < (answer[0] & 15); i++) {
        const uint8_t *point = answer + 1 + i * POINT_BYTES;
        const int finger = point[2] >> 4;
        if (finger >= PEL_TOUCH_FINGERS)
            continue;
        points[finger].x = (int16_t)((point[0] & 15) << 8 | point[1]);
        points[finger].y = (int16_t)((point[2] & 15) << 8 | point[3]);
        *down |= 1u << finger;
    }
    return PEL_OK;
}
