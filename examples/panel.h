/* The panel of the examples: memory, whose driver copies what a DMA would send,
 * in time that does not count. It notes bytes and, in QEMU, instructions: of
 * the first frame, and the most of a later one. On a board a header of your own
 * takes its place, with the same functions: panel_open sets up the pins and
 * calls pel_panel_init of drivers/panel.h, panel_close does nothing. Where an
 * example names it, panel_scroll is pel_panel_scroll_by, and panel_open then
 * gives the display of pel_panel_scroll_init (drivers/panel_scroll.h). */
#ifndef EXAMPLES_PANEL_H
#define EXAMPLES_PANEL_H

#ifdef PANEL_HEADER
#include PANEL_HEADER
#else

#include "../bench/mcu/stopwatch.h"
#include "drivers/display.h"
#include "drivers/input.h"
#include "ppm.h"

#ifndef PANEL_WORDS
#define PANEL_WORDS (480 * 320)
#endif

static uint16_t panel_memory[PANEL_WORDS];
static struct pel_surface panel_glass;

static struct {
    uint32_t mark;  /* of the stopwatch */
    uint32_t count; /* of the frame, eighths of an instruction */
    int32_t frames, sent;
    int32_t bytes[2], instructions[2];
} panel_notes;

/* Adds what the program took since the last mark. */
static void panel_stop(void)
{
    const uint32_t now = stopwatch_read();
    panel_notes.count += (uint32_t)stopwatch_eighths(panel_notes.mark, now);
}

static enum pel_status panel_flush(const struct pel_display *display,
                                   const struct pel_surface *s)
{
    const struct pel_copy_part part = {s, s->clip, s->clip.x0, s->clip.y0};
    (void)display;
    panel_stop();
    pel_copy(&panel_glass, &part);
    panel_notes.sent += (s->clip.x1 - s->clip.x0) * (s->clip.y1 - s->clip.y0) *
                        s->format->bits / 8;
    panel_notes.mark = stopwatch_read();
    return PEL_OK;
}

static enum pel_status panel_flip(const struct pel_display *display)
{
    const int i = panel_notes.frames++ > 0;
    (void)display;
    panel_stop();
    panel_notes.bytes[i] = pel_max(panel_notes.bytes[i], panel_notes.sent);
    panel_notes.instructions[i] =
        pel_max(panel_notes.instructions[i], (int32_t)(panel_notes.count / 8));
    panel_notes.sent = 0;
    panel_notes.count = 0;
    panel_notes.mark = stopwatch_read();
    return PEL_OK;
}

static inline enum pel_status panel_open(struct pel_display *display,
                                         int32_t width, int32_t height,
                                         const struct pel_format *format)
{
    const struct pel_rect all = {0, 0, width, height};
    const struct pel_display panel = {.width = width,
                                      .height = height,
                                      .format = format,
                                      .flush = panel_flush,
                                      .flip = panel_flip};
    *display = panel;
    stopwatch_start();
    panel_notes.mark = stopwatch_read();
    return pel_surface_init(&panel_glass, format, panel_memory,
                            sizeof panel_memory, &all);
}

/* Moves what is in an area to the left by n pixels, of which none is sent. */
static inline enum pel_status panel_scroll(const struct pel_display *display,
                                           const struct pel_rect *area,
                                           int32_t n)
{
    (void)display;
    panel_stop();
    pel_scroll(&panel_glass, area, -n, 0);
    panel_notes.mark = stopwatch_read();
    return PEL_OK;
}

/* What a user has done; here is none, but an example may say what he would do.
 * A frame is taken for 33 ms. */
static inline bool panel_input(struct pel_input *event)
{
#ifdef PANEL_EVENTS
    static const struct pel_input all[] = {PANEL_EVENTS};
    static size_t next;
    if (next == sizeof all / sizeof *all ||
        all[next].time > 33 * (uint32_t)panel_notes.frames)
        return false;
    *event = all[next++];
    return true;
#else
    (void)event;
    return false;
#endif
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
    printf("%d %d 255\n", (int)panel_glass.bounds.x1,
           (int)panel_glass.bounds.y1);
    ppm_write(&panel_glass);
}

#endif
#endif
