#include "bands.h"

enum { BANDS_PER_THREAD = 4 };

struct bands {
    const struct pel_surface *surface;
    pel_bands_work *work;
    void *context;
    int32_t first, rows; /* of the first band; of each */
};

/* A view of rows [y0, y1) of a surface. A line of mono1_pages is a page of 8
 * rows, and all bounds are multiples of 8. */
static struct pel_surface rows_of(const struct pel_surface *s, int32_t y0,
                                  int32_t y1)
{
    struct pel_surface band = *s;
    const int32_t lines = s->format->id == PEL_FORMAT_MONO1_PAGES ? 8 : 1;
    band.pixels =
        (uint8_t *)s->pixels +
        (ptrdiff_t)((y0 - s->bounds.y0) / lines) * (ptrdiff_t)s->stride;
    band.bounds.y0 = y0;
    band.bounds.y1 = y1;
    band.clip = pel_rect_intersect(&s->clip, &band.bounds);
    return band;
}

static void draw_band(void *context, int index)
{
    const struct bands *bands = context;
    const struct pel_surface *s = bands->surface;
    const int32_t y0 = bands->first + index * bands->rows;
    const struct pel_surface band =
        rows_of(s, y0, pel_min(y0 + bands->rows, s->bounds.y1));
    bands->work(bands->context, &band);
}

void pel_bands_draw(struct pel_pool *pool, const struct pel_surface *surface,
                    pel_bands_work *work, void *context)
{
    struct bands bands = {surface, work, context, 0, 0};
    const struct pel_rect *clip = &surface->clip;
    const int32_t most = (pool->threads + 1) * BANDS_PER_THREAD;
    if (pel_rect_empty(clip))
        return;
    bands.first = clip->y0 - ((clip->y0 - surface->bounds.y0) & 7);
    const int32_t height = clip->y1 - bands.first;
    bands.rows = ((height + most - 1) / most + 7) & ~7;
    pel_pool_run(pool, (height + bands.rows - 1) / bands.rows, draw_band,
                 &bands);
}
