#include "../base/point.h"
#include "ramp_mix.h"
#include "ramp_walk.h"

#if !PEL_FAST_64BIT

/* Brings a walk to 64 bits, or 63 where the ramp goes there and back, so that
 * it wraps where the ramp does. */
static PEL_NOINLINE void widen(const struct pel_ramp *ramp,
                               struct pel_ramp_walk *w)
{
    const int bits = ramp->spread == PEL_REFLECT ? 63 : 64;
    const int shift = bits - w->bits;
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
    const bool leaves = ramp->spread == PEL_PAD && !walk->inside;
    if (!leaves && walk->bits < 63)
        widen(ramp, walk);
    if (leaves)
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

static PEL_NOINLINE void put_some(const struct pel_walker *walker,
                                  const void *part,
                                  const struct pel_surface *surface,
                                  struct pel_strip *s)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    const int32_t n = pel_min(s->walk.n, PEL_BUFFER_PIXELS);
    walker->run(part, &s->walk, n, colors);
    pel_put_colors(surface, s->x, s->y, n, colors);
    s->x += n;
    s->walk.n -= n;
}

static const void *part_of(const struct pel_walker *walker, const void *paint)
{
    return (const char *)paint + walker->part;
}

/* A walk goes on from one buffer to the next: only its beginning is costly. */
void pel_walker_fill(const struct pel_paint *paint,
                     const struct pel_spans *spans)
{
    const struct pel_walker *walker =
        ((const struct pel_color_paint *)(const void *)paint)->walker;
    const void *part = part_of(walker, paint);
    const struct pel_span *span = spans->span;
    struct pel_strip s;
    s.y = spans->y;
    for (; span < spans->span + spans->n; span++, s.y += spans->step) {
        s.x = span->x0;
        while ((s.walk.n = span->x1 - s.x) > 0) {
            walker->begin(part, &s);
            while (s.walk.n > 0)
                put_some(walker, part, spans->surface, &s);
        }
    }
}

void pel_walker_colors(const struct pel_color_paint *paint, int32_t x,
                       int32_t y, int32_t n, pel_color *colors)
{
    const void *part = part_of(paint->walker, paint);
    struct pel_strip s;
    s.x = x;
    s.y = y;
    for (; (s.walk.n = x + n - s.x) > 0; s.x += s.walk.n) {
        paint->walker->begin(part, &s);
        paint->walker->run(part, &s.walk, s.walk.n, colors);
        colors += s.walk.n;
    }
}

#endif
