#include "round_rows.h"

/* How far the upper end of row y is above the upper centres, and below the
 * lower ones. */
static inline int32_t above_of(const struct pel_smooth_round *round, int32_t y)
{
    return round->top - y * 256;
}

static inline int32_t below_of(const struct pel_smooth_round *round, int32_t y)
{
    return y * 256 - round->bottom;
}

/* Where the circle is at a distance from its axis; between the centres, if that
 * is not positive. */
static int32_t arc_at(const struct pel_smooth_disc *disc, int32_t distance)
{
    if (distance <= 0)
        return disc->circle.radius * 256;
    return pel_smooth_arc_at(&disc->circle, distance);
}

static int32_t arc_above(const struct pel_smooth_disc *disc,
                         const struct pel_smooth_round *round, int32_t y)
{
    return arc_at(disc, pel_max(above_of(round, y), below_of(round, y)));
}

void pel_smooth_disc_go(struct pel_smooth_disc *disc,
                        const struct pel_smooth_round *round, int32_t y)
{
    disc->at = arc_above(disc, round, y);
}

bool pel_smooth_disc_strip(struct pel_smooth_disc *disc,
                           const struct pel_smooth_round *round, int32_t y,
                           struct pel_smooth_strip *s)
{
    const int32_t above = above_of(round, y), below = below_of(round, y);
    const int32_t near = pel_max(pel_max(above - 256, below), 0);
    const bool straight = above <= 0 && below <= -256;
    if (!straight &&
        ((above < 256 && below < 0) || near + 256 > disc->circle.radius))
        return false;
    disc->next = arc_above(disc, round, y + 1);
    s->circle = &disc->circle;
    s->near = near * 256;
    s->far = s->near + 65536;
    s->at_near = above > 0 ? disc->next : disc->at;
    s->at_far = above > 0 ? disc->at : disc->next;
    return true;
}

void pel_smooth_disc_reach(const struct pel_smooth_disc *disc,
                           const struct pel_smooth_round *round, int32_t y,
                           struct pel_span reach[2])
{
    const int32_t above = above_of(round, y), below = below_of(round, y);
    struct pel_smooth_strip s;
    s.at_near = arc_at(disc, pel_max(above - 256, below));
    s.at_far = arc_at(disc, pel_max(above, below + 256));
    reach[0] = pel_smooth_crossed(&s, -round->left);
    reach[0] = (struct pel_span){-reach[0].x1, -reach[0].x0};
    reach[1] = pel_smooth_crossed(&s, round->right);
}

/* The areas of a strip, of what is between both of its sides. */
static PEL_NOINLINE_32 void add_strip(const struct pel_smooth_strip *s,
                                      const struct pel_smooth_round *round,
                                      const struct pel_span *columns,
                                      uint16_t *sum)
{
    uint16_t area[PEL_SMOOTH_PIXELS];
    const int32_t n = columns->x1 - columns->x0;
    const int32_t height = pel_smooth_height(s);
    pel_smooth_strip_areas(s, round->right, columns->x0, n, area);
    for (int32_t i = 0; i < n; i++)
        sum[i] = (uint16_t)(sum[i] + area[i] - height);
    pel_smooth_strip_areas(s, -round->left, -columns->x1, n, area);
    for (int32_t i = 0; i < n; i++)
        sum[i] = (uint16_t)(sum[i] + area[n - 1 - i]);
}

/* What row y has above the upper centres (0), between them and the lower ones
 * (1), and below: from one distance to another. */
static struct pel_span part_of(const struct pel_smooth_disc *disc,
                               const struct pel_smooth_round *round, int32_t y,
                               int part)
{
    const int32_t above = above_of(round, y), below = below_of(round, y);
    const int32_t radius = disc->circle.radius;
    if (part == 0)
        return (struct pel_span){pel_max(above - 256, 0),
                                 pel_min(above, radius)};
    if (part == 1)
        return (struct pel_span){pel_max(above, 0), pel_min(-below, 256)};
    return (struct pel_span){pel_max(below, 0), pel_min(below + 256, radius)};
}

void pel_smooth_disc_add(const struct pel_smooth_disc *disc,
                         const struct pel_smooth_round *round, int32_t y,
                         const struct pel_span *columns, uint16_t *sum)
{
    for (int part = 0; part < 3; part++) {
        const struct pel_span v = part_of(disc, round, y, part);
        struct pel_smooth_strip s;
        if (v.x0 >= v.x1)
            continue;
        s.circle = &disc->circle;
        s.near = v.x0 * 256;
        s.far = v.x1 * 256;
        s.at_near = arc_at(disc, part == 1 ? 0 : v.x0);
        s.at_far = arc_at(disc, part == 1 ? 0 : v.x1);
        pel_smooth_strip_set(&s);
        add_strip(&s, round, columns, sum);
    }
}

/* The bytes of the sides of a row; the left ones mirror the right ones, if
 * columns do. */
static PEL_ALWAYS_INLINE void put_sides(const struct pel_smooth_rows *rows,
                                        struct pel_smooth_strip *s,
                                        int32_t left, int32_t right,
                                        uint8_t *to)
{
    pel_smooth_strip_set(s);
    if (right > 0)
        pel_smooth_whole_side(s, rows->round.right, false, to + left, 1);
    if (left > 0 && !(rows->twin_columns && right > 0))
        pel_smooth_whole_side(s, -rows->round.left, false, to + left - 1, -1);
    else
        for (int32_t i = 0; i < left; i++)
            to[i] = to[2 * left - 1 - i];
}

/* Adds a row with this strip to the batch, if there is room behind `to`: where
 * its bytes end. */
static uint8_t *add_row(struct pel_smooth_rows *rows,
                        struct pel_smooth_strip *s, uint8_t *to)
{
    struct pel_smooth_batch *const b = &rows->batch;
    const struct pel_rect *const clip = &rows->smooth.target->clip;
    const struct pel_span r = pel_smooth_crossed(s, rows->round.right);
    const struct pel_span l = pel_smooth_crossed(s, -rows->round.left);
    int32_t left = l.x1 - l.x0, right = r.x1 - r.x0;
    if (!rows->inside) {
        left = pel_smooth_seen(&l, -clip->x1, -clip->x0);
        right = pel_smooth_seen(&r, clip->x0, clip->x1);
    }
    if (r.x0 + l.x0 < 0 ||
        left + right > b->coverage + PEL_SMOOTH_BATCH_BYTES - to)
        return NULL;
    if (left + right > 0)
        put_sides(rows, s, left, right, to);
    b->at.full[b->n] = (struct pel_span){-l.x0, r.x0};
    b->count[2 * b->n] = (uint8_t)left;
    b->count[2 * b->n + 1] = (uint8_t)right;
    b->n++;
    return to + left + right;
}

int32_t pel_smooth_rows_batch(struct pel_smooth_rows *rows, int32_t end)
{
    struct pel_smooth_batch *const b = &rows->batch;
    struct pel_smooth_strip s;
    uint8_t *to = b->coverage;
    b->y = rows->rows.x0;
    b->n = 0;
    while (
        b->n < PEL_SMOOTH_BATCH_ROWS && rows->rows.x0 < end &&
        pel_smooth_disc_strip(&rows->disc, &rows->round, rows->rows.x0, &s)) {
        to = add_row(rows, &s, to);
        if (!to)
            break;
        rows->disc.at = rows->disc.next;
        rows->rows.x0++;
    }
    if (!rows->inside)
        pel_smooth_clip_batch(b, &rows->smooth.target->clip);
    return b->n;
}

static void cover(const void *shape, int32_t x, int32_t n, uint8_t *to)
{
    const struct pel_smooth_rows *const rows = shape;
    const struct pel_span columns = {x, x + n};
    uint16_t sum[PEL_SMOOTH_PIXELS];
    for (int32_t i = 0; i < n; i++)
        sum[i] = 0;
    pel_smooth_disc_add(&rows->disc, &rows->round, rows->rows.x0 - 1, &columns,
                        sum);
    for (int32_t i = 0; i < n; i++)
        to[i] = pel_smooth_coverage(sum[i]);
}

void pel_smooth_rows_pass(struct pel_smooth_rows *rows)
{
    const struct pel_rect *const clip = &rows->smooth.target->clip;
    struct pel_span reach[2];
    pel_smooth_disc_reach(&rows->disc, &rows->round, rows->rows.x0++, reach);
    rows->rest.x0 = pel_max(reach[0].x0, clip->x0);
    rows->rest.x1 = pel_min(reach[1].x1, clip->x1);
    pel_smooth_disc_go(&rows->disc, &rows->round, rows->rows.x0);
}

void pel_smooth_rows_rest(struct pel_smooth_rows *rows,
                          struct pel_smooth_columns *columns)
{
    rows->batch.y = rows->rows.x0 - 1;
    rows->batch.n = 0;
    if (rows->rest.x0 < rows->rest.x1)
        pel_smooth_cover(columns, &rows->batch);
    rows->rest = columns->left;
}

/* Of the columns between the sides. */
static int32_t even_of(const struct pel_smooth_rows *rows, int32_t y)
{
    int32_t height = 0;
    for (int part = 0; part < 3; part++) {
        const struct pel_span v = part_of(&rows->disc, &rows->round, y, part);
        height += pel_max(v.x1 - v.x0, 0);
    }
    return pel_smooth_coverage((uint32_t)height << 7);
}

static void rest_of_row(struct pel_smooth_rows *rows)
{
    struct pel_span crossed[2];
    struct pel_smooth_columns c = {
        rows->rest, crossed, 2, cover, rows, even_of(rows, rows->rows.x0 - 1)};
    pel_smooth_disc_reach(&rows->disc, &rows->round, rows->rows.x0 - 1,
                          crossed);
    pel_smooth_rows_rest(rows, &c);
}

/* The next batch; false at the end. */
static PEL_NOINLINE_32 bool next_batch(struct pel_smooth_rows *rows)
{
    if (rows->rest.x0 >= rows->rest.x1) {
        if (rows->rows.x0 >= rows->rows.x1)
            return false;
        if (!PEL_SMALL_CODE && pel_smooth_rows_batch(rows, rows->rows.x1) > 0)
            return true;
        pel_smooth_rows_pass(rows);
    }
    rest_of_row(rows);
    return true;
}

void pel_smooth_rows_paint(struct pel_smooth_rows *rows)
{
    struct pel_smooth_batch *const b = &rows->batch;
    const int32_t n = b->n;
    pel_smooth_paint_batch(&rows->smooth, b);
    b->n -= pel_smooth_is_own_image(rows);
    if (!PEL_SMALL_CODE && rows->twins)
        pel_smooth_paint_upwards(&rows->smooth, b, rows->image_y - b->y);
    b->n = n;
}

/* Is some of the round in the clip; all of it, left and right? */
static bool is_beside(const struct pel_smooth_round *round,
                      const struct pel_rect *clip)
{
    return clip->x0 >= clip->x1 ||
           pel_pixel_of(round->right + round->radius) < clip->x0 ||
           pel_pixel_of(round->left - round->radius) >= clip->x1;
}

/* With the column on the left that a shape just touches: as image of one on the
 * right it is a pixel of coverage 0, which is read and stored. */
static bool is_inside(const struct pel_smooth_round *round,
                      const struct pel_rect *clip)
{
    return pel_pixel_of(round->left - round->radius - 1) >= clip->x0 &&
           pel_pixel_of(round->right + round->radius) < clip->x1;
}

/* The rows that are to be seen, or half of them and their images. */
static void find_rows(struct pel_smooth_rows *rows, const struct pel_rect *clip)
{
    const struct pel_smooth_round *const round = &rows->round;
    const int32_t top = pel_pixel_of(round->top - round->radius);
    const int32_t bottom = pel_pixel_of(round->bottom + round->radius + 255);
    const int32_t sum = round->top + round->bottom;
    struct pel_span *const seen = &rows->rows;
    seen->x0 = pel_max(top, clip->y0);
    seen->x1 = pel_min(bottom, clip->y1);
    rows->image_y = pel_pixel_of(sum) - 1;
    rows->twins = !PEL_SMALL_CODE && (sum & 255) == 0 && seen->x0 == top &&
                  seen->x1 == bottom;
    if (rows->twins)
        seen->x1 = (rows->image_y >> 1) + 1;
}

bool pel_smooth_rows_begin(struct pel_smooth_rows *rows,
                           const struct pel_surface *surface,
                           const struct pel_paint *paint)
{
    const struct pel_smooth_round *const round = &rows->round;
    find_rows(rows, &surface->clip);
    rows->inside = is_inside(round, &surface->clip);
    rows->twin_columns = ((round->left + round->right) & 255) == 0;
    rows->rest = (struct pel_span){0, 0};
    if (rows->rows.x0 >= rows->rows.x1 || is_beside(round, &surface->clip) ||
        !pel_smooth_begin(&rows->smooth, surface, paint))
        return false;
    pel_smooth_circle_set(&rows->disc.circle, round->radius);
    pel_smooth_disc_go(&rows->disc, round, rows->rows.x0);
    return true;
}

void pel_smooth_rows_all(struct pel_smooth_rows *rows)
{
    while (next_batch(rows))
        pel_smooth_rows_paint(rows);
}
