#include "disc_walk.h"

bool pel_disc_walk_start(struct pel_disc_walk *w,
                         const struct pel_point *center, int32_t radius,
                         const struct pel_rect *clip)
{
    bool legal = pel_point_legal(*center) && pel_radius_legal(radius);
    PEL_ASSERT(legal);
    if (!legal || pel_rect_empty(clip))
        return false;
    w->y = pel_max(pel_first_pixel(center->y - radius), clip->y0);
    w->end = pel_min(pel_pixel_of(center->y + radius + 128), clip->y1);
    w->v = pel_pixel_center(w->y) - center->y;
    pel_disc_center(&w->disc, center->x, center->x);
    pel_disc_start(&w->disc, clip, pel_square(radius) - pel_square(w->v));
    return w->y < w->end;
}
