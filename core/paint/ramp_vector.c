#include "ramp_vector.h"

#include "ramp_lanes.h"
#include "ramp_mix.h"

#if PEL_FAST_64BIT && PEL_VECTORS

/* How a loop mixes. `opaque` and `padded` are constants wherever this is
 * inlined. */
struct mix {
    const struct pel_ramp_channel *channel;
    pel_u32x4 unsure; /* a bit of the cell: a position was near its end */
    bool opaque, padded;
};

/* The cells of eight pixels: the highest bits, or where padded walks have two
 * more, the next ones. */
static PEL_ALWAYS_INLINE pel_u16x8 next_cells(struct mix *m,
                                              struct pel_lanes *l)
{
    const pel_u32x4 p = pel_lanes_next(l), q = pel_lanes_next(l);
    m->unsure |= (p ^ (p + PEL_LANES_ERROR)) | (q ^ (q + PEL_LANES_ERROR));
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

/* At most 64 pixels; false when a colour may be wrong. */
static PEL_ALWAYS_INLINE bool mix(struct mix *m, const struct pel_ramp_walk *w,
                                  int shift, pel_color *out)
{
    struct pel_lanes l = pel_lanes_of(w, shift);
    const uint64_t cell =
        m->padded ? UINT64_C(0xFFC00000FFC00000) : UINT64_C(0xFF000000FF000000);
    int32_t n = w->n;
    m->unsure = (pel_u32x4){0, 0, 0, 0};
    for (; n >= 8; n -= 8, out += 8)
        next_eight(m, &l, out);
    if (n > 0)
        mix_last(m, &l, n, out);
    const pel_u64x2 unsure = (pel_u64x2)m->unsure;
    return ((unsure[0] | unsure[1]) & cell) == 0;
}

/* Pixel by pixel, where a position is so near above the end of a cell that the
 * one in the vector may be below. */
static PEL_NOINLINE void repair_mix(const struct pel_ramp *ramp,
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
    struct mix m = {mixer->channel, {0, 0, 0, 0}, true, false};
    if (!mix(&m, w, 64 - w->bits, out))
        repair_mix(mixer->ramp, w, out);
}

static void mix_alpha(const struct pel_ramp_mixer *mixer,
                      const struct pel_ramp_walk *w, pel_color *out)
{
    struct mix m = {mixer->channel, {0, 0, 0, 0}, false, false};
    if (!mix(&m, w, 64 - w->bits, out))
        repair_mix(mixer->ramp, w, out);
}

/* A table of colours. `power` is a constant wherever this is inlined: their
 * number is 2^(32 - shift), so that a cell is the highest bits. */
struct table {
    const pel_color *color;
    pel_u64x2 cells, margin; /* PEL_LANES_ERROR times that */
    pel_u64x2 unsure;        /* a bit of the upper half, or of a cell */
    uint32_t shift;
    bool power;
};

/* The cells of two pixels, in the upper halves. */
static PEL_ALWAYS_INLINE pel_u64x2 cells_of(struct table *t, pel_u64x2 at)
{
    const pel_u64x2 product = pel_multiply_u64x2(at, t->cells);
    t->unsure |= product ^ (product + t->margin);
    return product;
}

/* The cells of the next four pixels. */
static PEL_ALWAYS_INLINE pel_u64x2 next_places(struct table *t,
                                               struct pel_lanes *l)
{
    const pel_u32x4 at = pel_lanes_next(l);
    if (t->power) {
        t->unsure |= (pel_u64x2)(at ^ (at + PEL_LANES_ERROR));
        return (pel_u64x2)(at >> t->shift);
    }
    const pel_u64x2 even = cells_of(t, (pel_u64x2)at);
    return (pel_u64x2)pel_lanes_high(even, cells_of(t, (pel_u64x2)at >> 32));
}

static PEL_ALWAYS_INLINE void next_four(struct table *t, struct pel_lanes *l,
                                        pel_color *out)
{
    const pel_u64x2 cell = next_places(t, l);
    const uint64_t low = cell[0], high = cell[1];
    out[0] = t->color[(uint32_t)low];
    out[1] = t->color[low >> 32];
    out[2] = t->color[(uint32_t)high];
    out[3] = t->color[high >> 32];
}

static PEL_NOINLINE void repair_look(const struct pel_ramp *ramp,
                                     const struct pel_ramp_walk *walk,
                                     pel_color *out)
{
    const uint32_t cells = (uint32_t)ramp->n;
    const int shift = 64 - walk->bits;
    struct pel_ramp_walk w = *walk;
    for (; w.n > 0; w.n--, out++, pel_ramp_step(&w))
        *out =
            ramp->colors[pel_ramp_cell((uint32_t)(w.at << shift >> 32), cells)];
}

static PEL_ALWAYS_INLINE void look(struct table t, const struct pel_ramp *ramp,
                                   const struct pel_ramp_walk *w,
                                   pel_color *out)
{
    struct pel_lanes l = pel_lanes_of(w, 64 - w->bits);
    pel_color *const end = out + w->n;
    for (; end - out >= 4; out += 4)
        next_four(&t, &l, out);
    if (out < end) {
        pel_color last[4];
        next_four(&t, &l, last);
        for (int i = 0; out < end; out++, i++)
            *out = last[i];
    }
    const uint64_t unsure = t.unsure[0] | t.unsure[1];
    if (t.power ? ((unsure | unsure << 32) >> 32 >> t.shift) : unsure >> 32)
        repair_look(ramp, w, end - w->n);
}

static void look_up(const struct pel_ramp_mixer *mixer,
                    const struct pel_ramp_walk *w, pel_color *out)
{
    const uint64_t n = (uint64_t)mixer->ramp->n, margin = n * PEL_LANES_ERROR;
    const struct table t = {
        mixer->ramp->colors, {n, n}, {margin, margin}, {0, 0}, 0, false};
    look(t, mixer->ramp, w, out);
}

static void look_up_power(const struct pel_ramp_mixer *mixer,
                          const struct pel_ramp_walk *w, pel_color *out)
{
    const struct table t = {mixer->ramp->colors, {0, 0}, {0, 0}, {0, 0},
                            mixer->shift,        true};
    look(t, mixer->ramp, w, out);
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

bool pel_ramp_vectors_padded(const struct pel_ramp_mixer *mixer,
                             const struct pel_ramp_walk *w, pel_color *colors)
{
    struct mix m = {mixer->channel, {0, 0, 0, 0}, false, true};
    return mixer->ramp->n == 2 && w->n <= PEL_RAMP_PART && stays_near(w) &&
           mix(&m, w, 62 - w->bits, colors);
}

static struct pel_ramp_channel channel_of(const pel_color ends[2], int shift)
{
    const pel_u16x8 zero = {0, 0, 0, 0, 0, 0, 0, 0};
    const pel_u16x8 from = zero + (uint8_t)(ends[0] >> shift);
    const pel_u16x8 to = zero + (uint8_t)(ends[1] >> shift);
    return (struct pel_ramp_channel){from * 255 + 128, to - from};
}

/* A ramp of many colours, or of one. */
static void prepare_table(struct pel_ramp_mixer *mixer, uint32_t n)
{
    mixer->run = look_up;
    mixer->shift = 32;
    if ((n & (n - 1)) != 0 || n == 1)
        return;
    mixer->run = look_up_power;
    for (; n > 1; n >>= 1)
        mixer->shift--;
}

void pel_ramp_prepare(struct pel_ramp_mixer *mixer, const struct pel_ramp *ramp)
{
    const pel_color *const ends = ramp->colors;
    mixer->ramp = ramp;
    mixer->run = NULL;
    if (ramp->n == 2)
        for (int i = 0; i < 4; i++)
            mixer->channel[i] = channel_of(ends, 8 * i);
    if (ramp->spread == PEL_REFLECT)
        return;
    if (ramp->n != 2)
        prepare_table(mixer, (uint32_t)ramp->n);
    else
        mixer->run = (ends[0] & ends[1]) >> 24 == 255 ? mix_opaque : mix_alpha;
}

#elif PEL_FAST_64BIT

bool pel_ramp_vectors_padded(const struct pel_ramp_mixer *mixer,
                             const struct pel_ramp_walk *w, pel_color *colors)
{
    (void)mixer;
    (void)w;
    (void)colors;
    return false;
}

void pel_ramp_prepare(struct pel_ramp_mixer *mixer, const struct pel_ramp *ramp)
{
    mixer->ramp = ramp;
    mixer->run = NULL;
}

#endif
