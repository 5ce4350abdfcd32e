#include "cost.h"

#include "../base/divide.h"
#include "triangle.h"

const struct pel_cost_rates pel_cost_m0plus[PEL_COST_PAINTS] = {
    {580, 0, 16, 44, 63, 20, 10},       {620, 0, 8, 48, 70, 24, 514},
    {4100, 6000, 0, 126, 163, 64, 246}, {605, 0, 11, 48, 69, 345, 323},
    {1200, 0, 2, 66, 76, 330, 5930},
};

const struct pel_cost_rates pel_cost_m4[PEL_COST_PAINTS] = {
    {400, 0, 6, 35, 56, 21, 7},        {375, 0, 6, 42, 56, 6, 337},
    {1040, 4800, 6, 88, 110, 33, 157}, {385, 0, 6, 41, 62, 158, 129},
    {560, 0, 3, 38, 62, 140, 2495},
};

/* Bits of the quotients of the three edges, and of the rows above the clip that
 * each may skip. */
static uint32_t turns_of(const struct pel_point v[3], int32_t top,
                         int32_t clip_top)
{
    const int32_t above = pel_max(clip_top - pel_first_pixel(top), 0);
    int turns = 3 * pel_bits_of((uint32_t)above);
    for (int i = 0, k = 2; i < 3; k = i++) {
        const int64_t dx = v[i].x - v[k].x, dy = v[i].y - v[k].y;
        const int bits = pel_bits_of((uint64_t)pel_size_of(dx)) + 1 -
                         pel_bits_of((uint64_t)pel_size_of(dy));
        turns += dy ? pel_max(bits, 0) : 0;
    }
    return (uint32_t)turns;
}

/* The formula of cost.h, in 2^-17 px; area is twice the triangle's, not
 * 0. */
static uint32_t area_pixels(uint64_t area, int32_t height)
{
    const uint64_t widest = pel_divide(area, (uint32_t)height) + 1;
    const uint64_t excess = height < 256 ? widest * 512 : widest * 320 + 1;
    return (uint32_t)((area + excess) >> 17);
}

void pel_triangle_cost(struct pel_cost *cost, const struct pel_point v[3],
                       const struct pel_rect *clip,
                       const struct pel_cost_rates *rates)
{
    const struct pel_rect box = pel_corners_box(v);
    const struct pel_rect seen = pel_rect_pixels(&box, clip);
    const int32_t width = box.x1 - box.x0, height = box.y1 - box.y0;
    const int32_t longer = pel_max(width, height);
    const uint32_t columns = (uint32_t)pel_max(seen.x1 - seen.x0, 0);
    const uint32_t rows = (uint32_t)pel_max(seen.y1 - seen.y0, 0);
    const uint64_t area = (uint64_t)pel_size_of(pel_triangle_area(v));
    const bool cut = (width | height) >> 15 ||
                     pel_first_pixel(box.x0) < clip->x0 ||
                     pel_first_pixel(box.x1) > clip->x1;
    const bool thin = longer > 1048576 || area < (uint64_t)longer * 16;
    uint32_t pixels = 0;
    if (rows && area)
        pixels = area_pixels(area, height) + rows;
    if (rows && pixels / rows >= columns)
        pixels = rows * columns;
    cost->triangles++;
    cost->rows += rows;
    cost->pixels += pixels;
    cost->instructions += rates->triangle + (thin ? rates->thin : 0);
    if (rows)
        cost->instructions += turns_of(v, box.y0, clip->y0) * rates->turn;
    cost->instructions += rows * (cut ? rates->cut_row : rates->row);
    cost->instructions += (rows < pixels ? rows : pixels) * rates->run;
    cost->instructions += (pel_multiply(pixels, rates->pixel) + 15) >> 4;
}
