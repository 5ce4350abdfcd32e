#include "paint_math.h"

#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "core/paint/paint_texture.h"

/* Newton from a start that is never too small: falls until it stands still. */
real real_root(real v)
{
    real x = v > 1 ? v : 1, next;
    if (v <= 0)
        return 0;
    while (next = (x + v / x) / 2, next < x)
        x = next;
    return x;
}

/* 1 / 2 pi. */
static const real inverse_tau = 0.159154943091895335768883763372514362L;

/* atan(z) = 2 atan(z / (1 + sqrt(1 + z^2))): four times, then the series. */
static real arc_tangent(real z)
{
    for (int i = 0; i < 4; i++)
        z /= 1 + real_root(1 + z * z);
    real square = z * z, power = z, sum = 0;
    for (int k = 1; k < 32; k += 4, power *= square * square)
        sum += power / (real)k - power * square / (real)(k + 2);
    return 16 * sum;
}

real real_turn(real x, real y)
{
    real ax = real_abs(x), ay = real_abs(y), turn;
    if (ax == 0 && ay == 0)
        return 0;
    if (ay <= ax)
        turn = arc_tangent(ay / ax) * inverse_tau;
    else
        turn = 0.25L - arc_tangent(ax / ay) * inverse_tau;
    if (x < 0)
        turn = 0.5L - turn;
    return y < 0 ? 1 - turn : turn;
}

real real_floor(real v)
{
    real whole = (real)(int64_t)v;
    return whole > v ? whole - 1 : whole;
}

void histogram_add(struct histogram *h, real error)
{
    error = real_abs(error);
    if (error > h->worst)
        h->worst = error;
    real bin = error / h->step;
    h->count[bin < HISTOGRAM_BINS - 1 ? (int)bin : HISTOGRAM_BINS - 1]++;
}

void histogram_end(const struct histogram *h)
{
    const char *folder = getenv("PEL_CSV_DIR");
    char path[512];
    uint64_t all = 0;
    for (int i = 0; i < HISTOGRAM_BINS; i++)
        all += h->count[i];
    print_message("%s: %llu values, worst %.4Lg\n", h->name,
                  (unsigned long long)all, h->worst);
    if (!folder)
        return;
    snprintf(path, sizeof path, "%s/%s.csv", folder, h->name);
    FILE *f = fopen(path, "w");
    if (!f)
        fail_msg("cannot write %s", path);
    fprintf(f, "error,count\n");
    for (int i = 0; i < HISTOGRAM_BINS; i++)
        fprintf(f, "%.6Lg,%llu\n", (real)(i + 1) * h->step,
                (unsigned long long)h->count[i]);
    fclose(f);
}

int64_t texel_index(int64_t i, int64_t size, int wrap)
{
    const int64_t period = wrap == PEL_WRAP_REPEAT ? size : 2 * size;
    if (wrap == PEL_WRAP_CLAMP)
        return i < 0 ? 0 : i >= size ? size - 1 : i;
    i = (i % period + period) % period;
    return i < size ? i : 2 * size - 1 - i;
}
