#include "path.h"

#include <string.h>

bool pel_smooth_path_begin(struct pel_smooth_path *path,
                           const struct pel_surface *surface,
                           const struct pel_paint *paint)
{
    path->row = (struct pel_smooth_row){0, 0, 0, 0, 0, path->coverage};
    path->bows = path->lines = 0;
    return pel_smooth_begin(&path->smooth, surface, paint);
}

/* Paints what waits. */
static void flush(struct pel_smooth_path *path)
{
    struct pel_smooth_row *const row = &path->row;
    if (row->left || row->full)
        pel_smooth_paint(&path->smooth, row);
    row->left = row->full = row->right = 0;
}

/* Where the coverage of a window from x on goes. */
static uint8_t *room(struct pel_smooth_path *path, int32_t x)
{
    struct pel_smooth_row *const row = &path->row;
    if (row->right || !row->full)
        flush(path);
    if (!row->full)
        row->x = x;
    return path->coverage + row->left;
}

/* k pixels have their coverage. */
static void take(struct pel_smooth_path *path, int32_t k)
{
    if (path->row.full)
        path->row.right = k;
    else
        path->row.left = k;
}

/* Where ends meet a sum may be more than a pixel. */
static uint8_t coverage_of(int32_t sum)
{
    return pel_smooth_coverage((uint32_t)pel_min(sum, 32768));
}

/* n >= 1 pixels of one sum. */
static void add_run(struct pel_smooth_path *path, int32_t x, int32_t n,
                    int32_t sum)
{
    struct pel_smooth_row *const row = &path->row;
    const uint8_t coverage = coverage_of(sum);
    if (row->full || coverage == 0)
        flush(path);
    if (coverage == 255) {
        if (!row->left)
            row->x = x;
        row->full = n;
        return;
    }
    for (int32_t k; coverage && n > 0; n -= k, x += k) {
        k = pel_min(n, PEL_SMOOTH_WINDOW);
        memset(room(path, x), coverage, (size_t)k);
        take(path, k);
    }
}

/* The columns of a piece, and what lies right of it in those beyond; its
 * number. */
struct crossed {
    int32_t first, last;
    int32_t growth, id;
};

/* What is right of a side in all columns beyond it. */
static int32_t growth_of(const struct pel_smooth_piece_side *side)
{
    const int32_t h = pel_smooth_height(&side->strip);
    return side->rising ? h : -h;
}

/* Adds to n columns from x on, of which the side crosses some. */
static PEL_NOINLINE void add_side(const struct pel_smooth_piece_side *side,
                                  int32_t x, int32_t n, int32_t *sum)
{
    uint16_t area[PEL_SMOOTH_WINDOW];
    const int32_t h = pel_smooth_height(&side->strip);
    const bool left = side->left;
    (side->strip.circle ? pel_smooth_strip_areas : pel_smooth_line_areas)(
        &side->strip, side->center, left ? -x - n : x, n, area);
    for (int32_t i = 0; i < n; i++) {
        const int32_t right = left ? area[n - 1 - i] : h - area[i];
        sum[i] += side->rising ? right : -right;
    }
}

/* The pieces that cross pixels without a gap. */
struct group {
    const struct crossed *piece;
    int32_t n, last; /* how many; the last of these pixels */
};

/* The coverage of k columns from x on, of which pixels before them have a sum.
 */
static PEL_NOINLINE void cross(struct pel_smooth_path *path,
                               const struct group *g, int32_t x, int32_t k,
                               int32_t sum)
{
    int32_t sums[PEL_SMOOTH_WINDOW];
    uint8_t *const to = room(path, x);
    for (int32_t i = 0; i < k; i++)
        sums[i] = sum;
    for (int32_t i = 0; i < g->n; i++) {
        struct pel_smooth_piece_side side;
        pel_smooth_path_piece(path, path->row.y, g->piece[i].id, &side);
        if (side.strip.circle)
            pel_smooth_strip_set(&side.strip);
        add_side(&side, x, k, sums);
    }
    for (int32_t i = 0; i < k; i++)
        to[i] = coverage_of(sums[i]);
    take(path, k);
}

static struct crossed columns_of(const struct pel_smooth_piece_side *side,
                                 int32_t id)
{
    const int32_t shift = side->strip.circle ? 8 : 5;
    const int32_t a = (side->center + (side->strip.at_far >> shift)) >> 8;
    const int32_t b = (side->center + (side->strip.at_near >> shift)) >> 8;
    return (struct crossed){side->left ? -1 - b : a, side->left ? -1 - a : b,
                            growth_of(side), id};
}

/* The pieces of the row, by their first columns: how many there are. */
static PEL_NOINLINE int32_t find_pieces(const struct pel_smooth_path *path,
                                        struct crossed *piece)
{
    int32_t n = 0, id = -1;
    while ((id = pel_smooth_path_next(path, path->row.y, id)) >= 0) {
        struct pel_smooth_piece_side side;
        if (!pel_smooth_path_piece(path, path->row.y, id, &side))
            continue;
        const struct crossed one = columns_of(&side, id);
        int32_t k = n++;
        for (; k > 0 && piece[k - 1].first > one.first; k--)
            piece[k] = piece[k - 1];
        piece[k] = one;
    }
    return n;
}

static struct group group_of(const struct crossed *piece, int32_t n)
{
    struct group g = {piece, 1, piece->last};
    for (; g.n < n && piece[g.n].first <= g.last; g.n++)
        g.last = pel_max(g.last, piece[g.n].last);
    return g;
}

static int32_t group_growth(const struct group *g)
{
    int32_t sum = 0;
    for (int32_t i = 0; i < g->n; i++)
        sum += g->piece[i].growth;
    return sum;
}

/* From x on; where the next pixel is. */
static int32_t paint_group(struct pel_smooth_path *path, const struct group *g,
                           int32_t x, int32_t sum)
{
    const int32_t end = path->smooth.surface.clip.x1;
    const int32_t first = pel_min(g->piece->first, end);
    if (first > x)
        add_run(path, x, first - x, sum);
    x = pel_max(first, x);
    for (int32_t k; x <= g->last && x < end; x += k) {
        k = pel_min(pel_min(g->last + 1, end) - x, PEL_SMOOTH_WINDOW);
        cross(path, g, x, k, sum);
    }
    return x;
}

static void paint_row(struct pel_smooth_path *path)
{
    struct crossed piece[PEL_SMOOTH_SIDES];
    const int32_t n = find_pieces(path, piece);
    int32_t x = path->smooth.surface.clip.x0, sum = 0;
    for (int32_t i = 0; i < n;) {
        const struct group g = group_of(piece + i, n - i);
        x = paint_group(path, &g, x, sum);
        sum += group_growth(&g);
        i += g.n;
    }
    flush(path);
}

void pel_smooth_path_paint(struct pel_smooth_path *path,
                           const struct pel_rect *box)
{
    const struct pel_rect seen =
        pel_rect_intersect(box, &path->smooth.surface.clip);
    if (pel_rect_empty(&seen))
        return;
    pel_smooth_path_start(path, seen.y0);
    for (path->row.y = seen.y0; path->row.y < seen.y1; path->row.y++) {
        pel_smooth_path_row(path, path->row.y);
        paint_row(path);
    }
}
