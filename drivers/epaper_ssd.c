#include "epaper_chip.h"

#include <string.h>

/* To the first byte of the window. */
#define HOME 2, 0x4E, 0x00, 3, 0x4F, 0x00, 0x00

const uint8_t pel_epaper_ssd_show[] = {HOME, 1, 0x24, PEL_EPAPER_PLANE, 0};
const uint8_t pel_epaper_ssd_color[] = {
    HOME, 1, 0x24, PEL_EPAPER_PLANE, HOME, 1, 0x26, PEL_EPAPER_PLANE, 0};
const uint8_t pel_epaper_ssd_sleep[] = {2, 0x10, 0x01, 0};

/* Rows that are driven, and bytes of a row. */
void pel_epaper_ssd_size(const struct pel_epaper *paper, uint8_t *list)
{
    static const uint8_t set[] = {4, 0x01, 0, 0, 0, 3, 0x44, 0, 0, 0};
    const uint32_t last = paper->height - 1u;
    memcpy(list, set, sizeof set);
    list[2] = (uint8_t)last;
    list[3] = (uint8_t)(last >> 8);
    list[8] = (uint8_t)((paper->width - 1u) >> 3);
}
