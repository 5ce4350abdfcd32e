#include "../base/trig.h"
#include "paint_fan.h"

/* round(sum / n), n > 0. */
static int32_t mean(int64_t sum, int32_t n)
{
    int64_t twice = 2 * sum + n, whole = 2 * (int64_t)n;
    int64_t q = twice / whole;
    return (int32_t)(q - (twice % whole < 0));
}

void pel_fan_set_hub(struct pel_fan_points *points)
{
    int64_t x = 0, y = 0, channel[4] = {0, 0, 0, 0};
    PEL_ASSERT(points->n > 0);
    if (points->n <= 0)
        return;
    for (int32_t i = 0; i < points->n; i++) {
        x += points->rim[i].x;
        y += points->rim[i].y;
        for (int k = 0; k < 4; k++)
            channel[k] += points->colors[i] >> 8 * k & 255;
    }
    points->hub.x = mean(x, points->n);
    points->hub.y = mean(y, points->n);
    points->hub_color = 0;
    for (int k = 0; k < 4; k++)
        points->hub_color |= (pel_color)mean(channel[k], points->n) << 8 * k;
}

void pel_fan_rim(struct pel_point *rim, int32_t n, struct pel_point center,
                 int32_t radius, uint16_t start)
{
    for (int32_t i = 0; i < n; i++) {
        uint32_t turn = start + (uint32_t)((int64_t)i * 65536 / n);
        struct pel_point d = pel_direction((uint16_t)turn);
        rim[i].x = center.x + mean((int64_t)d.x * radius, PEL_DIRECTION_ONE);
        rim[i].y = center.y + mean((int64_t)d.y * radius, PEL_DIRECTION_ONE);
    }
}
