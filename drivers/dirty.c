#include "dirty.h"

/* Below 2^30, of areas in the range that pel_dirty_areas_add keeps. */
static int32_t pixels(const struct pel_rect *r)
{
    return (r->x1 - r->x0) * (r->y1 - r->y0);
}

/* Makes the box of the two areas that it costs least to join. false: joining
 * any two costs more than a window, and there is room for all. */
static bool join(struct pel_dirty_areas *d)
{
    int32_t least = d->count > PEL_DIRTY_AREAS ? INT32_MAX : d->window;
    int32_t from = -1, to = -1;
    for (int32_t i = 1; i < d->count; i++)
        for (int32_t k = 0; k < i; k++) {
            const struct pel_rect *a = &d->area[i], *b = &d->area[k];
            const struct pel_rect box = pel_rect_join(a, b);
            const int32_t cost = pixels(&box) - pixels(a) - pixels(b);
            if (cost < least) {
                least = cost;
                from = i;
                to = k;
            }
        }
    if (from < 0)
        return false;
    d->area[to] = pel_rect_join(&d->area[from], &d->area[to]);
    d->area[from] = d->area[--d->count];
    return true;
}

void pel_dirty_areas_add(struct pel_dirty_areas *dirty,
                         const struct pel_rect *area)
{
    const struct pel_rect most = {0, 0, 32767, 32767};
    const struct pel_rect part = pel_rect_intersect(area, &most);
    if (pel_rect_empty(&part))
        return;
    dirty->area[dirty->count++] = part;
    while (join(dirty)) {
    }
}

/* Rows of an area's bands: as many times those of the narrowest window as fit.
 * Of pages, those of a page. */
static int32_t rows_of(const struct pel_display *display,
                       const struct pel_rect *area, int32_t stride, size_t size)
{
    const bool pages = display->format->id == PEL_FORMAT_MONO1_PAGES;
    const size_t fit = size / (size_t)stride * (pages ? 8 : 1);
    const int32_t rows = fit < 32760 ? (int32_t)fit : 32760;
    struct pel_rect window = *area;
    window.y1 = window.y0 + 1;
    pel_display_align(display, &window);
    return rows - rows % (window.y1 - window.y0);
}

static enum pel_status show_band(const struct pel_display *display,
                                 const struct pel_dirty_work *work,
                                 void *memory, int32_t stride,
                                 const struct pel_rect *band)
{
    struct pel_surface surface;
    enum pel_status status = PEL_OK;
    if (!display->begin) {
        if (!work->memory[1])
            status = pel_display_wait(display);
        if (status == PEL_OK)
            status = pel_surface_init_rect(&surface, display->format, memory,
                                           stride, band);
    }
    if (status == PEL_OK)
        status = pel_display_begin(display, band, &surface);
    if (status != PEL_OK)
        return status;
    work->draw(work->context, &surface);
    return pel_display_flush(display, &surface);
}

/* The bands of one area. `turn` counts them. */
static enum pel_status show_area(const struct pel_display *display,
                                 const struct pel_dirty_work *work,
                                 struct pel_rect area, int32_t *turn)
{
    const struct pel_rect screen = {0, 0, display->width, display->height};
    enum pel_status status = PEL_OK;
    area = pel_rect_intersect(&area, &screen);
    if (pel_rect_empty(&area))
        return PEL_OK;
    pel_display_align(display, &area);
    const int32_t stride = display->stride
                               ? display->stride
                               : pel_stride(display->format, area.x1 - area.x0);
    const int32_t rows =
        display->begin ? 32767 : rows_of(display, &area, stride, work->size);
    if (rows == 0)
        return PEL_ERROR_SCRATCH;
    for (; area.y0 < area.y1 && status == PEL_OK; area.y0 += rows) {
        struct pel_rect band = area;
        band.y1 = pel_min(area.y0 + rows, area.y1);
        void *memory = work->memory[work->memory[1] ? *turn & 1 : 0];
        status = show_band(display, work, memory, stride, &band);
        ++*turn;
    }
    return status;
}

enum pel_status pel_dirty_areas_show(struct pel_dirty_areas *dirty,
                                     const struct pel_display *display,
                                     const struct pel_dirty_work *work)
{
    /* A round that ended with an error may have left a band in flight. */
    enum pel_status status = pel_display_wait(display);
    int32_t turn = 0;
    for (int32_t i = 0; i < dirty->count && status == PEL_OK; i++)
        status = show_area(display, work, dirty->area[i], &turn);
    if (status == PEL_OK)
        status = pel_display_flip(display);
    if (status == PEL_OK)
        dirty->count = 0;
    return status;
}
