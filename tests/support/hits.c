#include "hits.h"

#include <string.h>

#include "cases.h"
#include "check.h"

static size_t index_of(const struct hits *h, int32_t x, int32_t y)
{
    const struct pel_rect *b = &h->surface.bounds;
    return (size_t)(y - b->y0) * (size_t)(b->x1 - b->x0) + (size_t)(x - b->x0);
}

static void count_run(struct hits *h, int32_t y, const struct pel_span *row)
{
    const struct pel_rect *clip = &h->surface.clip;
    if (row->x0 >= row->x1)
        return;
    if (row->x0 < clip->x0 || row->x1 > clip->x1 || y < clip->y0 ||
        y >= clip->y1)
        fail_msg("%d..%d, %d lies outside the clip; %s", row->x0, row->x1, y,
                 cases_replay());
    uint8_t *count = &h->count[index_of(h, row->x0, y)];
    for (int32_t x = row->x0; x < row->x1; x++, count++)
        if (++*count > h->limit)
            fail_msg("%d, %d is painted %d times; %s", x, y, *count,
                     cases_replay());
    h->pixels += (uint64_t)(row->x1 - row->x0);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *rows)
{
    struct hits *h = (struct hits *)(uintptr_t)paint;
    int32_t y = rows->y;
    assert_ptr_equal(rows->surface, &h->surface);
    assert_in_range(rows->n, 1, PEL_BATCH_ROWS);
    assert_in_range(rows->step, 0, 1);
    for (int i = 0; i < rows->n; i++, y += rows->step)
        count_run(h, y, &rows->span[i]);
    h->batches++;
    h->runs += (uint64_t)rows->n;
}

void hits_open(struct hits *h, const struct pel_rect *bounds)
{
    static uint8_t nothing;
    int32_t width = bounds->x1 - bounds->x0, height = bounds->y1 - bounds->y0;
    assert_true(width * height <= HITS_MAX);
    h->paint = (struct pel_paint){.fill = fill};
    assert_int_equal(
        pel_surface_init_rect(&h->surface, &pel_gray8, &nothing, width, bounds),
        PEL_OK);
    h->limit = 1;
    h->batches = h->runs = h->pixels = 0;
    memset(h->count, 0, (size_t)(width * height));
}

uint8_t hits_at(const struct hits *h, int32_t x, int32_t y)
{
    return h->count[index_of(h, x, y)];
}

void hits_check(const struct hits *h, hits_expected *expected,
                const void *shape, const char *name)
{
    const struct pel_rect *clip = &h->surface.clip;
    for (int32_t y = clip->y0; y < clip->y1; y++)
        for (int32_t x = clip->x0; x < clip->x1; x++) {
            bool want = expected(shape, x, y);
            if (want != (hits_at(h, x, y) != 0))
                fail_msg("%s: pixel %d, %d: expected %d, got %d; %s", name, x,
                         y, want, !want, cases_replay());
        }
}
