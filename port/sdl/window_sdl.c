#include "window_sdl.h"

#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXTURE_SIZE_MAX = 16384, POLL_MS = 2 };

static bool fails(struct pel_window_sdl *w, const char *what)
{
    snprintf(w->message, sizeof w->message, "%s (%s)", what, SDL_GetError());
    return false;
}

bool pel_window_sdl_fit(struct pel_window_sdl *w, bool *anew)
{
    const struct pel_rect *had = &w->surface.bounds;
    int width, height;
    *anew = false;
    if (SDL_GetRendererOutputSize(w->renderer, &width, &height) != 0)
        return fails(w, "the window's size is not known");
    const struct pel_rect all = {0, 0, pel_max(pel_min(width, w->most), 1),
                                 pel_max(pel_min(height, w->most), 1)};
    if (w->texture && had->x1 == all.x1 && had->y1 == all.y1)
        return true;
    free(w->surface.pixels);
    SDL_DestroyTexture(w->texture);
    const size_t size = (size_t)all.x1 * (size_t)all.y1 * 4;
    void *const pixels = calloc(size, 1);
    w->texture = SDL_CreateTexture(w->renderer, SDL_PIXELFORMAT_BGRA32,
                                   SDL_TEXTUREACCESS_STREAMING, all.x1, all.y1);
    if (!w->texture)
        fails(w, "no texture of the window's size");
    else
        SDL_SetTextureBlendMode(w->texture, SDL_BLENDMODE_NONE);
    if (pel_surface_init(&w->surface, &pel_xrgb8888, pixels, size, &all) !=
        PEL_OK)
        strcpy(w->message, "no memory for the window's pixels");
    *anew = w->texture && pixels;
    return *anew;
}

bool pel_window_sdl_show(struct pel_window_sdl *w)
{
    const struct pel_surface *s = &w->surface;
    if (SDL_UpdateTexture(w->texture, NULL, s->pixels, s->stride) != 0 ||
        SDL_RenderCopy(w->renderer, w->texture, NULL, NULL) != 0)
        return fails(w, "the picture cannot be shown");
    SDL_RenderPresent(w->renderer);
    return true;
}

void pel_window_sdl_title(struct pel_window_sdl *w, const char *title)
{
    SDL_SetWindowTitle(w->window, title);
}

static int key_of(SDL_Keycode code)
{
    static const int keys[][2] = {
        {SDLK_LEFT, PEL_KEY_LEFT},
        {SDLK_RIGHT, PEL_KEY_RIGHT},
        {SDLK_UP, PEL_KEY_UP},
        {SDLK_DOWN, PEL_KEY_DOWN},
        {SDLK_HOME, PEL_KEY_HOME},
        {SDLK_END, PEL_KEY_END},
        {SDLK_PAGEUP, PEL_KEY_PAGE_UP},
        {SDLK_PAGEDOWN, PEL_KEY_PAGE_DOWN},
        {SDLK_INSERT, PEL_KEY_INSERT},
        {SDLK_KP_ENTER, PEL_KEY_ENTER},
        {SDLK_KP_PLUS, '+'},
        {SDLK_KP_MINUS, '-'},
        {SDLK_LSHIFT, PEL_KEY_SHIFT},
        {SDLK_RSHIFT, PEL_KEY_SHIFT},
        {SDLK_LCTRL, PEL_KEY_CTRL},
        {SDLK_RCTRL, PEL_KEY_CTRL},
        {SDLK_LALT, PEL_KEY_ALT},
        {SDLK_RALT, PEL_KEY_ALT},
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i][0] == code)
            return keys[i][1];
    if (code >= SDLK_F1 && code <= SDLK_F12)
        return PEL_KEY_F1 + (int)(code - SDLK_F1);
    return code > 0 && code < 128 ? code : PEL_KEY_OTHER;
}

/* The event as one of drivers/input.h. False for one that has none. */
static bool input_of(const SDL_Event *event, struct pel_input *e)
{
    *e = (struct pel_input){.time = event->common.timestamp};
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        e->kind = PEL_INPUT_KEY;
        e->state = event->key.repeat ? PEL_INPUT_AGAIN : event->key.state;
        e->code = (uint16_t)key_of(event->key.keysym.sym);
        return true;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        e->kind = PEL_INPUT_BUTTON;
        e->state = event->button.state;
        e->code = event->button.button;
        e->x = (int16_t)event->button.x;
        e->y = (int16_t)event->button.y;
        return true;
    case SDL_MOUSEMOTION:
        e->kind = PEL_INPUT_POINT;
        e->x = (int16_t)event->motion.x;
        e->y = (int16_t)event->motion.y;
        return true;
    case SDL_MOUSEWHEEL:
        e->kind = PEL_INPUT_WHEEL;
        e->x = (int16_t)event->wheel.x;
        e->y = (int16_t)event->wheel.y;
        return true;
    default:
        return false;
    }
}

/* Waits at most so many ms for an event. SDL_WaitEventTimeout would, but its
 * X11 driver then wakes the window from a second connection: a server that
 * reads that one last finds no window, and the error ends the program with
 * status 1.
 */
static bool wait_event(SDL_Event *event, int32_t ms)
{
    for (int32_t waited = 0; !SDL_PollEvent(event); waited += POLL_MS) {
        if (waited >= ms)
            return false;
        SDL_Delay(POLL_MS);
    }
    return true;
}

enum pel_window_event pel_window_sdl_event(struct pel_input *input, int32_t ms)
{
    SDL_Event event;
    if (!wait_event(&event, ms))
        return PEL_WINDOW_NOTHING;
    if (event.type == SDL_QUIT)
        return PEL_WINDOW_CLOSE;
    if (event.type == SDL_WINDOWEVENT)
        return PEL_WINDOW_REDRAW;
    return input_of(&event, input) ? PEL_WINDOW_INPUT : PEL_WINDOW_OTHER;
}

/* Without a screen SDL takes a driver that shows nothing, which nobody wants
 * who has not asked for it. */
static bool is_seen(struct pel_window_sdl *w)
{
    const char *driver = SDL_GetCurrentVideoDriver();
    if (getenv("SDL_VIDEODRIVER") || !driver ||
        (strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0))
        return true;
    strcpy(w->message, "no screen for a window: DISPLAY and WAYLAND_DISPLAY "
                       "name none");
    return false;
}

bool pel_window_sdl_open(struct pel_window_sdl *w,
                         const struct pel_window_sdl_options *o)
{
    SDL_RendererInfo info = {0};
    *w = (struct pel_window_sdl){.most = 0};
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0)
        return fails(w, "no screen for a window");
    if (!is_seen(w))
        return false;
    w->window = SDL_CreateWindow(o->title, SDL_WINDOWPOS_UNDEFINED,
                                 SDL_WINDOWPOS_UNDEFINED, o->width, o->height,
                                 SDL_WINDOW_RESIZABLE | SDL_WINDOW_HIDDEN);
    if (!w->window)
        return fails(w, "no window");
    w->renderer = SDL_CreateRenderer(
        w->window, -1, o->refresh ? SDL_RENDERER_PRESENTVSYNC : 0);
    if (!w->renderer)
        return fails(w, "nothing can be drawn into the window");
    SDL_GetRendererInfo(w->renderer, &info);
    w->most = pel_min(info.max_texture_width, info.max_texture_height);
    if (w->most <= 0 || w->most > TEXTURE_SIZE_MAX) /* 0: no limit of SDL's */
        w->most = TEXTURE_SIZE_MAX;
    SDL_ShowWindow(w->window); /* a renderer may put another in its place */
    return true;
}

void pel_window_sdl_close(struct pel_window_sdl *w)
{
    free(w->surface.pixels);
    SDL_DestroyTexture(w->texture);
    SDL_DestroyRenderer(w->renderer);
    SDL_DestroyWindow(w->window);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    *w = (struct pel_window_sdl){.most = 0};
}
