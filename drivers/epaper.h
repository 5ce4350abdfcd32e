/* E-paper behind a bus (bus.h): one const object for each controller chip, one
 * struct that says what a module makes of it, and a display for both.
 *
 *     static uint8_t frame[PEL_EPAPER_FRAME(122, 250)];
 *     static struct pel_epaper paper = {.chip = &pel_epaper_ssd1680,
 *                                       .bus = &bus,
 *                                       .busy = read_busy_pin,
 *                                       .format = &pel_mono1,
 *                                       .frame = frame,
 *                                       .width = 122, .height = 250,
 *                                       .rotation = 1};
 *     struct pel_display display;
 *     if (pel_epaper_init(&display, &paper) != PEL_OK)
 *         ...the bus has said what went wrong, or the chip stays busy...
 *
 * flush takes any part of the screen into `frame`, turned. flip sends that and
 * begins a refresh: the picture is there after 0.3 s (partial) to 30 s (full,
 * in color). Nothing waits for that but the next flip, sleep or, in black and
 * white, flush; 60 s at most, then it is PEL_ERROR_DEVICE. A program that has
 * other things to do asks pel_epaper_busy first. Sleep between refreshes: a
 * chip that is awake keeps voltages at the glass, which wears out.
 *
 * Black and white panels take pel_mono1, those with red or yellow pel_inks2, of
 * which both are the panel's color; the chips of four greys take pel_gray2. */
#ifndef PEL_DRIVERS_EPAPER_H
#define PEL_DRIVERS_EPAPER_H

#include "bus.h"
#include "display.h"

PEL_BEGIN_DECLS

/* FULL drives every pixel, to black and white in turn. FAST flashes less, and
 * leaves more of the picture before. PARTIAL drives the pixels that change;
 * after some ten of them, and first of all, a full one cleans the glass. Color
 * and greys have FULL alone. */
enum pel_epaper_refresh {
    PEL_EPAPER_FULL,
    PEL_EPAPER_FAST,
    PEL_EPAPER_PARTIAL
};

struct pel_epaper {
    /* The program's. */
    const struct pel_epaper_chip *chip;
    const struct pel_bus *bus;
    bool (*busy)(const struct pel_epaper *paper); /* is the pin BUSY high? */
    const struct pel_format *format;
    uint8_t *frame; /* PEL_EPAPER_FRAME bytes; of color and greys twice */
    uint16_t width, height; /* px of the glass in rotation 0 */
    uint8_t rotation;       /* of the picture: quarter turns clockwise, mod 4 */
    uint8_t refresh;        /* enum pel_epaper_refresh, of the next flip */
    uint8_t state;          /* the driver's */

    /* Sent before FAST and PARTIAL, and before FULL of greys and color; or
     * NULL: the maker's waveform where the chip has none. A list of commands,
     * for each its number of bytes up to 253, the command itself among them,
     * and the bytes; 0 ends the list. */
    const uint8_t *waveform;

    /* The driver's. */
    const struct pel_epaper_kind *kind;
    int32_t size; /* bytes of a plane */
};

#define PEL_EPAPER_FRAME(width, height) (((width) + 7) / 8 * (height))

/* With modules that the values of a file are meant for. An IL3897 (or SSD1675)
 * and a UC8151 (or IL0373) need a waveform for all but FULL. */
extern const struct pel_epaper_chip pel_epaper_ssd1680; /* GDEY0213B74,
                                             GDEY029T94, GDEY0213Z98 */
extern const struct pel_epaper_chip pel_epaper_ssd1681; /* GDEY0154D67,
                                                           GDEY0154Z90 */
extern const struct pel_epaper_chip pel_epaper_il3897;  /* GDEH0213B73 */
extern const struct pel_epaper_chip pel_epaper_uc8151;  /* GDEW029T5,
                                                           GDEW029Z10 */
extern const struct pel_epaper_chip pel_epaper_uc8179;  /* GDEY075T7,
                                                           GDEY075Z08 */

/* Black and white glass in four greys. Modules of the first and third bring the
 * waveform, those of the third since the end of 2023. The second is for
 * `.waveform = pel_epaper_uc8151_grays`, Pel's own, made from the data sheet
 * for a room's temperature, or for its maker's. */
extern const struct pel_epaper_chip pel_epaper_ssd1680_gray2; /* GDEY0213B74,
                                                                 GDEY029T94 */
extern const struct pel_epaper_chip pel_epaper_uc8151_gray2;  /* GDEW029T5 */
extern const struct pel_epaper_chip pel_epaper_uc8179_gray2;  /* GDEY075T7 */
extern const uint8_t pel_epaper_uc8151_grays[];

/* Resets and sets up the chip; the glass stays as it is, the frame is white.
 * `paper` becomes the context of `display`, and both stay the caller's.
 * PEL_ERROR_NULL, for a bus without `data` too; PEL_ERROR_FORMAT,
 * PEL_ERROR_SIZE (no glass, or more than the chip's memory), PEL_ERROR_DEVICE.
 *
 * flip: PEL_ERROR_RANGE when the refresh is one that the panel does not have.
 * What a chip that needs a waveform does without one is up to the chip. */
enum pel_status pel_epaper_init(struct pel_display *display,
                                struct pel_epaper *paper);

/* Is a refresh going on? */
bool pel_epaper_busy(const struct pel_epaper *paper);

/* Waits for the refresh, then takes the voltages off: the picture stays. The
 * next flush or flip wakes the chip. What was flushed is flipped before: a
 * partial refresh takes it for what the glass shows else. */
enum pel_status pel_epaper_sleep(struct pel_epaper *paper);
PEL_END_DECLS
#endif
