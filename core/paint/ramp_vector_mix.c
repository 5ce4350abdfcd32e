/* Ramps of two colours, mixed eight pixels at a time. */
#include "ramp_lanes.h"
#include "ramp_mix.h"
#include "ramp_vector.h"

#if PEL_FAST_64BIT && PEL_VECTORS

/* How a loop mixes. `opaque` and `padded` are constants wherever this is
 * inlined. */
struct mix {
    const struct pel_ramp_channel *channel;
    pel_u32x4 error;  /* positions may be too small by less than this */
    pel_u32x4 unsure; /* a bit of the cell: a position was near its end */
    bool opaque, padded;
};

static PEL_ALWAYS_INLINE struct mix mix_of(const struct pel_ramp_mixer *mixer,
                                           uint32_t error, bool opaque,
                                           bool padded)
{
    const pel_u32x4 none = {0, 0, 0, 0};
    return (struct mix){mixer->channel, none + error, none, opaque, padded};
}

/* The cells of eight pixels: the highest bits, or where padded walks have two
 * more, the next ones. */
static PEL_ALWAYS_INLINE pel_u16x8 next_cells(struct mix *m,
                                              struct pel_lanes *l)
{
    const pel_u32x4 p = pel_lanes_next(l), q = pel_lanes_next(l);
    m->unsure |= (p ^ (p + m->error)) | (q ^ (q + m->error));
    if (!m->padded)
        return pel_join_u16x8(p >> 24, q >> 24);
    return pel_clamp255_s16x8(pel_join_u16x8((pel_u32x4)((pel_s32x4)p >> 22),
                                             (pel_u32x4)((pel_s32x4)q >> 22)));
}

static PEL_ALWAYS_INLINE pel_u16x8 channel_at(const struct pel_ramp_channel *c,
                                              pel_u16x8 cells)
{
    return pel_divide255_u16x8(c->from + c->way * cells);
}

static PEL_ALWAYS_INLINE void next_eight(struct mix *m, struct pel_lanes *l,
                                         pel_color *out)
{
    const struct pel_ramp_channel *const c = m->channel;
    const pel_u16x8 cells = next_cells(m, l);
    const pel_u16x8 zero = {0, 0, 0, 0, 0, 0, 0, 0};
    const pel_u16x8 a = m->opaque ? zero + 255 : channel_at(c + 3, cells);
    const pel_u16x8 gb = channel_at(c, cells) | channel_at(c + 1, cells) << 8;
    const pel_u16x8 ar = channel_at(c + 2, cells) | a << 8;
    pel_put_u16x8(out, pel_zip_low_u16x8(gb, ar));
    pel_put_u16x8(out + 4, pel_zip_high_u16x8(gb, ar));
}

static PEL_ALWAYS_INLINE void mix_last(struct mix *m, struct pel_lanes *l,
                                       int32_t n, pel_color *out)
{
    pel_color last[8];
    next_eight(m, l, last);
    if (n & 4)
        pel_put_u32x4(out, pel_get_u32x4(last));
    for (int32_t i = n & 4; i < n; i++)
        out[i] = last[i];
}

/* Is none of these bits one that tells the cell? */
static PEL_ALWAYS_INLINE bool is_sure(const struct mix *m, pel_u32x4 unsure)
{
    const uint64_t cell =
        m->padded ? UINT64_C(0xFFC00000FFC00000) : UINT64_C(0xFF000000FF000000);
    const pel_u64x2 bits = (pel_u64x2)unsure;
    return ((bits[0] | bits[1]) & cell) == 0;
}

/* At most 64 pixels; false when a colour may be wrong. */
static PEL_ALWAYS_INLINE bool mix_walk(struct mix m,
                                       const struct pel_ramp_walk *w, int shift,
                                       pel_color *out)
{
    struct pel_lanes l = pel_lanes_of(w, shift);
    int32_t n = w->n;
    for (; n >= 8; n -= 8, out += 8)
        next_eight(&m, &l, out);
    if (n > 0)
        mix_last(&m, &l, n, out);
    return is_sure(&m, m.unsure);
}

/* Pixel by pixel, where a position is so near above the end of a cell that the
 * one in the vector may be below. */
static PEL_NOINLINE void repair(const struct pel_ramp *ramp,
                                const struct pel_ramp_walk *walk,
                                pel_color *out)
{
    const pel_color a = ramp->colors[0], b = ramp->colors[1];
    const struct pel_pair rb = pel_pair_of(a, b),
                          ag = pel_pair_of(a >> 8, b >> 8);
    const int shift = 64 - walk->bits;
    uint64_t at = walk->at << shift, d1 = walk->d1 << shift;
    uint64_t d2 = walk->d2 << shift, d3 = walk->d3 << shift;
    for (int32_t n = walk->n; n > 0; n--, out++, at += d1, d1 += d2, d2 += d3) {
        const uint32_t high = (uint32_t)(at >> 32), cell = high >> 24;
        if (cell != (high - PEL_LANES_ERROR) >> 24)
            *out = pel_pair_at(rb, cell) | pel_pair_at(ag, cell) << 8;
    }
}

static void mix_opaque(const struct pel_ramp_mixer *mixer,
                       const struct pel_ramp_walk *w, pel_color *out)
{
    if (!mix_walk(mix_of(mixer, PEL_LANES_ERROR, true, false), w, 64 - w->bits,
                  out))
        repair(mixer->ramp, w, out);
}

static void mix_alpha(const struct pel_ramp_mixer *mixer,
                      const struct pel_ramp_walk *w, pel_color *out)
{
    if (!mix_walk(mix_of(mixer, PEL_LANES_ERROR, false, false), w, 64 - w->bits,
                  out))
        repair(mixer->ramp, w, out);
}

/* Is every position from -2 to 2? Sure where the first and the last are and
 * none is beyond them, because the function is convex. */
static bool stays_near(const struct pel_ramp_walk *w)
{
    const struct pel_ramp_walk end = pel_ramp_after(*w, w->n - 1);
    const uint64_t two = UINT64_C(2) << w->bits;
    return w->at + two < two * 2 && end.at + two < two * 2 &&
           (int64_t)w->d2 >= 0 && (int64_t)end.d2 >= 0 &&
           ((int64_t)w->d1 >= 0 || (int64_t)end.d1 <= 0);
}

static bool mix_padded(const struct pel_ramp_mixer *mixer,
                       const struct pel_ramp_walk *w, pel_color *colors)
{
    return stays_near(w) &&
           mix_walk(mix_of(mixer, PEL_LANES_ERROR, false, true), w,
                    62 - w->bits, colors);
}

static PEL_NOINLINE void doubt(const struct mix *m, struct pel_grid *g,
                               int32_t v)
{
    struct pel_lanes l = g->row[0];
    for (int32_t u = 0; u < g->width; u += 4) {
        const pel_u32x4 p = pel_lanes_next(&l);
        if (!is_sure(m, p ^ (p + m->error)))
            pel_grid_doubt(g, u, v);
    }
}

static PEL_ALWAYS_INLINE void mix_rows(struct mix m, struct pel_grid *g)
{
    const pel_u32x4 none = {0, 0, 0, 0};
    for (int32_t v = 0; v < g->rows; v++, pel_grid_next(g)) {
        struct pel_lanes l = g->row[0];
        pel_color *const out = g->out + v * g->stride;
        m.unsure = none;
        for (int32_t u = 0; u < g->width; u += 8)
            next_eight(&m, &l, out + u);
        if (!is_sure(&m, m.unsure))
            doubt(&m, g, v);
    }
}

static void mix_rows_opaque(const struct pel_ramp_mixer *mixer,
                            struct pel_grid *g)
{
    mix_rows(mix_of(mixer, g->error, true, false), g);
}

static void mix_rows_alpha(const struct pel_ramp_mixer *mixer,
                           struct pel_grid *g)
{
    mix_rows(mix_of(mixer, g->error, false, false), g);
}

static void mix_rows_padded(const struct pel_ramp_mixer *mixer,
                            struct pel_grid *g)
{
    mix_rows(mix_of(mixer, g->error, false, true), g);
}

static struct pel_ramp_channel channel_of(const pel_color ends[2], int shift)
{
    const pel_u16x8 zero = {0, 0, 0, 0, 0, 0, 0, 0};
    const pel_u16x8 from = zero + (uint8_t)(ends[0] >> shift);
    const pel_u16x8 to = zero + (uint8_t)(ends[1] >> shift);
    return (struct pel_ramp_channel){from * 255 + 128, to - from};
}

void pel_ramp_prepare_mix(struct pel_ramp_mixer *mixer)
{
    const pel_color *const ends = mixer->ramp->colors;
    const bool opaque = (ends[0] & ends[1]) >> 24 == 255;
    for (int i = 0; i < 4; i++)
        mixer->channel[i] = channel_of(ends, 8 * i);
    mixer->run = opaque ? mix_opaque : mix_alpha;
    mixer->padded = mix_padded;
    mixer->rows = opaque ? mix_rows_opaque : mix_rows_alpha;
    mixer->rows_padded = mix_rows_padded;
}

#endif
