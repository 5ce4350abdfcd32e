#include "smooth_rectangle.h"

struct rectangle {
    struct pel_smooth smooth;
    struct pel_rect box, pixels; /* sub-pixels; and the pixels it touches */
};

/* The part of pixel i that lies in [from, to), 1/256. */
static int32_t part_of(int32_t i, int32_t from, int32_t to)
{
    return pel_min(to - PEL_PX(i), 256) - pel_max(from - PEL_PX(i), 0);
}

static inline int32_t coverage_at(const struct rectangle *k, int32_t x,
                                  int32_t y)
{
    const struct pel_rect *const box = &k->box;
    return (255 * part_of(x, box->x0, box->x1) * part_of(y, box->y0, box->y1) +
            32768) >>
           16;
}

/* Pixels that are painted at a time, beside full ones. */
enum { PIXELS = PEL_SMOOTH_TINY ? 8 : 32 };

/* Row y: those between its ends are alike. */
static PEL_NOINLINE_32 void paint_row(const struct rectangle *k, int32_t y,
                                      struct pel_span columns)
{
    const int32_t first = k->pixels.x0, last = k->pixels.x1 - 1;
    uint8_t coverage[PIXELS];
    struct pel_smooth_row row = {y, columns.x0, 0, 0, 0, coverage};
    int32_t x = row.x, area = coverage_at(k, x, y);
    for (; x < columns.x1; row.x = x) {
        int32_t n = 0;
        row.left = row.full = 0;
        for (; x < columns.x1 && n < PIXELS; x++) {
            if (x <= first + 1 || x >= last)
                area = coverage_at(k, x, y);
            if (area == 255 && row.full == 0) {
                row.left = n;
                row.full = pel_max(pel_min(last, columns.x1) - x, 1);
                x += row.full - 1;
            } else {
                coverage[n++] = (uint8_t)area;
            }
        }
        if (row.full == 0)
            row.left = n;
        row.right = n - row.left;
        pel_smooth_paint(&k->smooth, &row);
    }
}

/* Rows that are full but for both ends. */
static void paint_alike(struct rectangle *k, int32_t y, int32_t end)
{
    const int32_t first = k->pixels.x0, last = k->pixels.x1 - 1;
    struct pel_smooth_batch b;
    b.n = PEL_SMOOTH_BATCH_ROWS;
    for (int32_t i = 0; i < b.n; i++) {
        b.count[2 * i] = b.count[2 * i + 1] = 1;
        b.coverage[2 * i] = (uint8_t)coverage_at(k, first, y);
        b.coverage[2 * i + 1] = (uint8_t)coverage_at(k, last, y);
        b.at.full[i] = (struct pel_span){first + 1, last};
    }
    pel_smooth_clip_batch(&b, &k->smooth.target->clip);
    for (b.y = y; b.y < end; b.y += b.n) {
        b.n = pel_min(end - b.y, PEL_SMOOTH_BATCH_ROWS);
        pel_smooth_paint_batch(&k->smooth, &b);
    }
}

static void paint_box(struct rectangle *k)
{
    const struct pel_rect *const clip = &k->smooth.target->clip;
    const struct pel_rect seen = pel_rect_intersect(&k->pixels, clip);
    const int32_t end = pel_min(pel_pixel_of(k->box.y1), seen.y1);
    const struct pel_span columns = {seen.x0, seen.x1};
    const bool two = k->pixels.x0 + 1 < k->pixels.x1;
    if (pel_rect_empty(&seen))
        return;
    for (int32_t y = seen.y0; y < seen.y1; y++)
        if (!PEL_SMOOTH_TINY && two && y + 1 < end && PEL_PX(y) >= k->box.y0) {
            paint_alike(k, y, end);
            y = end - 1;
        } else {
            paint_row(k, y, columns);
        }
}

void pel_smooth_rectangle(const struct pel_surface *surface,
                          struct pel_point from, struct pel_point to,
                          const struct pel_paint *paint)
{
    struct rectangle k;
    const bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2, 0));
    if (!legal || from.x >= to.x || from.y >= to.y ||
        !pel_smooth_begin(&k.smooth, surface, paint))
        return;
    k.box = (struct pel_rect){from.x, from.y, to.x, to.y};
    k.pixels =
        (struct pel_rect){pel_pixel_of(from.x), pel_pixel_of(from.y),
                          pel_pixel_of(to.x + 255), pel_pixel_of(to.y + 255)};
    paint_box(&k);
}
