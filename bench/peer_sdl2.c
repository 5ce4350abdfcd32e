/* SDL2: SDL_RenderGeometry and lines on a software renderer, one call for all
 * shapes; copies from surface to surface, boxes into one. */
#include "method.h"

#include <stdlib.h>

#include <SDL.h>

/* A software renderer that draws into a canvas. */
struct sdl2_canvas {
    SDL_Surface *surface;
    SDL_Renderer *renderer;
};

static struct sdl2_canvas sdl2_canvas_open(const struct canvas *c)
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

static void sdl2_canvas_close(const struct sdl2_canvas *c)
{
    SDL_DestroyRenderer(c->renderer);
    SDL_FreeSurface(c->surface);
}

struct job {
    struct sdl2_canvas canvas;
    SDL_Surface *sprite;
    const struct workload *workload;
    SDL_Vertex *vertex;
};

static SDL_Vertex vertex_of(const struct workload *w, const struct shape *s,
                            int k)
{
    const uint32_t color = s->color[w->paint == PAINT_GOURAUD ? k : 0];
    SDL_Vertex v = {
        {(float)s->x[k], (float)s->y[k]},
        {(uint8_t)(color >> 16), (uint8_t)(color >> 8), (uint8_t)color, 255},
        {0, 0}};
    if (w->paint == PAINT_ALPHA)
        v.color.a = WORKLOAD_ALPHA;
    return v;
}

/* In the format of the canvas, or with alpha. */
static void open_sprite(struct job *job, enum paint paint)
{
    SDL_Surface *all = SDL_CreateRGBSurfaceWithFormatFrom(
        (void *)(uintptr_t)workload_sprite(paint), SPRITE_SIDE, SPRITE_SIDE, 32,
        SPRITE_SIDE * 4, SDL_PIXELFORMAT_ARGB8888);
    const Uint32 format =
        paint == PAINT_COPY_ALPHA ? (Uint32)SDL_PIXELFORMAT_ARGB8888
        : paint == PAINT_CONVERT  ? (Uint32)SDL_PIXELFORMAT_RGB888
                                  : job->canvas.surface->format->format;
    if (all)
        job->sprite = SDL_ConvertSurfaceFormat(all, format, 0);
    if (!job->sprite)
        method_fail(SDL_GetError(), "check the installation of SDL2");
    SDL_FreeSurface(all);
    SDL_SetSurfaceBlendMode(job->sprite, paint == PAINT_COPY_ALPHA
                                             ? SDL_BLENDMODE_BLEND
                                             : SDL_BLENDMODE_NONE);
    if (paint == PAINT_KEYED)
        SDL_SetColorKey(job->sprite, SDL_TRUE,
                        SDL_MapRGB(job->sprite->format, SPRITE_KEY >> 16,
                                   SPRITE_KEY >> 8 & 255, SPRITE_KEY & 255));
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (w->form == FORM_CIRCLE || w->form == FORM_POLYGON ||
        w->form == FORM_STROKE || w->form == FORM_TEXT ||
        w->form == FORM_ROUNDED ||
        (w->form != FORM_COPY && w->paint > PAINT_GOURAUD))
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    job->canvas = sdl2_canvas_open(c);
    open_sprite(job, w->paint);
    SDL_SetRenderDrawBlendMode(job->canvas.renderer, w->paint == PAINT_ALPHA
                                                         ? SDL_BLENDMODE_BLEND
                                                         : SDL_BLENDMODE_NONE);
    job->workload = w;
    job->vertex = method_allocate(w->count * 3, sizeof *job->vertex);
    for (int i = 0; i < w->count * 3; i++)
        job->vertex[i] = vertex_of(w, &w->shape[i / 3], i % 3);
    return job;
}

static void draw_lines(const struct job *job, int first, int n)
{
    const struct shape *s = job->workload->shape + first;
    for (; n > 0; n--, s++) {
        SDL_SetRenderDrawColor(
            job->canvas.renderer, (uint8_t)(s->color[0] >> 16),
            (uint8_t)(s->color[0] >> 8), (uint8_t)s->color[0], 255);
        SDL_RenderDrawLine(job->canvas.renderer, s->x[0], s->y[0], s->x[1],
                           s->y[1]);
    }
}

static void draw_copies(const struct job *job, int first, int n)
{
    const struct shape *s = job->workload->shape + first;
    for (; n > 0; n--, s++) {
        SDL_Rect to = {s->x[0], s->y[0], 0, 0};
        SDL_BlitSurface(job->sprite, NULL, job->canvas.surface, &to);
    }
}

static void draw_boxes(const struct job *job, int first, int n)
{
    SDL_Surface *to = job->canvas.surface;
    const struct shape *s = job->workload->shape + first;
    for (; n > 0; n--, s++) {
        const SDL_Rect box = {s->x[0], s->y[0], s->x[1] - s->x[0],
                              s->y[1] - s->y[0]};
        SDL_FillRect(to, &box,
                     SDL_MapRGB(to->format, (uint8_t)(s->color[0] >> 16),
                                (uint8_t)(s->color[0] >> 8),
                                (uint8_t)s->color[0]));
    }
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    if (job->workload->form == FORM_COPY)
        draw_copies(job, first, n);
    else if (job->workload->form == FORM_BOX ||
             job->workload->form == FORM_SCREEN)
        draw_boxes(job, first, n);
    else if (job->workload->form == FORM_LINE)
        draw_lines(job, first, n);
    else if (SDL_RenderGeometry(job->canvas.renderer, NULL,
                                job->vertex + first * 3, n * 3, NULL, 0))
        method_fail(SDL_GetError(), "SDL2 2.0.18 or later is needed");
    SDL_RenderFlush(job->canvas.renderer);
}

static void close_job(void *data)
{
    struct job *job = data;
    SDL_FreeSurface(job->sprite);
    sdl2_canvas_close(&job->canvas);
    free(job->vertex);
    free(job);
}

extern const struct method method_sdl2;
const struct method method_sdl2 = {"sdl2", "packaged", open_job, draw,
                                   close_job};
