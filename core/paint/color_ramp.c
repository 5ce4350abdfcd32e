#include "gradient.h"

/* round(a + (b - a) way / length) per channel, 0 <= way < length < 2^33. */
static pel_color mix_exactly(pel_color a, pel_color b, int64_t way,
                             int64_t length)
{
    pel_color color = 0;
    for (int shift = 0; shift < 32; shift += 8) {
        int64_t from = a >> shift & 255, to = b >> shift & 255;
        int64_t twice = 2 * (from * length + (to - from) * way) + length;
        color |= (pel_color)(twice / (2 * length)) << shift;
    }
    return color;
}

static bool stops_legal(const struct pel_stop *stops, int32_t count)
{
    int32_t previous = 0;
    for (int32_t i = 0; i < count; previous = stops[i++].at)
        if (stops[i].at < previous || stops[i].at > 65536)
            return false;
    return true;
}

/* Positions are compared in 1/(131,072 n), where stops and the middles of cells
 * are whole: below 2^32. */
enum pel_status pel_ramp_fill(pel_color *colors, int32_t n,
                              const struct pel_stop *stops, int32_t count)
{
    if (!colors || !stops)
        return PEL_ERROR_NULL;
    if (n < 1 || n > 32767 || count < 1 || count > 32767)
        return PEL_ERROR_SIZE;
    if (!stops_legal(stops, count))
        return PEL_ERROR_RANGE;
    const int64_t unit = 2 * (int64_t)n;
    int32_t next = 0; /* the first stop beyond the middle of the cell */
    for (int32_t i = 0; i < n; i++) {
        int64_t middle = (2 * (int64_t)i + 1) * 65536;
        while (next < count && stops[next].at * unit <= middle)
            next++;
        const struct pel_stop *b = &stops[next], *a = b - (next > 0);
        if (next == 0 || next == count)
            colors[i] = a->color;
        else
            colors[i] = mix_exactly(a->color, b->color, middle - a->at * unit,
                                    (b->at - a->at) * unit);
    }
    return PEL_OK;
}
