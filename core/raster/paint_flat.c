#include "paint.h"

void pel_flat_fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    pel_fill_color(spans, ((const struct pel_flat *)paint)->color);
}

void pel_nothing_fill(const struct pel_paint *paint,
                      const struct pel_spans *spans)
{
    (void)paint;
    (void)spans;
}
