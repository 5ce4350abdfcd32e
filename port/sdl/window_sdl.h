/* A window of SDL with the pixels of a surface in it: what pel view and
 * display_sdl.h are made of. */
#ifndef PEL_PORT_SDL_WINDOW_SDL_H
#define PEL_PORT_SDL_WINDOW_SDL_H

#include <pel/pel.h>

#include "../../drivers/input.h"

PEL_BEGIN_DECLS

struct pel_window_sdl {
    /* xrgb8888, as large as the window; begun anew by pel_window_sdl_fit. What
     * was drawn into it is seen after pel_window_sdl_show. */
    struct pel_surface surface;
    struct SDL_Window *window;
    struct SDL_Renderer *renderer;
    struct SDL_Texture *texture; /* of the surface's size */
    int32_t most; /* px that a texture has each way; larger windows show one
                     stretched */
    char message[240]; /* of the last call that failed */
};

struct pel_window_sdl_options {
    const char *title;
    int32_t width, height; /* px */
    bool refresh;          /* pel_window_sdl_show waits for the screen's */
};

/* Opens a window. False, with a message, where there is no screen. It may be
 * closed in any case. */
bool pel_window_sdl_open(struct pel_window_sdl *window,
                         const struct pel_window_sdl_options *options);
void pel_window_sdl_close(struct pel_window_sdl *window);

/* Makes the surface as large as the window. *anew: it is another one than
 * before, and black. False, with a message. */
bool pel_window_sdl_fit(struct pel_window_sdl *window, bool *anew);

/* Shows the surface. False, with a message. */
bool pel_window_sdl_show(struct pel_window_sdl *window);

void pel_window_sdl_title(struct pel_window_sdl *window, const char *title);

enum pel_window_event {
    PEL_WINDOW_NOTHING, /* none came in time */
    PEL_WINDOW_OTHER,   /* of no matter */
    PEL_WINDOW_REDRAW,  /* what is shown is lost, or has another size */
    PEL_WINDOW_CLOSE,   /* the user wants it closed */
    PEL_WINDOW_INPUT    /* *input */
};

/* The next event, after at most so many ms. Places are px of the window. */
enum pel_window_event pel_window_sdl_event(struct pel_input *input, int32_t ms);

PEL_END_DECLS
#endif
