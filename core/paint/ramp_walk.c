#include "ramp_walk.h"

#include "../format/span32.h"
#include "../format/vector.h"
#include "ramp_mix.h"

#if PEL_FAST_64BIT

/* Where a loop looks cells up: in a table of colours, or not at all. `use` is a
 * constant wherever this is inlined. */
struct table {
    const pel_color *color;
    uint32_t cells;
    bool use;
};

static PEL_ALWAYS_INLINE pel_color shown(struct table t, uint32_t at)
{
    uint32_t cell = pel_ramp_cell(at, t.cells);
    return t.use ? t.color[cell] : cell;
}

static PEL_ALWAYS_INLINE void repeated(const struct pel_ramp_walk *w,
                                       struct table table, int32_t n,
                                       pel_color *out)
{
    const int shift = 64 - w->bits;
    uint64_t at = w->at << shift, d1 = w->d1 << shift, d2 = w->d2 << shift;
    const uint64_t d3 = w->d3 << shift;
    for (; n > 0; n--, at += d1, d1 += d2, d2 += d3)
        *out++ = shown(table, (uint32_t)(at >> 32));
}

/* The highest bit tells which way: a full turn of the word is there and back.
 */
static PEL_ALWAYS_INLINE void reflected(const struct pel_ramp_walk *w,
                                        struct table table, int32_t n,
                                        pel_color *out)
{
    const int shift = 63 - w->bits;
    uint64_t at = w->at << shift, d1 = w->d1 << shift, d2 = w->d2 << shift;
    const uint64_t d3 = w->d3 << shift;
    for (; n > 0; n--, at += d1, d1 += d2, d2 += d3) {
        uint32_t high = (uint32_t)(at >> 32), back = 0 - (high >> 31);
        *out++ = shown(table, (high ^ back) << 1);
    }
}

static PEL_ALWAYS_INLINE void walk_of(enum pel_spread spread,
                                      const struct pel_ramp_walk *w,
                                      struct table table, int32_t n,
                                      pel_color *out)
{
    if (spread == PEL_REFLECT)
        reflected(w, table, n, out);
    else
        repeated(w, table, n, out);
}

static void mix_cells(const struct pel_ramp *ramp, int32_t n, pel_color *out)
{
    const pel_color a = ramp->colors[0], b = ramp->colors[1];
    const struct pel_pair rb = pel_pair_of(a, b),
                          ag = pel_pair_of(a >> 8, b >> 8);
    for (; n > 0; n--, out++)
        *out = pel_pair_at(rb, *out) | pel_pair_at(ag, *out) << 8;
}

#if PEL_VECTORS

typedef uint64_t u64x2 __attribute__((__vector_size__(16)));

/* A walk four pixels at a time: pixels 0 and 2, and 1 and 3, with differences
 * from one four to the next. */
struct lanes {
    u64x2 at[2], d1[2], d2[2], d3;
};

/* A difference over four pixels is (1 + D)^4 - 1 with D that over one: 4 D + 6
 * D^2 + 4 D^3; twice 16 D^2 + 48 D^3; three times 64 D^3. */
static PEL_ALWAYS_INLINE void set_lanes(struct lanes *l, int i,
                                        const struct pel_ramp_walk *a,
                                        const struct pel_ramp_walk *b)
{
    const u64x2 d1 = {a->d1, b->d1}, d2 = {a->d2, b->d2}, d3 = {a->d3, a->d3};
    l->at[i] = (u64x2){a->at, b->at};
    l->d1[i] = ((d1 + d2 + d3) << 2) + (d2 << 1);
    l->d2[i] = (d2 << 4) + (d3 << 5) + (d3 << 4);
    l->d3 = d3 << 6;
}

static PEL_ALWAYS_INLINE struct pel_ramp_walk after(struct pel_ramp_walk w)
{
    pel_ramp_step(&w);
    return w;
}

static PEL_ALWAYS_INLINE struct lanes lanes_of(struct pel_ramp_walk w,
                                               int shift)
{
    struct lanes l;
    w.at <<= shift, w.d1 <<= shift, w.d2 <<= shift, w.d3 <<= shift;
    const struct pel_ramp_walk second = after(w), third = after(second),
                               fourth = after(third);
    set_lanes(&l, 0, &w, &third);
    set_lanes(&l, 1, &second, &fourth);
    return l;
}

/* The highest bytes of the four positions, in 32-bit lanes; then a step. */
static PEL_ALWAYS_INLINE pel_u32x4 next_bytes(struct lanes *l)
{
    const u64x2 bytes = l->at[0] >> 56 | l->at[1] >> 56 << 32;
    for (int i = 0; i < 2; i++) {
        l->at[i] += l->d1[i];
        l->d1[i] += l->d2[i];
        l->d2[i] += l->d3;
    }
    return (pel_u32x4)bytes;
}

/* struct pel_pair for four pixels, each half in a lane of its own. */
struct pairs {
    pel_u16x8 from, way;
};

static PEL_ALWAYS_INLINE struct pairs pairs_of(pel_color a, pel_color b)
{
    const pel_u32x4 zero = {0, 0, 0, 0};
    const pel_u16x8 from = (pel_u16x8)(zero + (a & 0xFF00FFu));
    const pel_u16x8 to = (pel_u16x8)(zero + (b & 0xFF00FFu));
    return (struct pairs){from * 255 + 128, to - from};
}

/* `cells` twice in each 32-bit lane. */
static PEL_ALWAYS_INLINE pel_u16x8 pairs_at(const struct pairs *p,
                                            pel_u16x8 cells)
{
    return pel_divide255_u16x8(p->from + p->way * cells);
}

/* The next four pixels of a ramp of two colours. */
static PEL_ALWAYS_INLINE pel_u16x8 next_colors(struct lanes *l,
                                               const struct pairs *rb,
                                               const struct pairs *ag)
{
    const pel_u32x4 bytes = next_bytes(l);
    const pel_u16x8 cells = (pel_u16x8)(bytes | bytes << 16);
    return pairs_at(rb, cells) | pairs_at(ag, cells) << 8;
}

/* A ramp of two colours where `repeated` would do. */
static void mix_on_the_way(const struct pel_ramp *ramp,
                           const struct pel_ramp_walk *w, int32_t n,
                           pel_color *out)
{
    const pel_color a = ramp->colors[0], b = ramp->colors[1];
    const struct pairs rb = pairs_of(a, b), ag = pairs_of(a >> 8, b >> 8);
    struct lanes l = lanes_of(*w, 64 - w->bits);
    for (; n >= 4; n -= 4, out += 4)
        pel_put_u16x8(out, next_colors(&l, &rb, &ag));
    if (n > 0) {
        const pel_u32x4 last = (pel_u32x4)next_colors(&l, &rb, &ag);
        for (int32_t i = 0; i < n; i++)
            out[i] = last[i];
    }
}

#else

static void mix_on_the_way(const struct pel_ramp *ramp,
                           const struct pel_ramp_walk *w, int32_t n,
                           pel_color *out)
{
    repeated(w, (struct table){NULL, 256, false}, n, out);
    mix_cells(ramp, n, out);
}

#endif

static void fill(pel_color color, int32_t n, pel_color *out)
{
#if PEL_VECTORS
    pel_span32(out, n, pel_make_value32(color));
#else
    for (; n > 0; n--)
        *out++ = color;
#endif
}

/* A walk that is `inside`, or whose ramp is not padded. */
static void run_inside(const struct pel_ramp *ramp,
                       const struct pel_ramp_walk *walk, int32_t n,
                       pel_color *colors)
{
    const bool mixed = ramp->n == 2;
    const struct table table = {ramp->colors, mixed ? 256 : (uint32_t)ramp->n,
                                !mixed};
    if (mixed && ramp->spread != PEL_REFLECT) {
        mix_on_the_way(ramp, walk, n, colors);
        return;
    }
    walk_of(ramp->spread, walk, table, n, colors);
    if (mixed)
        mix_cells(ramp, n, colors);
}

/* The positions on one side of the way: `size` from `low` on. A padded walk has
 * fewer than 64 bits. */
struct side {
    uint64_t low, size;
};

static struct side side_of(uint64_t at, int bits)
{
    const uint64_t one = UINT64_C(1) << bits, most = UINT64_C(1) << 63;
    if (at < one)
        return (struct side){0, one};
    return at < most ? (struct side){one, most - one}
                     : (struct side){most, most};
}

/* Part by part, each on one side. */
static void run_padded(const struct pel_ramp *ramp, struct pel_ramp_walk w,
                       int32_t n, pel_color *colors)
{
    for (int32_t part; n > 0; n -= part, colors += part) {
        const struct pel_ramp_walk first = w;
        const struct side side = side_of(w.at, w.bits);
        for (part = 0; part < n && w.at - side.low < side.size; part++)
            pel_ramp_step(&w);
        if (side.low == 0)
            run_inside(ramp, &first, part, colors);
        else
            fill(ramp->colors[first.at >> 63 ? 0 : ramp->n - 1], part, colors);
    }
}

void pel_ramp_run(const struct pel_ramp *ramp, struct pel_ramp_walk *walk,
                  int32_t n, pel_color *colors)
{
    const bool changes = (walk->d1 | walk->d2 | walk->d3) != 0;
    const int32_t some = changes ? n : 1;
    if (ramp->spread == PEL_PAD && !walk->inside)
        run_padded(ramp, *walk, some, colors);
    else
        run_inside(ramp, walk, some, colors);
    if (some < n)
        fill(colors[0], n - some, colors + some);
}

#endif
