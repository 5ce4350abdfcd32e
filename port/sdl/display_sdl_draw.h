/* For display_sdl.c alone: what is seen in the window, and what is counted. */
#ifndef PEL_PORT_SDL_DISPLAY_SDL_DRAW_H
#define PEL_PORT_SDL_DISPLAY_SDL_DRAW_H

#include "display_sdl.h"
#include "inspect.h"

PEL_BEGIN_DECLS

/* Where an area of the panel is in the window: the panel is in the middle. */
struct pel_rect pel_display_sdl_place(const struct pel_display_sdl *window,
                                      const struct pel_rect *area);

/* Draws the window and shows it. False, with a message. */
bool pel_display_sdl_draw(struct pel_display_sdl *window);

/* A format whose pixels are those of `of`, and which counts them: of a surface
 * of the window's `counting` format. */
struct pel_format pel_display_sdl_counting(const struct pel_format *of);

/* An area is flushed: what was painted of it is seen, and begins anew. Not
 * counted: it was painted once. */
void pel_display_sdl_settle(struct pel_display_sdl *window,
                            const struct pel_rect *area, bool counted);

/* Forgets all counts. */
void pel_display_sdl_forget(struct pel_display_sdl *window);

PEL_END_DECLS
#endif
