#include "paint.h"

/* Alpha 0 leaves a pixel untouched, down to bits that no channel uses: what is
 * between such pixels is stored piece by piece. */
static void store_touched(const struct pel_surface *s, const struct pel_row *at,
                          int32_t y, const pel_color *colors,
                          const pel_color *mixed)
{
    for (int32_t x = at->x0, n; x < at->x1; x += n + 1) {
        n = 0;
        while (x + n < at->x1 && pel_alpha(colors[x + n - at->x0]) != 0)
            n++;
        if (n)
            s->format->store(s, x, y, n, &mixed[x - at->x0]);
    }
}

void pel_put_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                    int32_t n, const pel_color *colors)
{
    pel_color mixed[PEL_BUFFER_PIXELS];
    const struct pel_row at = {x, x + n};
    const struct pel_format *format = surface->format;
    PEL_ASSERT(format->load && format->store); /* not a fill-only twin */
    if (!format->load || !format->store)
        return;
    format->load(surface, x, y, n, mixed);
    for (int32_t i = 0; i < n; i++)
        mixed[i] = pel_mix(mixed[i], colors[i], pel_alpha(colors[i]));
    store_touched(surface, &at, y, colors, mixed);
}
