#include "paint.h"

void pel_nothing_fill(const struct pel_paint *paint,
                      const struct pel_spans *spans)
{
    (void)paint;
    (void)spans;
}
