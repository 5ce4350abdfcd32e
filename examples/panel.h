/* A panel of 240 x 240 pixels for the gauge: memory, whose driver copies what a
 * DMA would send, in time that does not count. It notes bytes and, in QEMU,
 * instructions: of the first frame, and the most of a later one. */
#ifndef EXAMPLES_PANEL_H
#define EXAMPLES_PANEL_H

#include "../bench/mcu/stopwatch.h"
#include "drivers/display.h"
#include "ppm.h"

enum { PANEL_SIDE = 240 };

static uint16_t panel_memory[PANEL_SIDE * PANEL_SIDE];
static const struct pel_surface panel_glass = {panel_memory,
                                               PANEL_SIDE * 2,
                                               {0, 0, PANEL_SIDE, PANEL_SIDE},
                                               {0, 0, PANEL_SIDE, PANEL_SIDE},
                                               &pel_rgb565_be};

static struct {
    uint32_t started, idle; /* of the stopwatch */
    int32_t frames, sent;
    int32_t bytes[2], instructions[2];
} panel_notes;

static enum pel_status panel_flush(const struct pel_display *display,
                                   const struct pel_surface *s)
{
    const struct pel_copy_part part = {s, s->clip, s->clip.x0, s->clip.y0};
    const uint32_t from = stopwatch_read();
    (void)display;
    pel_copy(&panel_glass, &part);
    panel_notes.sent +=
        2 * (s->clip.x1 - s->clip.x0) * (s->clip.y1 - s->clip.y0);
    panel_notes.idle += stopwatch_read() - from;
    return PEL_OK;
}

/* A frame begins where the one before ends. */
static void panel_frame_begin(void)
{
    panel_notes.sent = 0;
    panel_notes.idle = 0;
    panel_notes.started = stopwatch_read();
}

static enum pel_status panel_flip(const struct pel_display *display)
{
    const int32_t count = stopwatch_eighths(
        panel_notes.started + panel_notes.idle, stopwatch_read());
    const int i = panel_notes.frames++ > 0;
    (void)display;
    panel_notes.bytes[i] = pel_max(panel_notes.bytes[i], panel_notes.sent);
    panel_notes.instructions[i] =
        pel_max(panel_notes.instructions[i], count / 8);
    panel_frame_begin();
    return PEL_OK;
}

static inline enum pel_status panel_open(struct pel_display *display)
{
    static const struct pel_display panel = {.width = PANEL_SIDE,
                                             .height = PANEL_SIDE,
                                             .format = &pel_rgb565_be,
                                             .flush = panel_flush,
                                             .flip = panel_flip};
    *display = panel;
    stopwatch_start();
    panel_frame_begin();
    return PEL_OK;
}

/* The notes, and what the panel shows, as PPM. */
static inline void panel_close(void)
{
    printf("P6\n");
    for (int i = 0; i < 2; i++) {
        printf("# %s: %d bytes", i ? "step" : "whole",
               (int)panel_notes.bytes[i]);
        if (panel_notes.instructions[i] > 0) /* only boards count them */
            printf(", %d instructions", (int)panel_notes.instructions[i]);
        printf("\n");
    }
    printf("%d %d 255\n", PANEL_SIDE, PANEL_SIDE);
    ppm_write(&panel_glass);
}

#endif
