#include "ramp_walk.h"

#include "../format/vector.h"

/* The cell of a position given in 2^-32 of the way, of `cells` < 2^15: both
 * forms are floor(at cells / 2^32). */
static inline uint32_t cell_of(uint32_t at, uint32_t cells)
{
#if PEL_LONG_MULTIPLY
    return (uint32_t)((uint64_t)at * cells >> 32);
#else
    return ((at >> 16) * cells + ((at & 0xFFFFu) * cells >> 16)) >> 16;
#endif
}

/* Where a loop looks cells up: in a table of colours, or not at all. `use` is a
 * constant wherever this is inlined. */
struct table {
    const pel_color *color;
    uint32_t cells;
    bool use;
};

static PEL_ALWAYS_INLINE pel_color shown(struct table t, uint32_t at)
{
    uint32_t cell = cell_of(at, t.cells);
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

static PEL_ALWAYS_INLINE void padded(const struct pel_ramp_walk *w,
                                     struct table table, int32_t n,
                                     pel_color *out)
{
    uint64_t at = w->at, d1 = w->d1, d2 = w->d2;
    const uint64_t d3 = w->d3;
    const int bits = w->bits;
    for (; n > 0; n--, at += d1, d1 += d2, d2 += d3) {
        uint32_t high = (uint32_t)(at >> (bits - 32));
        if (at >> bits)
            high = at >> 63 ? 0 : UINT32_MAX;
        *out++ = shown(table, high);
    }
}

static PEL_ALWAYS_INLINE void walk_of(enum pel_spread spread,
                                      const struct pel_ramp_walk *w,
                                      struct table table, int32_t n,
                                      pel_color *out)
{
    if (spread == PEL_REFLECT)
        reflected(w, table, n, out);
    else if (spread == PEL_REPEAT || w->inside)
        repeated(w, table, n, out);
    else
        padded(w, table, n, out);
}

/* Two channels of a ramp of two colours, in the halves of a word: 255 a and
 * b - a. 255 a + (b - a) cell is between 0 and 255^2 in each half, so nothing
 * is left over between them, though b - a may be negative. */
struct pair {
    uint32_t from, way;
};

static struct pair pair_of(uint32_t a, uint32_t b)
{
    a &= 0xFF00FFu;
    b &= 0xFF00FFu;
    return (struct pair){a * 255, b - a};
}

/* pel_round_div255 of both halves. */
static uint32_t pair_at(struct pair p, uint32_t cell)
{
    uint32_t t = p.from + p.way * cell + UINT32_C(0x800080);
    return (t + (t >> 8 & 0xFF00FFu)) >> 8 & 0xFF00FFu;
}

static void mix_plainly(const struct pel_ramp *ramp, int32_t n, pel_color *out)
{
    const pel_color a = ramp->colors[0], b = ramp->colors[1];
    const struct pair rb = pair_of(a, b), ag = pair_of(a >> 8, b >> 8);
    for (; n > 0; n--, out++)
        *out = pair_at(rb, *out) | pair_at(ag, *out) << 8;
}

#if PEL_VECTORS

typedef uint64_t u64x2 __attribute__((__vector_size__(16)));
typedef uint8_t u8x8 __attribute__((__vector_size__(8)));

/* The four channels of a colour, from blue to alpha, twice. */
static pel_u16x8 channels_of(pel_color c)
{
    const uint16_t b = c & 255, g = c >> 8 & 255, r = c >> 16 & 255;
    const uint16_t a = (uint16_t)(c >> 24);
    return (pel_u16x8){b, g, r, a, b, g, r, a};
}

/* A ramp of two colours, in 256 cells: two pixels at a time, as pair_at. */
static void mix_cells(const struct pel_ramp *ramp, int32_t n, pel_color *out)
{
    const pel_u16x8 a = channels_of(ramp->colors[0]);
    const pel_u16x8 way = channels_of(ramp->colors[1]) - a;
    const pel_u16x8 from = a * 255 + 128;
    for (; n >= 2; n -= 2, out += 2) {
        const u64x2 cells = {out[0] * UINT64_C(0x0001000100010001),
                             out[1] * UINT64_C(0x0001000100010001)};
        const pel_u16x8 t = pel_divide255_u16x8(from + way * (pel_u16x8)cells);
        const u8x8 mixed = __builtin_convertvector(t, u8x8);
        memcpy(out, &mixed, 8);
    }
    mix_plainly(ramp, n, out);
}

#else

static void mix_cells(const struct pel_ramp *ramp, int32_t n, pel_color *out)
{
    mix_plainly(ramp, n, out);
}

#endif

#if PEL_FAST_64BIT
enum { LOOK_UP_AT_ONCE = 1 };
#else
enum { LOOK_UP_AT_ONCE = 0 }; /* half the code */
#endif

void pel_ramp_run(const struct pel_ramp *ramp, const struct pel_ramp_walk *walk,
                  int32_t n, pel_color *colors)
{
    const bool mixed = ramp->n == 2;
    struct table table = {ramp->colors, mixed ? 256 : (uint32_t)ramp->n, true};
    if (LOOK_UP_AT_ONCE && !mixed) {
        walk_of(ramp->spread, walk, table, n, colors);
        return;
    }
    table.use = false;
    walk_of(ramp->spread, walk, table, n, colors);
    if (mixed)
        mix_cells(ramp, n, colors);
    else
        for (int32_t i = 0; i < n; i++)
            colors[i] = ramp->colors[colors[i]];
}
