/* SDL2_gfx: its shapes without antialiasing on a software renderer of SDL2. */
#include "sdl2_canvas.h"

#include <stdlib.h>
#include <string.h>

#include <SDL2_gfxPrimitives.h>

#include "letters.h"

struct item {
    Sint16 x[SHAPE_VERTICES], y[SHAPE_VERTICES];
    Uint32 color; /* its bytes are R, G, B, A */
};

struct job {
    struct sdl2_canvas canvas;
    const struct workload *workload;
    struct item *item;
};

static struct item item_of(const struct workload *w, const struct shape *s)
{
    const uint32_t rgb = s->color[0];
    const uint32_t alpha = w->paint == PAINT_ALPHA ? WORKLOAD_ALPHA : 255;
    struct item item = {{0}, {0}, SDL_SwapBE32((rgb & 0xFFFFFFu) << 8 | alpha)};
    for (int k = 0; k < SHAPE_VERTICES; k++) {
        item.x[k] = (Sint16)s->x[k];
        item.y[k] = (Sint16)s->y[k];
    }
    return item;
}

/* SDL2_gfx wants 256 letters, and keeps the pictures of those it has drawn. */
static void set_font(void)
{
    static uint8_t font[256 * sizeof letters_bits];
    memcpy(font + sizeof letters_bits * (uint8_t)letters_line[0], letters_bits,
           sizeof letters_bits);
    gfxPrimitivesSetFont(font, LETTER_SIDE, LETTER_SIDE);
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (w->form == FORM_SCREEN || w->form == FORM_COPY ||
        w->paint > PAINT_ALPHA)
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    job->canvas = sdl2_canvas_open(c);
    job->workload = w;
    set_font();
    job->item = method_allocate(w->count, sizeof *job->item);
    for (int i = 0; i < w->count; i++)
        job->item[i] = item_of(w, &w->shape[i]);
    return job;
}

static void draw_item(SDL_Renderer *to, const struct workload *w,
                      const struct item *i)
{
    const Sint16 *x = i->x, *y = i->y;
    if (w->form == FORM_CIRCLE)
        filledCircleColor(to, x[0], y[0], (Sint16)w->size, i->color);
    else if (w->form == FORM_LINE)
        lineColor(to, x[0], y[0], x[1], y[1], i->color);
    else if (w->form == FORM_TEXT)
        stringColor(to, x[0], y[0], letters_line, i->color);
    else if (w->form == FORM_POLYGON)
        filledPolygonColor(to, x, y, SHAPE_VERTICES, i->color);
    else
        filledTrigonColor(to, x[0], y[0], x[1], y[1], x[2], y[2], i->color);
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    for (const struct item *i = job->item + first; n > 0; n--, i++)
        draw_item(job->canvas.renderer, job->workload, i);
    SDL_RenderFlush(job->canvas.renderer);
}

static void close_job(void *data)
{
    struct job *job = data;
    gfxPrimitivesSetFont(NULL, 0, 0); /* drops the renderer's pictures */
    sdl2_canvas_close(&job->canvas);
    free(job->item);
    free(job);
}

extern const struct method method_sdl2_gfx;
const struct method method_sdl2_gfx = {"sdl2_gfx", "packaged", open_job, draw,
                                       close_job};
