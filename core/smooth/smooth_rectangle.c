#include "smooth_rectangle.h"

#include "smooth_row.h"

struct rectangle {
    struct pel_smooth smooth;
    struct pel_rect box,
        pixels; /* sub-pixels, and the pixels that it touches */
    struct pel_smooth_batch batch;
};

/* The part of pixel i that lies in [from, to), 1/256. */
static int32_t part_of(int32_t i, int32_t from, int32_t to)
{
    return pel_min(to - PEL_PX(i), 256) - pel_max(from - PEL_PX(i), 0);
}

/* Of the row of the batch. */
static void cover(const void *shape, int32_t x, int32_t n, uint8_t *to)
{
    const struct rectangle *const k = shape;
    const struct pel_rect *const box = &k->box;
    const int32_t height = part_of(k->batch.y, box->y0, box->y1);
    for (; n > 0; n--, x++) {
        const int32_t width = part_of(x, box->x0, box->x1);
        *to++ = (uint8_t)((255 * width * height + 32768) >> 16);
    }
}

/* The pixels that a box of sub-pixels touches. */
static struct pel_rect touched_by(const struct pel_rect *box)
{
    const struct pel_rect r = {pel_pixel_of(box->x0), pel_pixel_of(box->y0),
                               pel_pixel_of(box->x1 + 255),
                               pel_pixel_of(box->y1 + 255)};
    return r;
}

/* Copies the first row of the batch to row i. */
static void copy_row(struct pel_smooth_batch *b, int32_t i)
{
    const int32_t all = b->count[0] + b->count[1];
    b->at.full[i] = b->at.full[0];
    b->count[2 * i] = b->count[0];
    b->count[2 * i + 1] = b->count[1];
    for (int32_t k = 0; k < all; k++)
        b->coverage[i * all + k] = b->coverage[k];
}

static void repeat_row(struct pel_smooth_batch *b)
{
    for (int32_t i = 1; i < PEL_SMOOTH_BATCH_ROWS; i++)
        copy_row(b, i);
}

static void paint_row(struct rectangle *k, struct pel_smooth_columns columns)
{
    while (columns.left.x0 < columns.left.x1) {
        pel_smooth_cover(&columns, &k->batch);
        pel_smooth_paint_batch(&k->smooth, &k->batch);
    }
}

/* Rows that are full but for both of their ends. */
static void paint_alike(struct rectangle *k, struct pel_smooth_columns *columns,
                        int32_t end)
{
    struct pel_smooth_batch *const b = &k->batch;
    pel_smooth_cover(columns, b);
    repeat_row(b);
    for (; b->y < end; b->y += b->n) {
        b->n = pel_min(end - b->y, PEL_SMOOTH_BATCH_ROWS);
        pel_smooth_paint_batch(&k->smooth, b);
    }
}

/* Rows of one height. */
static void paint_rows(struct rectangle *k, int32_t y, int32_t end)
{
    const struct pel_rect *const px = &k->pixels;
    const struct pel_rect *const clip = &k->smooth.target->clip;
    const struct pel_span crossed[2] = {{px->x0, px->x0 + 1},
                                        {px->x1 - 1, px->x1}};
    struct pel_smooth_columns columns = {
        {pel_max(px->x0, clip->x0), pel_min(px->x1, clip->x1)},
        crossed,
        2,
        cover,
        k,
        -1};
    k->batch.y = pel_max(y, clip->y0);
    end = pel_min(end, clip->y1);
    if (!PEL_SMALL_CODE && k->batch.y + 1 < end)
        paint_alike(k, &columns, end);
    for (; k->batch.y < end; k->batch.y++)
        paint_row(k, columns);
}

static void paint_box(struct rectangle *k)
{
    const struct pel_rect *const clip = &k->smooth.target->clip;
    const int32_t first = pel_pixel_of(k->box.y0 + 255);
    const int32_t last = pel_pixel_of(k->box.y1);
    k->pixels = touched_by(&k->box);
    if (k->pixels.x1 <= clip->x0 || k->pixels.x0 >= clip->x1)
        return;
    paint_rows(k, k->pixels.y0, first);
    paint_rows(k, first, last);
    paint_rows(k, pel_max(first, last), k->pixels.y1);
}

void pel_smooth_rectangle(const struct pel_surface *surface,
                          struct pel_point from, struct pel_point to,
                          const struct pel_paint *paint)
{
    struct rectangle k;
    const bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2, 0));
    k.box = (struct pel_rect){from.x, from.y, to.x, to.y};
    if (legal && pel_smooth_begin(&k.smooth, surface, paint) && from.x < to.x &&
        from.y < to.y)
        paint_box(&k);
}
