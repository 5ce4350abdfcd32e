#include "epaper_chip.h"

const uint8_t pel_epaper_uc_keep[] = {1, 0x10, PEL_EPAPER_PLANE, 0};
const uint8_t pel_epaper_uc_color[] = {
    1, 0x10, PEL_EPAPER_PLANE, 1, 0x13, PEL_EPAPER_PLANE, 0};

/* Power off, then deep sleep. */
const uint8_t pel_epaper_uc_sleep[] = {1,    0x02, PEL_EPAPER_WAIT, 2, 0x07,
                                       0xA5, 0};
