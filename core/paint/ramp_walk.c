#include "ramp_walk.h"

#include "../format/span32.h"
#include "ramp_mix.h"
#include "ramp_vector.h"

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

static void fill(pel_color color, int32_t n, pel_color *out)
{
#if PEL_VECTORS
    pel_span32(out, n, pel_make_value32(color));
#else
    for (; n > 0; n--)
        *out++ = color;
#endif
}

static void run_parts(const struct pel_ramp_mixer *mixer,
                      struct pel_ramp_walk w, pel_color *colors)
{
    for (int32_t n = w.n; n > 0; n -= w.n) {
        w.n = pel_min(n, PEL_RAMP_PART);
        mixer->run(mixer, &w, colors);
        colors += w.n;
        w = pel_ramp_after(w, w.n);
    }
}

/* A walk that is `inside`, or whose ramp is not padded. */
static void run_inside(const struct pel_ramp_mixer *mixer,
                       const struct pel_ramp_walk *walk, pel_color *colors)
{
    const struct pel_ramp *const ramp = mixer->ramp;
    const bool mixed = ramp->n == 2;
    const struct table table = {ramp->colors, mixed ? 256 : (uint32_t)ramp->n,
                                !mixed};
    if (mixer->run) {
        run_parts(mixer, *walk, colors);
        return;
    }
    walk_of(ramp->spread, walk, table, walk->n, colors);
    if (mixed)
        mix_cells(ramp, walk->n, colors);
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
static void run_padded(const struct pel_ramp_mixer *mixer,
                       struct pel_ramp_walk w, pel_color *colors)
{
    const struct pel_ramp *const ramp = mixer->ramp;
    if (mixer->padded && w.n <= PEL_RAMP_PART &&
        mixer->padded(mixer, &w, colors))
        return;
    for (struct pel_ramp_walk next = w; w.n > 0; w = next) {
        const struct side side = side_of(w.at, w.bits);
        for (; next.n > 0 && next.at - side.low < side.size; next.n--)
            pel_ramp_step(&next);
        w.n -= next.n;
        if (side.low == 0)
            run_inside(mixer, &w, colors);
        else
            fill(ramp->colors[w.at >> 63 ? 0 : ramp->n - 1], w.n, colors);
        colors += w.n;
    }
}

/* One colour. */
static PEL_NOINLINE void run_still(const struct pel_ramp_mixer *mixer,
                                   struct pel_ramp_walk w, pel_color *colors)
{
    const int32_t n = w.n;
    w.n = 1;
    if (mixer->ramp->spread == PEL_PAD && !w.inside)
        run_padded(mixer, w, colors);
    else
        run_inside(mixer, &w, colors);
    fill(colors[0], n - 1, colors + 1);
}

void pel_ramp_run(const void *mixer, const struct pel_ramp_walk *w,
                  pel_color *colors)
{
    const struct pel_ramp_mixer *const m = mixer;
    const bool inside = w->inside || m->ramp->spread != PEL_PAD;
    if ((w->d1 | w->d2 | w->d3) == 0)
        run_still(m, *w, colors);
    else if (!inside)
        run_padded(m, *w, colors);
    else if (m->run && w->n <= PEL_RAMP_PART)
        m->run(m, w, colors);
    else
        run_inside(m, w, colors);
}

#endif
