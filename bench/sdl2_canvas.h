/* A software renderer of SDL2 that draws into a canvas. */
#ifndef BENCH_SDL2_CANVAS_H
#define BENCH_SDL2_CANVAS_H

#include "method.h"

#include <SDL.h>

struct sdl2_canvas {
    SDL_Surface *surface;
    SDL_Renderer *renderer;
};

static inline struct sdl2_canvas sdl2_canvas_open(const struct canvas *c)
{
    const Uint32 format =
        c->bits == 32 ? SDL_PIXELFORMAT_RGB888 : SDL_PIXELFORMAT_RGB565;
    struct sdl2_canvas out = {
        SDL_CreateRGBSurfaceWithFormatFrom(c->pixels, c->width, c->height,
                                           c->bits, c->stride, format),
        NULL};
    if (out.surface)
        out.renderer = SDL_CreateSoftwareRenderer(out.surface);
    if (!out.renderer)
        method_fail(SDL_GetError(), "check the installation of SDL2");
    return out;
}

static inline void sdl2_canvas_close(const struct sdl2_canvas *c)
{
    SDL_DestroyRenderer(c->renderer);
    SDL_FreeSurface(c->surface);
}

#endif
