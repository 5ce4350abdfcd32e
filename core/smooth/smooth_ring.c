#include "smooth_ring.h"

#include "ring_rows.h"

/* A half of a row, from the axis on; that on the left in the mirrored picture.
 */
struct half {
    struct pel_smooth_strip disc, hole;
    struct pel_span clip; /* columns that are to be seen */
    int32_t center;
    bool left;
};

static void set_half(struct half *h, const struct pel_smooth_ring_walk *ring,
                     bool left)
{
    const struct pel_rect *const clip = &ring->rows.smooth.target->clip;
    const int32_t center = ring->rows.round.left;
    h->left = left;
    h->center = left ? -center : center;
    h->clip = left ? (struct pel_span){-clip->x1, -clip->x0}
                   : (struct pel_span){clip->x0, clip->x1};
}

static bool find_strips(struct pel_smooth_ring_walk *ring, int32_t y,
                        struct half *h)
{
    const struct pel_smooth_round *const round = &ring->rows.round;
    return pel_smooth_disc_strip(&ring->rows.disc, round, y, &h->disc) &&
           pel_smooth_disc_strip(&ring->hole, round, y, &h->hole);
}

/* Are there full pixels between the sides, in any column? */
static bool is_apart(const struct half *h)
{
    return h->disc.at_far - h->hole.at_near >= 65536;
}

/* Bytes that a half takes, wherever its centre is. */
static int32_t room_of(const struct half *h)
{
    const int32_t disc = h->disc.at_near - h->disc.at_far;
    const int32_t hole = h->hole.at_near - h->hole.at_far;
    if (is_apart(h))
        return (disc >> 16) + (hole >> 16) + 4;
    return ((h->disc.at_near - h->hole.at_far) >> 16) + 2;
}

/* The coverage of columns that may belong to both sides. */
static void put_both(struct half *h, const struct pel_span *columns,
                     uint8_t *to)
{
    uint16_t area[PEL_SMOOTH_PIXELS], hole[PEL_SMOOTH_PIXELS];
    const int32_t step = h->left ? -1 : 1;
    to += h->left ? columns->x1 - columns->x0 - 1 : 0;
    pel_smooth_strip_set(&h->disc);
    pel_smooth_strip_set(&h->hole);
    for (int32_t x = columns->x0, n; x < columns->x1; x += n) {
        n = pel_min(columns->x1 - x, PEL_SMOOTH_PIXELS);
        pel_smooth_strip_areas(&h->disc, h->center, x, n, area);
        pel_smooth_strip_areas(&h->hole, h->center, x, n, hole);
        for (int32_t i = 0; i < n; i++, to += step)
            *to = pel_smooth_coverage((uint32_t)(area[i] - hole[i]));
    }
}

static void add_both(struct pel_smooth_batch *b, struct half *h, uint8_t *to)
{
    const struct pel_span hole = pel_smooth_crossed(&h->hole, h->center);
    const struct pel_span disc = pel_smooth_crossed(&h->disc, h->center);
    const struct pel_span both = {hole.x0, disc.x1};
    const int32_t end = h->left ? -both.x0 : both.x1;
    const int32_t n = pel_smooth_seen(&both, h->clip.x0, h->clip.x1);
    if (n > 0)
        put_both(h, &both, to);
    b->count[2 * b->n] = (uint8_t)n;
    b->count[2 * b->n + 1] = 0;
    b->at.full[b->n++] = (struct pel_span){end, end};
}

/* The bytes of a side, the first one in the half's direction at `to`. */
static void put_side(const struct half *h, struct pel_smooth_strip *s,
                     uint8_t *to)
{
    pel_smooth_strip_set(s);
    pel_smooth_whole_side(s, h->center, s == &h->hole, to, h->left ? -1 : 1);
}

static void add_sides(struct pel_smooth_batch *b, struct half *h, uint8_t *to)
{
    const struct pel_span hole = pel_smooth_crossed(&h->hole, h->center);
    const struct pel_span disc = pel_smooth_crossed(&h->disc, h->center);
    const int32_t inner = pel_smooth_seen(&hole, h->clip.x0, h->clip.x1);
    const int32_t outer = pel_smooth_seen(&disc, h->clip.x0, h->clip.x1);
    uint8_t *const count = b->count + 2 * b->n;
    b->at.full[b->n] = (struct pel_span){hole.x1, disc.x0};
    if (h->left)
        b->at.full[b->n] = (struct pel_span){-disc.x0, -hole.x1};
    if (inner > 0)
        put_side(h, &h->hole, h->left ? to + inner + outer - 1 : to);
    if (outer > 0)
        put_side(h, &h->disc, h->left ? to + outer - 1 : to + inner);
    count[h->left] = (uint8_t)inner;
    count[!h->left] = (uint8_t)outer;
    b->n++;
}

static void add_half(struct pel_smooth_batch *b, struct half *h, uint8_t *to)
{
    if (is_apart(h))
        add_sides(b, h, to);
    else
        add_both(b, h, to);
}

/* A batch of halves of the next rows, up to `end`, of those that both circles
 * cross as whole strips. */
static void add_halves(struct pel_smooth_ring_walk *ring, int32_t end,
                       bool left)
{
    struct pel_smooth_rows *const rows = &ring->rows;
    struct pel_smooth_batch *const b = &rows->batch;
    uint8_t *to = b->coverage;
    int32_t room = PEL_SMOOTH_BATCH_BYTES;
    struct half h;
    set_half(&h, ring, left);
    b->y = rows->rows.x0;
    b->n = 0;
    while (b->n < PEL_SMOOTH_BATCH_ROWS && rows->rows.x0 < end &&
           find_strips(ring, rows->rows.x0, &h)) {
        room -= room_of(&h);
        if (h.hole.at_far < 65536 || room < 0)
            break;
        add_half(b, &h, to);
        to += b->count[2 * b->n - 2] + b->count[2 * b->n - 1];
        rows->disc.at = rows->disc.next;
        ring->hole.at = ring->hole.next;
        rows->rows.x0++;
    }
    if (!rows->inside)
        pel_smooth_clip_batch(b, &rows->smooth.target->clip);
}

/* The left halves of rows whose right ones have been filled. */
static void fill_again(struct pel_smooth_ring_walk *ring)
{
    ring->rows.rows.x0 = ring->filled.x0;
    ring->rows.disc.at = ring->at[0];
    ring->hole.at = ring->at[1];
    add_halves(ring, ring->filled.x1, true);
}

static void turn_round(uint8_t *from, uint8_t *end)
{
    while (from < --end) {
        const uint8_t first = *from;
        *from++ = *end;
        *end = first;
    }
}

/* The same by mirroring the batch: ends of columns add up to `sum`. */
static void mirror(struct pel_smooth_batch *b, int32_t sum)
{
    uint8_t *from = b->coverage;
    for (int32_t i = 0; i < b->n; i++) {
        const struct pel_span full = b->at.full[i];
        uint8_t *const count = b->count + 2 * i, left = count[0];
        uint8_t *const end = from + count[0] + count[1];
        turn_round(from, end);
        from = end;
        count[0] = count[1];
        count[1] = left;
        b->at.full[i] = (struct pel_span){sum - full.x1, sum - full.x0};
    }
}

static void cover(const void *shape, int32_t x, int32_t n, uint8_t *to)
{
    const struct pel_smooth_ring_walk *const ring = shape;
    const struct pel_smooth_round *const round = &ring->rows.round;
    const struct pel_span columns = {x, x + n};
    uint16_t sum[PEL_SMOOTH_PIXELS];
    for (int32_t i = 0; i < n; i++)
        sum[i] = 0;
    pel_smooth_disc_add(&ring->hole, round, ring->rows.rows.x0 - 1, &columns,
                        sum);
    for (int32_t i = 0; i < n; i++)
        sum[i] = (uint16_t)-sum[i];
    pel_smooth_disc_add(&ring->rows.disc, round, ring->rows.rows.x0 - 1,
                        &columns, sum);
    for (int32_t i = 0; i < n; i++)
        to[i] = pel_smooth_coverage(sum[i]);
}

/* A batch of what is left of a row. */
static void rest_of_row(struct pel_smooth_ring_walk *ring)
{
    struct pel_smooth_rows *const rows = &ring->rows;
    struct pel_span crossed[4];
    struct pel_smooth_columns c = {rows->rest, crossed, 4, cover, ring, -1};
    pel_smooth_disc_reach(&rows->disc, &rows->round, rows->rows.x0 - 1,
                          crossed);
    pel_smooth_disc_reach(&ring->hole, &rows->round, rows->rows.x0 - 1,
                          crossed + 2);
    pel_smooth_rows_rest(rows, &c);
}

/* Rows with a hole, or without, end there. */
static bool has_hole(const struct pel_smooth_ring_walk *ring, int32_t *end)
{
    const int32_t y = ring->rows.rows.x0, radius = ring->hole.circle.radius;
    const int32_t top = pel_pixel_of(ring->rows.round.top - radius);
    const int32_t bottom = pel_pixel_of(ring->rows.round.top + radius + 255);
    *end = ring->rows.rows.x1;
    if (y < bottom)
        *end = pel_min(*end, y < top ? top : bottom);
    return y >= top && y < bottom;
}

/* May the clip have columns of a half? */
static bool is_seen(const struct pel_smooth_ring_walk *ring, bool left)
{
    const struct pel_rect *const clip = &ring->rows.smooth.target->clip;
    const int32_t axis = pel_pixel_of(ring->rows.round.left);
    return left ? clip->x0 <= axis : clip->x1 > axis;
}

/* A batch of whole strips, if the next row is one; of halves that the clip has.
 */
static bool add_rows(struct pel_smooth_ring_walk *ring)
{
    struct pel_smooth_rows *const rows = &ring->rows;
    int32_t end;
    if (!has_hole(ring, &end))
        return pel_smooth_rows_batch(rows, end) > 0;
    ring->at[0] = rows->disc.at;
    ring->at[1] = ring->hole.at;
    ring->filled.x0 = rows->rows.x0;
    add_halves(ring, end, !is_seen(ring, false));
    ring->filled.x1 = rows->rows.x0;
    if (!is_seen(ring, false) || !is_seen(ring, true))
        ring->filled.x0 = ring->filled.x1;
    return rows->batch.n > 0;
}

static void add_left(struct pel_smooth_ring_walk *ring)
{
    struct pel_smooth_rows *const rows = &ring->rows;
    if (rows->twin_columns && rows->inside)
        mirror(&rows->batch, (2 * rows->round.left) >> 8);
    else
        fill_again(ring);
    ring->filled.x0 = ring->filled.x1;
}

PEL_NOINLINE_32 bool pel_smooth_ring_next(struct pel_smooth_ring_walk *ring)
{
    struct pel_smooth_rows *const rows = &ring->rows;
    if (!PEL_SMALL_CODE && ring->filled.x0 < ring->filled.x1) {
        add_left(ring);
        return true;
    }
    if (rows->rest.x0 >= rows->rest.x1) {
        if (rows->rows.x0 >= rows->rows.x1)
            return false;
        if (!PEL_SMALL_CODE && add_rows(ring))
            return true;
        pel_smooth_rows_pass(rows);
        pel_smooth_disc_go(&ring->hole, &rows->round, rows->rows.x0);
    }
    rest_of_row(ring);
    return true;
}

bool pel_smooth_ring_begin(struct pel_smooth_ring_walk *ring,
                           const struct pel_surface *surface,
                           const struct pel_ring_shape *shape,
                           const struct pel_paint *paint)
{
    const struct pel_point c = shape->center;
    ring->filled = (struct pel_span){0, 0};
    ring->rows.round =
        (struct pel_smooth_round){c.x, c.x, c.y, c.y, shape->outer};
    if (!pel_smooth_rows_begin(&ring->rows, surface, paint))
        return false;
    pel_smooth_circle_set(&ring->hole.circle, shape->inner);
    pel_smooth_disc_go(&ring->hole, &ring->rows.round, ring->rows.rows.x0);
    return true;
}

static bool is_legal(const struct pel_ring_shape *ring)
{
    return pel_point_legal(ring->center) && pel_radius_legal(ring->inner) &&
           pel_radius_legal(ring->outer);
}

void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *shape,
                     const struct pel_paint *paint)
{
    const bool legal = is_legal(shape);
    struct pel_smooth_ring_walk ring;
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&shape->center, 1, shape->outer));
    if (!legal || shape->outer <= shape->inner ||
        !pel_smooth_ring_begin(&ring, surface, shape, paint))
        return;
    while (pel_smooth_ring_next(&ring))
        pel_smooth_rows_paint(&ring.rows);
}
