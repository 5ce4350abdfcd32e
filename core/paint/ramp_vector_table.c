/* Ramps of many colours, or of one, looked up four pixels at a time. */
#include "ramp_lanes.h"
#include "ramp_mix.h"
#include "ramp_vector.h"

#if PEL_FAST_64BIT && PEL_VECTORS

/* How a loop looks colours up. `power` and `padded` are constants wherever this
 * is inlined: there are 2^(32 - shift) colours, so that a cell is the highest
 * bits; positions are in 2^-30 of a padded way. */
struct table {
    const pel_color *color;
    pel_u32x4 error;         /* positions may be too small by less than this */
    pel_u64x2 cells, margin; /* how many there are, the error times that */
    pel_u64x2 unsure;        /* a bit of the upper half, or of a cell */
    uint32_t shift;
    bool power, padded;
};

static PEL_ALWAYS_INLINE struct table table_of(
    const struct pel_ramp_mixer *mixer, uint32_t error, bool power, bool padded)
{
    const pel_u32x4 none = {0, 0, 0, 0};
    const uint64_t n = (uint64_t)mixer->ramp->n, margin = n * error;
    return (struct table){
        mixer->ramp->colors, none + error, {n, n}, {margin, margin}, {0, 0},
        mixer->shift,        power,        padded};
}

/* The cells of two pixels, in the upper halves. */
static PEL_ALWAYS_INLINE pel_u64x2 cells_of_two(struct table *t, pel_u64x2 at)
{
    const pel_u64x2 product = pel_multiply_u64x2(at, t->cells);
    if (!t->padded)
        t->unsure |= product ^ (product + t->margin);
    return product;
}

static PEL_ALWAYS_INLINE pel_u64x2 cells_of(struct table *t, pel_u32x4 at)
{
    if (t->power)
        return (pel_u64x2)(at >> t->shift);
    const pel_u64x2 even = cells_of_two(t, (pel_u64x2)at);
    const pel_u64x2 odd = cells_of_two(t, (pel_u64x2)at >> 32);
    return (pel_u64x2)pel_lanes_high(even, odd);
}

/* A position in 2^-32 of the way, which those from 1 on do not reach. */
static PEL_ALWAYS_INLINE pel_u32x4 pad(pel_u32x4 at)
{
    const pel_u32x4 over = (pel_u32x4)((pel_s32x4)at >= 0x40000000);
    return (at | over) << 2;
}

/* The cells of the next four pixels. */
static PEL_ALWAYS_INLINE pel_u64x2 next_cells(struct table *t,
                                              struct pel_lanes *l)
{
    const pel_u32x4 at = pel_lanes_next(l);
    if (t->padded) {
        const pel_u64x2 cells = cells_of(t, pad(at));
        t->unsure |= cells ^ cells_of(t, pad(at + t->error));
        return cells;
    }
    if (t->power)
        t->unsure |= (pel_u64x2)(at ^ (at + t->error));
    return cells_of(t, at);
}

static PEL_ALWAYS_INLINE void next_four(struct table *t, struct pel_lanes *l,
                                        pel_color *out)
{
    const pel_u64x2 cells = next_cells(t, l);
    const uint64_t low = cells[0], high = cells[1];
    out[0] = t->color[(uint32_t)low];
    out[1] = t->color[low >> 32];
    out[2] = t->color[(uint32_t)high];
    out[3] = t->color[high >> 32];
}

static PEL_ALWAYS_INLINE bool is_sure(const struct table *t)
{
    const uint64_t unsure = t->unsure[0] | t->unsure[1];
    if (t->padded)
        return unsure == 0;
    if (t->power)
        return (unsure | unsure << 32) >> 32 >> t->shift == 0;
    return unsure >> 32 == 0;
}

static PEL_NOINLINE void repair(const struct pel_ramp *ramp,
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

static PEL_ALWAYS_INLINE void look_up(struct table t,
                                      const struct pel_ramp *ramp,
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
    if (!is_sure(&t))
        repair(ramp, w, end - w->n);
}

static void look_up_any(const struct pel_ramp_mixer *mixer,
                        const struct pel_ramp_walk *w, pel_color *out)
{
    look_up(table_of(mixer, PEL_LANES_ERROR, false, false), mixer->ramp, w,
            out);
}

static void look_up_power(const struct pel_ramp_mixer *mixer,
                          const struct pel_ramp_walk *w, pel_color *out)
{
    look_up(table_of(mixer, PEL_LANES_ERROR, true, false), mixer->ramp, w, out);
}

static PEL_ALWAYS_INLINE void doubt(struct table t, struct pel_grid *g,
                                    int32_t v)
{
    struct pel_lanes l = g->row[0];
    for (int32_t u = 0; u < g->width; u += 4) {
        t.unsure = (pel_u64x2){0, 0};
        next_cells(&t, &l);
        if (!is_sure(&t))
            pel_grid_doubt(g, u, v);
    }
}

static PEL_ALWAYS_INLINE void look_up_rows(struct table t, struct pel_grid *g)
{
    for (int32_t v = 0; v < g->rows; v++, pel_grid_next(g)) {
        struct pel_lanes l = g->row[0];
        pel_color *const out = g->out + v * g->stride;
        t.unsure = (pel_u64x2){0, 0};
        for (int32_t u = 0; u < g->width; u += 4)
            next_four(&t, &l, out + u);
        if (!is_sure(&t))
            doubt(t, g, v);
    }
}

static void look_up_rows_any(const struct pel_ramp_mixer *mixer,
                             struct pel_grid *g)
{
    look_up_rows(table_of(mixer, g->error, false, false), g);
}

static void look_up_rows_power(const struct pel_ramp_mixer *mixer,
                               struct pel_grid *g)
{
    look_up_rows(table_of(mixer, g->error, true, false), g);
}

static void look_up_rows_padded(const struct pel_ramp_mixer *mixer,
                                struct pel_grid *g)
{
    look_up_rows(table_of(mixer, g->error, false, true), g);
}

void pel_ramp_prepare_table(struct pel_ramp_mixer *mixer)
{
    uint32_t n = (uint32_t)mixer->ramp->n;
    const bool power = (n & (n - 1)) == 0 && n > 1;
    mixer->run = power ? look_up_power : look_up_any;
    mixer->rows = power ? look_up_rows_power : look_up_rows_any;
    mixer->rows_padded = look_up_rows_padded;
    for (mixer->shift = 32; n > 1; n >>= 1)
        mixer->shift--;
}

#endif
