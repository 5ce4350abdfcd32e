/* The board of the program in docs/firmware.md: a bus that takes three frames,
 * which must be what the loop says, drawn as wholes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <pel/pel.h>
#include "drivers/bus.h"

enum { SIDE = 240, ROW = SIDE * 2, FRAME = SIDE * ROW };

static uint8_t sent[FRAME];
static int32_t n, frames;

static void draw_whole(uint16_t *memory)
{
    static const struct pel_rect all = {0, 0, SIDE, SIDE};
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(230, 40, 30));
    struct pel_surface s;
    pel_surface_init(&s, &pel_rgb565_be, memory, FRAME, &all);
    pel_clear(&s, PEL_RGB(0, 0, 64));
    pel_circle(&s, pel_at(2 * frames, SIDE / 2), PEL_PX(30), &red.paint);
}

static void end_frame(void)
{
    static uint16_t whole[SIDE * SIDE];
    draw_whole(whole);
    if (memcmp(sent, whole, FRAME) != 0) {
        printf("frame %d is another one\n", (int)frames);
        exit(1);
    }
    n = 0;
    if (++frames == 3)
        exit(0);
}

/* What is as long as a row is pixels, the rest are settings. */
static enum pel_status data(const struct pel_bus *bus,
                            const struct pel_bus_rows *rows)
{
    (void)bus;
    for (int32_t i = 0; i < rows->count && rows->length >= ROW; i++) {
        memcpy(sent + n, rows->bytes + i * rows->stride, (size_t)rows->length);
        n += rows->length;
        if (n == FRAME)
            end_frame();
    }
    return PEL_OK;
}

static enum pel_status command(const struct pel_bus *bus, const uint8_t *bytes,
                               size_t count, uint8_t *answer, size_t answers)
{
    (void)bus, (void)bytes, (void)count, (void)answer, (void)answers;
    return PEL_OK;
}

static enum pel_status pause(const struct pel_bus *bus, bool reset, uint32_t ms)
{
    (void)bus, (void)reset, (void)ms;
    return PEL_OK;
}

const struct pel_bus board_bus = {
    .command = command, .data = data, .pause = pause};

void board_start(void);
void board_start(void)
{
}
