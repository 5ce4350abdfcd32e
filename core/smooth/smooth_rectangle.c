#include "smooth_rectangle.h"

#include "smooth_layer.h"

struct rectangle {
    struct pel_smooth smooth;
    struct pel_rect box, pixels; /* sub-pixels; and the pixels it touches */
};

/* The part of pixel i that lies in [from, to), 1/256. */
static int32_t part_of(int32_t i, int32_t from, int32_t to)
{
    return pel_min(to - PEL_PX(i), 256) - pel_max(from - PEL_PX(i), 0);
}

static inline int32_t coverage_at(const struct pel_rect *box, int32_t x,
                                  int32_t y)
{
    return (255 * part_of(x, box->x0, box->x1) * part_of(y, box->y0, box->y1) +
            32768) >>
           16;
}

/* Pixels that are painted at a time, beside full ones. */
enum { PIXELS = 32 };

/* Row y: those between its ends are alike. */
static PEL_NOINLINE_32 void paint_row(const struct rectangle *k, int32_t y,
                                      struct pel_span columns)
{
    const int32_t first = k->pixels.x0, last = k->pixels.x1 - 1;
    uint8_t coverage[PIXELS];
    struct pel_smooth_row row = {y, columns.x0, 0, 0, 0, coverage};
    int32_t x = row.x, area = coverage_at(&k->box, x, y);
    for (; x < columns.x1; row.x = x) {
        int32_t n = 0;
        row.left = row.full = 0;
        for (; x < columns.x1 && n < PIXELS; x++) {
            if (x <= first + 1 || x >= last)
                area = coverage_at(&k->box, x, y);
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
        b.coverage[2 * i] = (uint8_t)coverage_at(&k->box, first, y);
        b.coverage[2 * i + 1] = (uint8_t)coverage_at(&k->box, last, y);
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
        if (two && y + 1 < end && PEL_PX(y) >= k->box.y0) {
            paint_alike(k, y, end);
            y = end - 1;
        } else {
            paint_row(k, y, columns);
        }
}

/* The pixels that it touches. */
static struct pel_rect pixels_of(const struct pel_rect *box)
{
    return (struct pel_rect){pel_pixel_of(box->x0), pel_pixel_of(box->y0),
                             pel_pixel_of(box->x1 + 255),
                             pel_pixel_of(box->y1 + 255)};
}

static void paint_rows(const struct pel_surface *surface,
                       const struct pel_rect *box,
                       const struct pel_paint *paint)
{
    struct rectangle k;
    k.box = *box;
    k.pixels = pixels_of(box);
    if (pel_smooth_begin(&k.smooth, surface, paint))
        paint_box(&k);
}

/* For little stack: this and what a paint is given are all that lives when it
 * is called. */
struct short_rectangle {
    struct pel_smooth_pixels pixels;
    struct pel_rect box, seen; /* seen in pixels */
    struct pel_smooth_drawing drawing;
};

static PEL_NOINLINE bool begin(struct short_rectangle *k,
                               const struct pel_surface *surface)
{
    const struct pel_rect pixels = pixels_of(&k->box);
    k->seen = pel_rect_intersect(&pixels, &surface->clip);
    k->pixels.span.x1 = k->seen.x0;
    k->pixels.y = k->seen.y0;
    k->pixels.coverage[0] = 255;
    return pel_smooth_begin(&k->pixels.smooth, surface,
                            k->pixels.smooth.paint) &&
           !pel_rect_empty(&k->seen);
}

/* Takes pixels that are alike: the first, the last, or those between. */
static PEL_NOINLINE void take(struct short_rectangle *k)
{
    const int32_t x = k->pixels.span.x1;
    const int32_t first = pel_pixel_of(k->box.x0);
    const int32_t last = pel_pixel_of(k->box.x1 + 255) - 1;
    const int32_t area = coverage_at(&k->box, x, k->pixels.y);
    int32_t end = x + 1;
    if (x < last && (x > first || area == 255))
        end = pel_min(last, k->seen.x1);
    pel_smooth_take_alike(&k->pixels, (uint8_t)area, end - x);
}

static PEL_NOINLINE bool next(struct short_rectangle *k)
{
    do {
        pel_smooth_end_span(&k->pixels, &k->drawing);
        if (k->pixels.span.x1 == k->seen.x1) {
            k->pixels.span.x1 = k->seen.x0;
            k->pixels.y++;
        }
        if (k->pixels.y == k->seen.y1)
            return false;
        take(k);
    } while (!pel_smooth_begin_span(&k->pixels, &k->drawing));
    return true;
}

static PEL_NOINLINE_32 bool is_drawn(const struct pel_rect *box)
{
    const struct pel_point ends[2] = {{box->x0, box->y0}, {box->x1, box->y1}};
    const bool legal = pel_points_legal(ends, 2);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(ends, 2, 0));
    return legal && !pel_rect_empty(box);
}

static PEL_ALWAYS_INLINE void paint_short(const struct pel_surface *surface,
                                          const struct pel_rect *box,
                                          const struct pel_paint *paint)
{
    struct short_rectangle k;
    k.box = *box;
    k.pixels.smooth.paint = paint;
    if (!is_drawn(&k.box) || !begin(&k, surface))
        return;
    while (next(&k))
        pel_smooth_fill(&k.pixels, &k.drawing);
}

void pel_smooth_rectangle(const struct pel_surface *surface,
                          struct pel_point from, struct pel_point to,
                          const struct pel_paint *paint)
{
    const struct pel_rect box = {from.x, from.y, to.x, to.y};
    if (PEL_SMOOTH_TINY)
        paint_short(surface, &box, paint);
    else if (is_drawn(&box))
        paint_rows(surface, &box, paint);
}
