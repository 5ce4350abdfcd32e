#include "scroll.h"

#include <string.h>

#include "../raster/paint.h"

enum { CHUNK_BYTES = 64 };

/* A run of n pixels from (x, y) to (x + dx, y + dy), both in the surface. */
struct move {
    const struct pel_surface *surface;
    int32_t x, y, n, dx, dy;
};

/* Through a buffer, so that the pieces may overlap; those in the way of others
 * go first. */
static void move_bytes(const struct move *m)
{
    const struct pel_surface *s = m->surface;
    const int32_t pixel = s->format->bits / 8, left = s->bounds.x0;
    const uint8_t *from = pel_surface_line(s, m->y) + (m->x - left) * pixel;
    uint8_t *to =
        pel_surface_line(s, m->y + m->dy) + (m->x + m->dx - left) * pixel;
    uint8_t buffer[CHUNK_BYTES];
    int32_t size = m->n * pixel;
    for (int32_t done = 0, n; done < size; done += n) {
        n = pel_min(size - done, CHUNK_BYTES);
        int32_t at = m->dx > 0 ? size - done - n : done;
        memcpy(buffer, from + at, (size_t)n);
        memcpy(to + at, buffer, (size_t)n);
    }
}

/* The same for pixels that share a byte: packing what was unpacked changes
 * nothing. */
static void move_colors(const struct move *m)
{
    const struct pel_surface *s = m->surface;
    pel_color buffer[PEL_BUFFER_PIXELS];
    for (int32_t done = 0, n; done < m->n; done += n) {
        n = pel_min(m->n - done, PEL_BUFFER_PIXELS);
        int32_t x = m->x + (m->dx > 0 ? m->n - done - n : done);
        s->format->load(s, x, m->y, n, buffer);
        s->format->put(s, x + m->dx, m->y + m->dy, n, buffer);
    }
}

/* Lines in the way of others go first. */
static void move_lines(const struct pel_surface *surface,
                       const struct pel_rect *from, int32_t dx, int32_t dy)
{
    const bool bytes = surface->format->bits % 8 == 0;
    struct move m = {surface, from->x0, 0, from->x1 - from->x0, dx, dy};
    for (int32_t i = 0; i < from->y1 - from->y0; i++) {
        m.y = dy > 0 ? from->y1 - 1 - i : from->y0 + i;
        if (bytes)
            move_bytes(&m);
        else
            move_colors(&m);
    }
}

static void expose(struct pel_exposed *e, int32_t x0, int32_t y0, int32_t x1,
                   int32_t y1)
{
    const struct pel_rect r = {x0, y0, x1, y1};
    if (!pel_rect_empty(&r))
        e->rect[e->n++] = r;
}

/* `all` without `to`, which keeps to one corner of it. */
static struct pel_exposed exposed(const struct pel_rect *all,
                                  const struct pel_rect *to)
{
    struct pel_exposed e = {{{0, 0, 0, 0}, {0, 0, 0, 0}}, 0};
    if (pel_rect_empty(to)) {
        expose(&e, all->x0, all->y0, all->x1, all->y1);
        return e;
    }
    expose(&e, all->x0, all->y0, all->x1, to->y0);
    expose(&e, all->x0, to->y1, all->x1, all->y1);
    expose(&e, all->x0, to->y0, to->x0, to->y1);
    expose(&e, to->x1, to->y0, all->x1, to->y1);
    return e;
}

struct pel_exposed pel_scroll(const struct pel_surface *surface,
                              const struct pel_rect *area, int32_t dx,
                              int32_t dy)
{
    struct pel_rect all = pel_rect_intersect(area, &surface->clip), to = all;
    const bool legal = pel_offset_legal(dx, dy);
    PEL_ASSERT(legal);
    if (!legal || pel_rect_empty(&all))
        return (struct pel_exposed){{all, all}, 0};
    to.x0 = pel_max(all.x0, all.x0 + dx);
    to.y0 = pel_max(all.y0, all.y0 + dy);
    to.x1 = pel_min(all.x1, all.x1 + dx);
    to.y1 = pel_min(all.y1, all.y1 + dy);
    if (!pel_rect_empty(&to) && (dx || dy)) {
        struct pel_rect from = {to.x0 - dx, to.y0 - dy, to.x1 - dx, to.y1 - dy};
        move_lines(surface, &from, dx, dy);
    }
    return exposed(&all, &to);
}
