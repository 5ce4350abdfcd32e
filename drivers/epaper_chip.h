/* What a chip of epaper.h consists of; for the files of chips.
 *
 * Lists: for each command its number of bytes, itself among them, and the
 * bytes; between them PEL_EPAPER_WAIT, until the chip is not busy, and
 * PEL_EPAPER_PLANE, the bytes of the frame's first plane, the next time those
 * of its second one; 0 ends the list. */
#ifndef PEL_DRIVERS_EPAPER_CHIP_H
#define PEL_DRIVERS_EPAPER_CHIP_H

#include "epaper.h"

PEL_BEGIN_DECLS

enum { PEL_EPAPER_WAIT = 0xFF, PEL_EPAPER_PLANE = 0xFE, PEL_EPAPER_LIST = 24 };

/* Of black and white, or of color. White and color are ones. */
struct pel_epaper_kind {
    const uint8_t *setup;
    const uint8_t *show; /* sends what is to be shown */
    const uint8_t *keep; /* what is, to be compared with; or nothing */
};

struct pel_epaper_chip {
    bool busy;              /* the level of the pin */
    uint16_t width, height; /* most px */
    struct pel_epaper_kind kind[2];
    const uint8_t *refresh[3], *sleep;

    /* Adds to the setup what follows from the size of the glass. */
    void (*size)(const struct pel_epaper *paper, uint8_t *list);
};

/* Solomon Systech's commands. Deep sleep keeps memory, but no registers. */
void pel_epaper_ssd_size(const struct pel_epaper *paper, uint8_t *list);
extern const uint8_t pel_epaper_ssd_show[], pel_epaper_ssd_color[],
    pel_epaper_ssd_sleep[];
#define PEL_EPAPER_SSD(setup)                                           \
    .kind = {{setup, pel_epaper_ssd_show, pel_epaper_ssd_color + 10},   \
             {setup, pel_epaper_ssd_color, pel_epaper_ssd_color + 20}}, \
    .sleep = pel_epaper_ssd_sleep, .size = pel_epaper_ssd_size, .busy = true

/* UltraChip's. */
extern const uint8_t pel_epaper_uc_keep[], pel_epaper_uc_color[],
    pel_epaper_uc_sleep[];
#define PEL_EPAPER_UC(setup, color)                                  \
    .kind = {{setup, pel_epaper_uc_color + 3, pel_epaper_uc_keep},   \
             {color, pel_epaper_uc_color, pel_epaper_uc_color + 6}}, \
    .sleep = pel_epaper_uc_sleep
PEL_END_DECLS
#endif
