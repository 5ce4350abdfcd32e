/* What a chip of epaper.h consists of; for the files of chips.
 *
 * Lists: for each command its number of bytes, itself among them, and the
 * bytes; between them PEL_EPAPER_WAIT, until the chip is not busy,
 * and PEL_EPAPER_PLANE, the bytes of the frame's first plane, the next time
 * those of its second one; 0 ends the list. */
#ifndef PEL_DRIVERS_EPAPER_CHIP_H
#define PEL_DRIVERS_EPAPER_CHIP_H

#include "epaper.h"

PEL_BEGIN_DECLS

enum { PEL_EPAPER_WAIT = 0xFF, PEL_EPAPER_PLANE = 0xFE, PEL_EPAPER_LIST = 24 };

/* What a chip makes of pixels of a format. */
struct pel_epaper_kind {
    uint8_t format; /* enum pel_format_id */
    uint8_t planes; /* for each pixel value, from the low bits up, its bits in
                       the first plane and in the second */
    uint8_t most;   /* enum pel_epaper_refresh, the last that it has */
    const uint8_t *setup;
    const uint8_t *show; /* sends what is to be shown */
    const uint8_t *keep; /* what is, to be compared with; or nothing */
};

struct pel_epaper_chip {
    bool busy;                      /* the level of the pin */
    uint16_t width, height;         /* most px */
    struct pel_epaper_kind kind[2]; /* the second is none where format is 0 */
    const uint8_t *refresh[3], *sleep;

    /* Adds to the setup what follows from the size of the glass. */
    void (*size)(const struct pel_epaper *paper, uint8_t *list);
};

/* White and color are ones; UltraChip's greys are as they are, and Solomon
 * Systech's are darknesses. */
#define PEL_EPAPER_MONO PEL_FORMAT_MONO1, 0x04, PEL_EPAPER_PARTIAL
#define PEL_EPAPER_INKS PEL_FORMAT_INKS2, 0xF1, PEL_EPAPER_FULL
#define PEL_EPAPER_GRAYS(planes) PEL_FORMAT_GRAY2, planes, PEL_EPAPER_FULL

/* Solomon Systech's commands. Deep sleep keeps memory, but no registers. */
void pel_epaper_ssd_size(const struct pel_epaper *paper, uint8_t *list);
extern const uint8_t pel_epaper_ssd_show[], pel_epaper_ssd_color[],
    pel_epaper_ssd_sleep[];
#define PEL_EPAPER_SSD_ALL \
    .sleep = pel_epaper_ssd_sleep, .size = pel_epaper_ssd_size, .busy = true
#define PEL_EPAPER_SSD(setup)                               \
    .kind = {{PEL_EPAPER_MONO, setup, pel_epaper_ssd_show,  \
              pel_epaper_ssd_color + 10},                   \
             {PEL_EPAPER_INKS, setup, pel_epaper_ssd_color, \
              pel_epaper_ssd_color + 20}},                  \
    PEL_EPAPER_SSD_ALL
#define PEL_EPAPER_SSD_GRAYS(setup)                                \
    .kind = {{PEL_EPAPER_GRAYS(0x1B), setup, pel_epaper_ssd_color, \
              pel_epaper_ssd_color + 20}},                         \
    PEL_EPAPER_SSD_ALL

/* UltraChip's. */
extern const uint8_t pel_epaper_uc_keep[], pel_epaper_uc_color[],
    pel_epaper_uc_sleep[];
#define PEL_EPAPER_UC(setup, color)                            \
    .kind = {{PEL_EPAPER_MONO, setup, pel_epaper_uc_color + 3, \
              pel_epaper_uc_keep},                             \
             {PEL_EPAPER_INKS, color, pel_epaper_uc_color,     \
              pel_epaper_uc_color + 6}},                       \
    .sleep = pel_epaper_uc_sleep
#define PEL_EPAPER_UC_GRAYS(setup)                                \
    .kind = {{PEL_EPAPER_GRAYS(0xE4), setup, pel_epaper_uc_color, \
              pel_epaper_uc_color + 6}},                          \
    .sleep = pel_epaper_uc_sleep
PEL_END_DECLS
#endif
