#include "disc.h"

void pel_disc_start(struct pel_disc *disc, int32_t left_x, int32_t right_x,
                    int64_t reach, const struct pel_rect *clip)
{
    struct pel_disc_side *l = &disc->left, *r = &disc->right;
    l->inner = pel_min(pel_max(pel_first_pixel(left_x), clip->x0), clip->x1);
    r->inner = pel_min(pel_max(pel_first_pixel(right_x), clip->x0), clip->x1);
    l->u = left_x - pel_pixel_center(l->inner - 1);
    r->u = pel_pixel_center(r->inner) - right_x;
    l->d = (reach - pel_square(l->u)) >> 9;
    r->d = (reach - pel_square(r->u)) >> 9;
    l->columns = r->columns = 0;
    l->limit = l->inner - clip->x0;
    r->limit = clip->x1 - r->inner;
}

/* Adds or takes columns until the side is that of the present row. */
static int32_t settle(struct pel_disc_side *s)
{
    int64_t d = s->d;
    int32_t u = s->u, columns = s->columns;
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
    s->d = d;
    s->u = u;
    s->columns = columns;
    return columns;
}

struct pel_row pel_disc_row(struct pel_disc *disc)
{
    return (struct pel_row){disc->left.inner - settle(&disc->left),
                            disc->right.inner + settle(&disc->right)};
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
