/* A window as a display: a program for a board runs on a desktop, and is looked
 * at as by pel view. Three lines:
 *
 *     static struct pel_display_sdl window;
 *     const struct pel_display_sdl_options panel = {
 *         .title = "watch", .width = 240, .height = 240,
 *         .format = &pel_rgb565_be};
 *     status = pel_display_sdl_open(&display, &window, &panel);
 *
 * The program draws into memory of its own, in bands or whole, flushes and
 * flips as on the board. pel_display_flip shows the frame and keeps the window
 * alive; once the user has closed it, flush and flip are PEL_ERROR_DEVICE, at
 * which a program ends. What the user does comes as struct pel_input, in pixels
 * of the panel, by pel_display_sdl_next. Keys of the window's own:
 *
 *     F1          prints these keys
 *     F2 F3       smaller, larger pixels
 *     F4          how often each pixel is painted for a flush, from then on
 *     F5          bands: every other flush is brighter
 *     F6          a box around each flush of the last frame
 *     F7          a magnifier at the pointer
 *     F8          writes what the panel shows to pel-001.ppm and so on
 *
 * F4 counts what is painted onto surfaces of display->format, which is another
 * one of the same memory layout then; what is flushed from surfaces of other
 * formats, and in mono1_pages, counts once. For one thread, that which opened
 * it. */
#ifndef PEL_PORT_SDL_DISPLAY_SDL_H
#define PEL_PORT_SDL_DISPLAY_SDL_H

#include "../../drivers/display.h"
#include "../../drivers/input.h"
#include "window_sdl.h"

PEL_BEGIN_DECLS

struct pel_display_sdl_options {
    const char *title;
    int32_t width, height;           /* px of the panel */
    const struct pel_format *format; /* of the panel: one that can be read */
    int32_t zoom; /* px of the window that a pixel takes, 1 to 32; 0: as many
                     as fit into 480 */
    int32_t
        period; /* ms from flip to flip, at least; 0: the screen's refresh */
    bool touch; /* the left button is finger 0: PEL_INPUT_TOUCH, and no
                   PEL_INPUT_POINT or _BUTTON of it */
};

enum { PEL_DISPLAY_SDL_EVENTS = 64, PEL_DISPLAY_SDL_FLUSHES = 256 };

struct pel_display_sdl {
    struct pel_window_sdl window;
    struct pel_display_sdl_options options;
    struct pel_display *display; /* the program's */
    struct pel_surface glass;    /* what the panel shows */
    struct pel_surface counts;   /* of pel_heat: since the last flush, */
    struct pel_surface counted;  /* and before it */
    struct pel_format counting;  /* the panel's format, and counts */
    bool heat, bands, boxes, magnifier;
    bool stale, closed, held; /* held: the finger is down */
    int32_t at[2];            /* px of the panel: the pointer */
    struct pel_rect flush[PEL_DISPLAY_SDL_FLUSHES]; /* of the frame */
    int32_t flushes, bytes;
    int32_t shown, shown_bytes; /* flushes of the last frame, and its bytes */
    uint32_t due;               /* ms: when the next flip may return */
    struct pel_input_queue queue;
    struct pel_input events[PEL_DISPLAY_SDL_EVENTS];
    const char *message; /* why something failed; NULL: nothing has */
};

/* Opens the window and sets the display up; the structs stay where they are.
 * PEL_ERROR_NULL, PEL_ERROR_SIZE (no legal panel, or no memory for it),
 * PEL_ERROR_FORMAT (a format that cannot be read), PEL_ERROR_DEVICE (no window,
 * as on a machine without a screen): `message` says what is wrong. In any case
 * it may be closed; one that did not open is as one that the user closed. */
enum pel_status pel_display_sdl_open(
    struct pel_display *display, struct pel_display_sdl *window,
    const struct pel_display_sdl_options *options);
void pel_display_sdl_close(struct pel_display_sdl *window);

/* The next event; false: there is none now. */
bool pel_display_sdl_next(struct pel_display_sdl *window,
                          struct pel_input *event);

/* The same, after at most so many ms; -1: waits until one comes or the window
 * is closed. A program that draws nothing meanwhile keeps its window alive. */
bool pel_display_sdl_wait(struct pel_display_sdl *window, int32_t ms,
                          struct pel_input *event);

PEL_END_DECLS
#endif
