/* Displays: where a surface is shown. The one run-time seam of Pel; panels, LCD
 * controllers, Linux devices and simulators all have this form:
 *
 *     for each frame:
 *         for each band (one, the whole screen, where memory allows):
 *             pel_display_begin(display, &band, &surface);
 *             draw into surface;
 *             pel_display_flush(display, &surface);
 *         pel_display_flip(display);
 *
 * A driver fills a const struct pel_display. Only `flush` is required; what is
 * NULL or 0 has the default told below. The struct and its context are the
 * caller's and outlive the use; no call allocates. drivers/display_memory is
 * the example to copy.
 *
 * Who may touch the pixels, call by call:
 *     begin    the program gets `surface`; the part begun is its own to draw
 *     flush    submits surface->clip. From here until wait returns the pixels
 *              belong to the display (a DMA may be reading them); a driver
 *              that is done when it returns has no `wait`
 *     wait     the transfer is over (told by an interrupt, or polled); the
 *              program may draw into that memory again, and finds there what
 *              it left. One transfer at a time is in flight: flush on a display
 *              that is busy waits by itself, so a program that draws into two
 *              buffers in turn needs no wait, one with a single buffer calls it
 *              before it draws again
 *     flip     the frame is complete: what was flushed is on the screen after
 *              it, at the latest, as a whole where the display can do that
 * A transfer that failed is told by the next flush, wait or flip. Calls for one
 * display come from one thread at a time; two displays are independent.
 *
 * Windows. Pixels of less than 8 bits share bytes, and some panels accept only
 * windows whose corners are multiples of 2 or 8 pixels: pel_display_align makes
 * an area larger until it fits, and a program that flushes less than the screen
 * passes its areas through it first, before begin, so that all pixels of the
 * window are drawn. A surface keeps absolute
 * coordinates in every band, so nothing else changes. */
#ifndef PEL_DRIVERS_DISPLAY_H
#define PEL_DRIVERS_DISPLAY_H

#include <pel/pel.h>

struct pel_display {
    void *context; /* the driver's own state */

    int32_t width, height; /* px; 0: any surface will do, whatever its size */
    const struct pel_format *format; /* of what flush takes; NULL: any */
    int32_t stride; /* bytes between rows that flush needs; 0: any */
    int32_t pages;  /* frames of memory that begin hands out in turn: with 2,
                       it gives what was drawn two flips ago. 0 is 1 */

    /* Submits the pixels inside surface->clip, at the same place on screen.
     * Nothing when that is empty. */
    enum pel_status (*flush)(const struct pel_display *display,
                             const struct pel_surface *surface);

    /* Makes `surface` a view of the display's own memory, clipped to `area`.
     * Default: none; the program brings memory of its own. */
    enum pel_status (*begin)(const struct pel_display *display,
                             const struct pel_rect *area,
                             struct pel_surface *surface);

    /* Default: nothing to wait for. */
    enum pel_status (*wait)(const struct pel_display *display);

    /* Default: what is flushed is seen at once. */
    enum pel_status (*flip)(const struct pel_display *display);

    /* Grows `area`, which is of whole bytes, to a window that the display
     * accepts. Default: any. */
    void (*align)(const struct pel_display *display, struct pel_rect *area);
};

/* Begins `area`. On a display without memory of its own `surface`, set up by
 * the caller over the caller's memory, stays as it is but for the clip; it must
 * hold the area. PEL_ERROR_SIZE when it does not. */
static inline enum pel_status pel_display_begin(const struct pel_display *d,
                                                const struct pel_rect *area,
                                                struct pel_surface *surface)
{
    if (d->begin)
        return d->begin(d, area, surface);
    pel_surface_clip(surface, area);
    return surface->clip.x0 == area->x0 && surface->clip.x1 == area->x1 &&
                   surface->clip.y0 == area->y0 && surface->clip.y1 == area->y1
               ? PEL_OK
               : PEL_ERROR_SIZE;
}

static inline enum pel_status pel_display_flush(
    const struct pel_display *d, const struct pel_surface *surface)
{
    return d->flush(d, surface);
}

static inline enum pel_status pel_display_wait(const struct pel_display *d)
{
    return d->wait ? d->wait(d) : PEL_OK;
}

/* Waits for what is in flight, then shows the frame. */
static inline enum pel_status pel_display_flip(const struct pel_display *d)
{
    enum pel_status status = pel_display_wait(d);
    return status == PEL_OK && d->flip ? d->flip(d) : status;
}

/* Numbers *from to *to become multiples of n, a power of two; the second one
 * `end` at most, unless that is 0. */
static inline void pel_display_grow(int32_t *from, int32_t *to, int32_t n,
                                    int32_t end)
{
    const int32_t up = (*to + n - 1) & ~(n - 1);
    *from &= ~(n - 1);
    *to = end && up > end ? end : up;
}

/* Grows an area of the screen to a window: of whole bytes, and as the display
 * wants it. */
static inline void pel_display_align(const struct pel_display *d,
                                     struct pel_rect *area)
{
    if (d->format && d->format->id == PEL_FORMAT_MONO1_PAGES)
        pel_display_grow(&area->y0, &area->y1, 8, d->height);
    else if (d->format && d->format->bits < 8)
        pel_display_grow(&area->x0, &area->x1, 8 / d->format->bits, d->width);
    if (d->align)
        d->align(d, area);
}

#endif
