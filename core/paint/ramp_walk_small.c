#include "../base/fixed.h"
#include "ramp_mix.h"
#include "ramp_walk.h"

#if !PEL_FAST_64BIT

void pel_ramp_widen(const struct pel_ramp *ramp, struct pel_ramp_walk *w)
{
    const int bits = ramp->spread == PEL_REFLECT ? 63 : 64;
    const int shift = bits - w->bits;
    if (ramp->spread == PEL_PAD && !w->inside)
        return;
    w->at <<= shift;
    w->d1 <<= shift;
    w->d2 <<= shift;
    w->d3 <<= shift;
    w->bits = (uint8_t)bits;
}

/* The highest words of a walk's positions, on a straight line and on a curve.
 */
static PEL_NOINLINE void straight(struct pel_ramp_walk *w, int32_t n,
                                  uint32_t *out)
{
    for (; n > 0; n--, w->at += w->d1)
        *out++ = (uint32_t)(w->at >> 32);
}

static PEL_NOINLINE void curved(struct pel_ramp_walk *w, int32_t n,
                                uint32_t *out)
{
    for (; n > 0; n--, pel_ramp_step(w))
        *out++ = (uint32_t)(w->at >> 32);
}

/* Positions in 2^-32 of the way of a walk that leaves it; in words, since
 * shifts of 64 bits are calls. */
static PEL_NOINLINE void padded(struct pel_ramp_walk *w, int32_t n,
                                uint32_t *out)
{
    for (; n > 0; n--, pel_ramp_step(w)) {
        const uint32_t high = (uint32_t)(w->at >> 32), low = (uint32_t)w->at;
        const int shift = w->bits - 32;
        uint32_t at = high << (32 - shift) | low >> shift;
        if (high >> shift)
            at = high >> 31 ? 0 : UINT32_MAX;
        *out++ = at;
    }
}

/* The highest bit of a position tells which way. */
static PEL_NOINLINE void reflect(int32_t n, uint32_t *at)
{
    for (; n > 0; n--, at++)
        *at = (*at ^ (0 - (*at >> 31))) << 1;
}

static PEL_NOINLINE void mix(const pel_color ends[2], int32_t n, pel_color *out)
{
    const struct pel_pair rb = pel_pair_of(ends[0], ends[1]);
    const struct pel_pair ag = pel_pair_of(ends[0] >> 8, ends[1] >> 8);
    for (; n > 0; n--, out++) {
        const uint32_t cell = *out >> 24;
        *out = pel_pair_at(rb, cell) | pel_pair_at(ag, cell) << 8;
    }
}

void pel_ramp_run(const struct pel_ramp *ramp, struct pel_ramp_walk *walk,
                  int32_t n, pel_color *colors)
{
    if (walk->bits < 63)
        padded(walk, n, colors);
    else if ((walk->d2 | walk->d3) == 0)
        straight(walk, n, colors);
    else
        curved(walk, n, colors);
    if (ramp->spread == PEL_REFLECT)
        reflect(n, colors);
    if (ramp->n == 2)
        mix(ramp->colors, n, colors);
    else
        for (; n > 0; n--, colors++)
            *colors = ramp->colors[pel_ramp_cell(*colors, (uint32_t)ramp->n)];
}

/* What is being filled: pixels run.x to run.x + run.n - 1 come next. */
struct strip {
    struct pel_ramp_walk walk;
    struct pel_run run;
    int32_t left; /* pixels that the walk is right for */
};

static PEL_NOINLINE void put_some(const struct pel_walker *walker,
                                  const void *paint,
                                  const struct pel_surface *surface,
                                  struct strip *s)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    s->run.n = pel_min(s->left, PEL_BUFFER_PIXELS);
    walker->run(paint, &s->walk, s->run.n, colors);
    pel_put_colors(surface, s->run.x, s->run.y, s->run.n, colors);
    s->run.x += s->run.n;
    s->left -= s->run.n;
}

/* A walk goes on from one buffer to the next: only its beginning is costly. */
void pel_walker_fill(const struct pel_walker *walker, const void *paint,
                     const struct pel_rows *rows)
{
    const struct pel_row *row = rows->row;
    struct strip s;
    s.run.y = rows->y;
    for (; row < rows->row + rows->n; row++, s.run.y += rows->step) {
        s.run.x = row->x0;
        while ((s.run.n = row->x1 - s.run.x) > 0) {
            s.left = walker->begin(paint, &s.run, &s.walk);
            while (s.left > 0)
                put_some(walker, paint, rows->surface, &s);
        }
    }
}

void pel_walker_colors(const struct pel_walker *walker, const void *paint,
                       struct pel_run *run, pel_color *colors)
{
    struct pel_ramp_walk walk;
    for (int32_t part; run->n > 0; run->n -= part, run->x += part) {
        part = walker->begin(paint, run, &walk);
        walker->run(paint, &walk, part, colors);
        colors += part;
    }
}

#endif
