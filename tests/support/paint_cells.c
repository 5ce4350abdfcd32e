#include "paint_cells.h"

struct pel_ramp cells_ramp(int32_t n, enum pel_spread spread)
{
    static const pel_color two[2] = {0xFF000000, 0xFFFFFFFF};
    static pel_color all[CELLS_MAX];
    if (all[0] == 0)
        for (uint32_t i = 0; i < CELLS_MAX; i++)
            all[i] = 0xFF000000 + i;
    return (struct pel_ramp){n == 2 ? two : all, n, spread};
}

struct pel_ramp cells_random(struct random *r)
{
    static const int32_t usual[] = {1, 2, 3, 16, 100, 255, 256, 1530, 32767};
    int32_t n = random_word(r) % 2 ? usual[random_word(r) % 9]
                                   : random_between(r, 1, CELLS_MAX);
    return cells_ramp(n, (enum pel_spread)(random_word(r) % 3));
}

static int32_t cells_of(const struct pel_ramp *ramp)
{
    return ramp->n == 2 ? 256 : ramp->n;
}

/* The cell that is shown at place k of the unbounded row of cells. */
static int64_t shown(const struct pel_ramp *ramp, int64_t k)
{
    const int64_t n = cells_of(ramp);
    if (ramp->spread == PEL_PAD)
        return k < 0 ? 0 : k < n ? k : n - 1;
    int64_t period = ramp->spread == PEL_REFLECT ? 2 * n : n;
    k = (k % period + period) % period;
    return k < n ? k : 2 * n - 1 - k;
}

real cells_distance(const struct pel_ramp *ramp, pel_color color, real t,
                    real reach)
{
    const real n = cells_of(ramp);
    const int64_t k = (int64_t)real_floor(t * n);
    const int64_t most = (int64_t)(reach * n) + 1;
    for (int64_t i = 0; i <= most; i++) {
        real up = i ? ((real)(k + i) - t * n) / n : 0;
        real down = i ? (t * n - (real)(k - i + 1)) / n : 0;
        bool above = shown(ramp, k + i) == (color & 0xFFFF) % 65536;
        bool below = shown(ramp, k - i) == (color & 0xFFFF) % 65536;
        if (ramp->n == 2) {
            above = shown(ramp, k + i) == (color & 0xFF);
            below = shown(ramp, k - i) == (color & 0xFF);
        }
        if (above && (!below || up < down))
            return up;
        if (below)
            return down;
    }
    return 1;
}

static real folded(enum pel_spread spread, real t)
{
    if (spread == PEL_PAD)
        return t < 0 ? 0 : t > 1 ? 1 : t;
    if (spread == PEL_REPEAT)
        return t - real_floor(t);
    t -= 2 * real_floor(t / 2);
    return t > 1 ? 2 - t : t;
}

real stops_channel(const struct pel_stop *stops, int32_t count,
                   enum pel_spread spread, real t, int channel)
{
    const real at = folded(spread, t) * 65536;
    int32_t k = count - 1;
    while (k >= 0 && stops[k].at > at)
        k--;
    real a = stops[k < 0 ? 0 : k].color >> 8 * channel & 255;
    if (k < 0 || k == count - 1)
        return a;
    real b = stops[k + 1].color >> 8 * channel & 255;
    return a + (b - a) * (at - stops[k].at) / (stops[k + 1].at - stops[k].at);
}
