#include "display_dma.h"

#include <string.h>

enum { POISON = 0xA5 };

static size_t line_bytes(const struct pel_surface *s)
{
    return ((size_t)(s->clip.x1 - s->clip.x0) * s->format->bits + 7) / 8;
}

static uint8_t *line_at(const struct pel_surface *s, int32_t x, int32_t y)
{
    return pel_surface_line(s, y) + (x - s->bounds.x0) * s->format->bits / 8;
}

static bool is_poison(const uint8_t *bytes, size_t n)
{
    while (n && bytes[n - 1] == POISON)
        n--;
    return n == 0;
}

/* The pixels arrive, and are the program's again, as it left them. */
static void arrive(struct display_dma *dma)
{
    const struct pel_surface *s = &dma->source;
    const size_t n = line_bytes(s);
    const uint8_t *held = dma->held;
    for (int32_t y = s->clip.y0; y < s->clip.y1; y++, held += n) {
        uint8_t *line = line_at(s, s->clip.x0, y);
        dma->touched += !is_poison(line, n);
        memcpy(line, held, n);
        memcpy(line_at(&dma->screen, s->clip.x0, y), held, n);
    }
}

void display_dma_step(struct display_dma *dma)
{
    if (!dma->steps_left || dma->broken)
        return;
    if (--dma->steps_left == 0)
        arrive(dma);
}

static enum pel_status dma_wait(const struct pel_display *display)
{
    struct display_dma *dma = display->context;
    if (dma->steps_left && dma->broken)
        return PEL_ERROR_DEVICE;
    while (dma->steps_left)
        display_dma_step(dma);
    return PEL_OK;
}

static bool accepts(const struct display_dma *dma, const struct pel_rect *a)
{
    const int32_t w = dma->window ? dma->window : 1;
    const struct pel_rect *b = &dma->screen.bounds;
    const int bits = dma->screen.format->bits;
    if (a->x0 * bits % 8 || (a->x1 * bits % 8 && a->x1 != b->x1))
        return false;
    return a->x0 % w == 0 && a->y0 % w == 0 &&
           (a->x1 % w == 0 || a->x1 == b->x1) &&
           (a->y1 % w == 0 || a->y1 == b->y1) && a->x0 >= b->x0 &&
           a->y0 >= b->y0 && a->x1 <= b->x1 && a->y1 <= b->y1;
}

static void submit(struct display_dma *dma, const struct pel_surface *s)
{
    const size_t n = line_bytes(s);
    uint8_t *held = dma->held;
    for (int32_t y = s->clip.y0; y < s->clip.y1; y++, held += n) {
        uint8_t *line = line_at(s, s->clip.x0, y);
        memcpy(held, line, n);
        memset(line, POISON, n);
    }
    dma->source = *s;
    dma->transfers++;
    dma->bytes += (uint32_t)(held - dma->held);
    dma->steps_left = random_between(&dma->random, 1, dma->most_steps);
}

static enum pel_status dma_flush(const struct pel_display *display,
                                 const struct pel_surface *surface)
{
    struct display_dma *dma = display->context;
    const struct pel_rect *clip = &surface->clip;
    enum pel_status status = dma_wait(display);
    if (status != PEL_OK || pel_rect_empty(clip))
        return status;
    if (surface->format != dma->screen.format)
        return PEL_ERROR_FORMAT;
    if (!accepts(dma, clip) ||
        line_bytes(surface) * (size_t)(clip->y1 - clip->y0) > sizeof(dma->held))
        return PEL_ERROR_SIZE;
    submit(dma, surface);
    return PEL_OK;
}

static enum pel_status dma_flip(const struct pel_display *display)
{
    struct display_dma *dma = display->context;
    dma->flips++;
    return PEL_OK;
}

static void dma_align(const struct pel_display *display, struct pel_rect *area)
{
    const struct display_dma *dma = display->context;
    const struct pel_rect *bounds = &dma->screen.bounds;
    const int32_t w = dma->window;
    if (w) {
        const struct pel_rect grown = {area->x0 / w * w, area->y0 / w * w,
                                       (area->x1 + w - 1) / w * w,
                                       (area->y1 + w - 1) / w * w};
        *area = pel_rect_intersect(&grown, bounds);
    }
}

void display_dma_init(struct pel_display *display, struct display_dma *dma)
{
    *display = (struct pel_display){.context = dma,
                                    .width = dma->screen.bounds.x1,
                                    .height = dma->screen.bounds.y1,
                                    .format = dma->screen.format,
                                    .flush = dma_flush,
                                    .wait = dma_wait,
                                    .flip = dma_flip,
                                    .align = dma_align};
}
