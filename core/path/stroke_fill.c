/* The pixels of a stroke: one bit for each, set by piece after piece. Pieces
 * are convex, so a piece has one border on the left and one on the right of a
 * row, and what is inside of several is set once. */
#include <string.h>

#include "../base/divide.h"
#include "../raster/collect.h"
#include "../raster/edge.h"
#include "stroker.h"

/* The borders of a piece in a row, as distances: of the left one from the
 * clip's right side, of the right one from its left side. Both are 0 without a
 * piece. */
struct border {
    int32_t left, right;
};

enum { BORDER = sizeof(struct border) / sizeof(uint32_t) };

struct bits {
    struct pel_sides sides;
    int32_t x0, x1; /* columns */
    uint32_t *rows;
    int32_t words;       /* of a row: two are the piece's borders */
    int32_t most;        /* rows at a time */
    int32_t first, end;  /* rows of the piece */
    int32_t top, bottom; /* rows of all pieces */
    struct pel_point from;
    struct pel_edge edge;
};

PEL_STATIC_ASSERT(pel_bits_fit, sizeof(struct bits) <= PEL_TAKER_SIZE);

/* The borders of row y, and behind them its bits. */
static inline uint32_t *row_at(const struct bits *b, int32_t y)
{
    return b->rows + (y - b->sides.y0) * b->words;
}

/* Empties rows that no piece has touched before. Small programs do not link
 * memset for it. */
static PEL_NOINLINE void take_rows(struct bits *b, int32_t first, int32_t end)
{
    if (b->top > b->bottom)
        b->top = b->bottom = first;
    while (b->top > first || b->bottom < end) {
        const int32_t y = b->top > first ? --b->top : b->bottom++;
        uint32_t *const row = row_at(b, y);
        if (PEL_64BIT)
            memset(row, 0, (size_t)b->words * 4);
        for (int32_t i = 0; !PEL_64BIT && i < b->words; i++)
            row[i] = 0;
    }
}

/* Sides that go down are on the right. */
static void take_side(struct bits *b, const struct pel_point *from,
                      const struct pel_point *to)
{
    const bool down = from->y < to->y;
    const struct pel_point *const top = down ? from : to;
    const struct pel_point *const bottom = down ? to : from;
    const int32_t first = pel_max(pel_first_pixel(top->y), b->sides.y0);
    const int32_t end = pel_min(pel_first_pixel(bottom->y), b->sides.y1);
    struct pel_edge *const edge = &b->edge;
    if (first >= end)
        return;
    uint32_t *row = row_at(b, first);
    if (first < b->top || end > b->bottom)
        take_rows(b, first, end);
    b->first = pel_min(b->first, first);
    b->end = pel_max(b->end, end);
    pel_edge_start(edge, top, bottom, first);
    for (int32_t n = end - first; n > 0; n--, row += b->words) {
        struct border *const border = (struct border *)row;
        if (down)
            border->right = pel_max(border->right, edge->x - b->x0);
        else
            border->left = pel_max(border->left, b->x1 - edge->x);
        pel_edge_next(edge);
    }
}

static void add(struct pel_sides *sides, int32_t x, int32_t y)
{
    struct bits *const b = (struct bits *)(void *)sides;
    b->from = sides->at;
    sides->at = (struct pel_point){x, y};
    if (pel_first_pixel(b->from.y) != pel_first_pixel(y))
        take_side(b, &b->from, &sides->at);
}

/* Those from x0 to x1 - 1, of which there is one at least. */
static void set_bits(uint32_t *row, int32_t x0, int32_t x1)
{
    const uint32_t last = UINT32_MAX >> (31 - ((x1 - 1) & 31));
    uint32_t mask = UINT32_MAX << (x0 & 31);
    uint32_t *const end = row + ((uint32_t)(x1 - 1) >> 5);
    for (row += (uint32_t)x0 >> 5; row < end; row++) {
        *row |= mask;
        mask = UINT32_MAX;
    }
    *row |= mask & last;
}

/* What the piece covers of a row, whose borders are forgotten. */
static void set_row(const struct bits *b, uint32_t *row)
{
    struct border *const border = (struct border *)row;
    const int32_t width = b->x1 - b->x0;
    const int32_t x0 = pel_max(width - border->left, 0);
    const int32_t x1 = pel_min(border->right, width);
    if (x0 < x1)
        set_bits(row + BORDER, x0, x1);
    border->left = border->right = 0;
}

static PEL_NOINLINE_32 void set_rows(struct bits *b)
{
    for (int32_t y = b->first; y < b->end; y++)
        set_row(b, row_at(b, y));
    b->first = INT32_MAX;
    b->end = INT32_MIN;
}

static void end_piece(struct pel_sides *sides)
{
    add(sides, sides->start.x, sides->start.y);
    sides->in_piece = false;
    set_rows((struct bits *)(void *)sides);
}

static const struct pel_sides_kind bits_kind = {.add = add, .end = end_piece};

/* Begins above the clip; next_rows goes on, by `most` rows at a time. */
static struct bits *begin(void *memory, const struct pel_rect *clip,
                          int32_t most)
{
    struct bits *const b = memory;
    b->sides.kind = &bits_kind;
    b->sides.memory = (char *)b + PEL_TAKER_SIZE;
    b->sides.in_piece = false;
    b->sides.y1 = clip->y0;
    b->x0 = clip->x0;
    b->x1 = clip->x1;
    b->words = BORDER + ((b->x1 - b->x0 + 31) >> 5);
    b->rows = (uint32_t *)(void *)((char *)b + PEL_STROKE_SCRATCH_SIZE(0, 0));
    b->most = most;
    b->first = INT32_MAX;
    b->end = INT32_MIN;
    return b;
}

/* Goes on to the rows below; false: there are none in the clip. */
static PEL_NOINLINE bool next_rows(struct bits *b, const struct pel_rect *clip)
{
    if (clip->x0 >= clip->x1 || b->sides.y1 >= clip->y1)
        return false;
    const int32_t y = b->sides.y1, n = pel_min(b->most, clip->y1 - y);
    pel_sides_set_rows(&b->sides, y, y + n);
    b->top = y + n;
    b->bottom = y;
    return true;
}

/* The first place from `from` on, up to `end`, whose bit is not `set`. */
static int32_t next_change(const uint32_t *row, int32_t from, int32_t end,
                           uint32_t set)
{
    while (from < end) {
        uint32_t word = (row[(uint32_t)from >> 5] ^ set) >> (from & 31);
        if (word == 0) {
            from = (from | 31) + 1;
            continue;
        }
        for (; !(word & 255); word >>= 8)
            from += 8;
        return from + pel_trailing_zeros(word);
    }
    return end;
}

static PEL_NOINLINE void paint_rows(const struct bits *b,
                                    const struct pel_surface *surface,
                                    const struct pel_paint *paint)
{
    const int32_t left = b->x0, width = b->x1 - left;
    const uint32_t *row = row_at(b, b->top) + BORDER;
    struct pel_collector c;
    pel_collect_begin(&c, surface, paint);
    for (int32_t y = b->top; y < b->bottom; y++, row += b->words)
        for (int32_t x = next_change(row, 0, width, 0); x < width;) {
            const int32_t end = next_change(row, x, width, UINT32_MAX);
            pel_collect(&c, y, x + left, end + left);
            x = next_change(row, end, width, 0);
        }
    pel_collect_end(&c);
}

/* How many rows of the clip the memory has room for, or 1 GB of it. */
static int32_t rows_in(const struct pel_scratch *scratch,
                       const struct pel_rect *clip)
{
    const size_t head = PEL_STROKE_SCRATCH_SIZE(0, 0);
    const uint32_t row =
        (uint32_t)(PEL_STROKE_SCRATCH_SIZE(clip->x1 - clip->x0, 1) - head);
    if ((uintptr_t)scratch->memory % 8 || scratch->size < head)
        return 0;
    const size_t size = scratch->size - head;
    return (int32_t)pel_divide(size >> 30 ? 1 << 30 : size, row);
}

static PEL_NOINLINE enum pel_status begin_fill(
    const struct pel_surface *surface, const struct pel_paint *paint,
    const struct pel_scratch *scratch)
{
    if (!surface || !paint || !scratch->memory)
        return PEL_ERROR_NULL;
    const struct pel_rect *const clip = &surface->clip;
    if (clip->x0 >= clip->x1)
        return PEL_OK;
    const int32_t most = rows_in(scratch, clip);
    if (most < 1)
        return PEL_ERROR_SCRATCH;
    begin(scratch->memory, clip, most);
    return PEL_OK;
}

enum pel_status pel_stroke_fill(const struct pel_surface *surface,
                                const struct pel_lines *lines,
                                const struct pel_paint *paint,
                                const struct pel_scratch *scratch)
{
    struct bits *const b = scratch->memory;
    enum pel_status status = begin_fill(surface, paint, scratch);
    while (status == PEL_OK && next_rows(b, &surface->clip)) {
        status = pel_stroke_walk(lines, &b->sides);
        if (status == PEL_OK)
            paint_rows(b, surface, paint);
    }
    return status;
}

bool pel_stroke_hit(const struct pel_lines *lines, int32_t x, int32_t y)
{
    uint64_t memory[PEL_STROKE_SCRATCH_SIZE(1, 1) / 8 + 1];
    if (!pel_pixel_legal(x, y))
        return false;
    const struct pel_rect pixel = {x, y, x + 1, y + 1};
    struct bits *const b = begin(memory, &pixel, 1);
    return next_rows(b, &pixel) &&
           pel_stroke_walk(lines, &b->sides) == PEL_OK && b->top < b->bottom &&
           b->rows[BORDER];
}
