#include "gouraud.h"

#if PEL_FAST_64BIT

bool pel_gouraud_fast(const struct pel_paint *paint,
                      const struct pel_surface *surface,
                      const struct pel_fast_triangle *triangle)
{
    (void)paint;
    (void)surface;
    (void)triangle;
    return false;
}

#endif
