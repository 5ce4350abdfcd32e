#include "disc.h"

#include "disc_side.h"

void pel_disc_start(struct pel_disc *disc, int32_t left_x, int32_t right_x,
                    int64_t reach, const struct pel_rect *clip)
{
    struct pel_row *inner = &disc->inner;
    inner->x0 = pel_min(pel_max(pel_first_pixel(left_x), clip->x0), clip->x1);
    inner->x1 = pel_min(pel_max(pel_first_pixel(right_x), clip->x0), clip->x1);
    disc->left.limit = inner->x0 - clip->x0;
    disc->right.limit = clip->x1 - inner->x1;
    pel_disc_side_start(&disc->left, reach,
                        left_x - pel_pixel_center(inner->x0 - 1));
    pel_disc_side_start(&disc->right, reach,
                        pel_pixel_center(inner->x1) - right_x);
}

static PEL_HOT int32_t columns(struct pel_disc_side *s)
{
    return pel_disc_side_columns(s);
}

struct pel_row pel_disc_row(struct pel_disc *disc)
{
    return (struct pel_row){disc->inner.x0 - columns(&disc->left),
                            disc->inner.x1 + columns(&disc->right)};
}

/* The low 9 bits of u^2 are the same in all columns. */
static void change_side(struct pel_disc_side *s, int64_t from, int64_t to)
{
    const uint32_t low = (uint32_t)s->u * (uint32_t)s->u & 511;
    s->d += ((to - low) >> 9) - ((from - low) >> 9);
}

void pel_disc_change(struct pel_disc *disc, int64_t from, int64_t to)
{
    change_side(&disc->left, from, to);
    change_side(&disc->right, from, to);
}
