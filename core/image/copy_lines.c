#include "copy_lines.h"

#include "../format/word.h"

static bool within(int32_t v)
{
    return v >= -65536 && v <= 65536;
}

static bool copy_legal(const struct pel_copy_part *c)
{
    return within(c->area.x0) && within(c->area.y0) && within(c->area.x1) &&
           within(c->area.y1) && within(c->x) && within(c->y);
}

bool pel_copy_visible(const struct pel_surface *surface,
                      const struct pel_copy_part *copy,
                      struct pel_rect *visible)
{
    PEL_ASSERT(copy_legal(copy));
    if (!copy_legal(copy))
        return false;
    const int32_t dx = copy->x - copy->area.x0, dy = copy->y - copy->area.y0;
    struct pel_rect r = pel_rect_intersect(&copy->area, &copy->source->bounds);
    if (pel_rect_empty(&r))
        return false;
    r = (struct pel_rect){r.x0 + dx, r.y0 + dy, r.x1 + dx, r.y1 + dy};
    *visible = pel_rect_intersect(&r, &surface->clip);
    return !pel_rect_empty(visible);
}

void pel_copy_lines(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, pel_copy_weigh *weigh,
                    uint32_t option)
{
    const struct pel_surface *source = copy->source;
    pel_color colors[PEL_BUFFER_PIXELS];
    struct pel_rect r;
    if (!pel_copy_visible(surface, copy, &r))
        return;
    PEL_ASSERT(source->format->load && surface->format->put);
    if (!source->format->load || !surface->format->put)
        return;
    const int32_t dx = copy->x - copy->area.x0, dy = copy->y - copy->area.y0;
    const bool in_place = !weigh && source->format->id == PEL_FORMAT_ARGB8888 &&
                          PEL_LE32(UINT32_C(1)) == 1;
    for (int32_t y = r.y0; y < r.y1; y++)
        for (int32_t x = r.x0, n; x < r.x1; x += n) {
            n = in_place ? r.x1 - x : pel_min(r.x1 - x, PEL_BUFFER_PIXELS);
            const pel_color *from = colors;
            if (in_place)
                from = pel_address32(source, x - dx, y - dy);
            else
                source->format->load(source, x - dx, y - dy, n, colors);
            if (weigh)
                weigh(colors, n, option);
            surface->format->put(surface, x, y, n, from);
        }
}
