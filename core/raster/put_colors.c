#include "paint.h"

void pel_put_colors(const struct pel_surface *surface, int32_t x, int32_t y,
                    int32_t n, const pel_color *colors)
{
    pel_color mixed[PEL_BUFFER_PIXELS];
    const struct pel_format *format = surface->format;
    PEL_ASSERT(format->load && format->store); /* not a fill-only twin */
    if (!format->load || !format->store)
        return;
    format->load(surface, x, y, n, mixed);
    for (int32_t i = 0; i < n; i++)
        mixed[i] = pel_mix(mixed[i], colors[i], pel_alpha(colors[i]));
    format->store(surface, x, y, n, mixed);
}
