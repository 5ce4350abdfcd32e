/* The panel of the examples on the page: memory, whose frames the page plays.
 */
#ifndef PAGE_PANEL_H
#define PAGE_PANEL_H

#include "drivers/display.h"
#include "drivers/input.h"
#include "page/page.h"

static uint32_t panel_memory[480 * 320];
static struct pel_surface panel_glass;
static int panel_sent;

static enum pel_status panel_flush(const struct pel_display *display,
                                   const struct pel_surface *s)
{
    const struct pel_copy_part part = {s, s->clip, s->clip.x0, s->clip.y0};
    (void)display;
    pel_copy(&panel_glass, &part);
    panel_sent += (s->clip.x1 - s->clip.x0) * (s->clip.y1 - s->clip.y0);
    return PEL_OK;
}

static enum pel_status panel_flip(const struct pel_display *display)
{
    page_frame(page_bytes(&panel_glass), display->width, display->height,
               panel_sent);
    panel_sent = 0;
    return PEL_OK;
}

static inline enum pel_status panel_open(struct pel_display *display,
                                         int32_t width, int32_t height,
                                         const struct pel_format *format)
{
    const struct pel_rect all = {0, 0, width, height};
    *display = (struct pel_display){.width = width,
                                    .height = height,
                                    .format = format,
                                    .flush = panel_flush,
                                    .flip = panel_flip};
    return pel_surface_init(&panel_glass, format, panel_memory,
                            sizeof panel_memory, &all);
}

/* As a panel that scrolls by itself. */
static inline enum pel_status panel_scroll(const struct pel_display *display,
                                           const struct pel_rect *area,
                                           int32_t n)
{
    (void)display;
    pel_scroll(&panel_glass, area, -n, 0);
    return PEL_OK;
}

static inline bool panel_input(struct pel_input *event)
{
    (void)event;
    return false;
}

static inline void panel_close(void)
{
}

#endif
