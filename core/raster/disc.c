#include "disc.h"

void pel_disc_start(struct pel_disc *disc, int32_t left_x, int32_t right_x,
                    const struct pel_rect *clip)
{
    struct pel_disc_side *l = &disc->left, *r = &disc->right;
    l->inner = pel_min(pel_max(pel_first_pixel(left_x), clip->x0), clip->x1);
    r->inner = pel_min(pel_max(pel_first_pixel(right_x), clip->x0), clip->x1);
    l->u = left_x - pel_pixel_center(l->inner - 1);
    r->u = pel_pixel_center(r->inner) - right_x;
    l->w = pel_square(l->u) >> 9;
    r->w = pel_square(r->u) >> 9;
    l->columns = r->columns = 0;
    l->limit = l->inner - clip->x0;
    r->limit = clip->x1 - r->inner;
}

/* Adds or takes columns until the side is that of the row; d is what the row
 * leaves for the next column. */
static int32_t settle(struct pel_disc_side *s, int64_t reach)
{
    int32_t u = s->u, columns = s->columns;
    const int64_t most = (reach - (((uint32_t)u * (uint32_t)u) & 511)) >> 9;
    int64_t d = most - s->w;
    while (d >= 0 && columns < s->limit) {
        d -= u + 128;
        u += 256;
        columns++;
    }
    while (columns > 0 && d + u - 128 < 0) {
        u -= 256;
        d += u + 128;
        columns--;
    }
    s->w = most - d;
    s->u = u;
    s->columns = columns;
    return columns;
}

struct pel_row pel_disc_row(struct pel_disc *disc, int64_t reach)
{
    return (struct pel_row){disc->left.inner - settle(&disc->left, reach),
                            disc->right.inner + settle(&disc->right, reach)};
}
