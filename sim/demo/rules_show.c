#include "core/pel.h"
#include "sim/demo/rules_sheet.h"

static void fill_box(const struct pel_surface *sheet,
                     const struct pel_rect *box, pel_color color)
{
    const struct pel_flat paint = PEL_FLAT(color);
    const struct pel_point from = {PEL_PX(box->x0), PEL_PX(box->y0)};
    const struct pel_point to = {PEL_PX(box->x1), PEL_PX(box->y1)};
    pel_rectangle(sheet, from, to, &paint.paint);
}

/* Digits of 3 x 5 blocks, rows from the top, the left block in the high bit. */
static void show_digit(const struct pel_surface *sheet, int32_t x, int32_t y,
                       int digit)
{
    static const uint16_t digits[10] = {0x7B6F, 0x2C97, 0x73E7, 0x73CF, 0x5BC9,
                                        0x79CF, 0x79EF, 0x7249, 0x7BEF, 0x7BCF};
    enum { BLOCK = 2 };
    for (int i = 0; i < 15; i++) {
        const int32_t left = x + i % 3 * BLOCK, top = y + i / 3 * BLOCK;
        const struct pel_rect box = {left, top, left + BLOCK, top + BLOCK};
        if (digits[digit] >> (14 - i) & 1)
            fill_box(sheet, &box, PEL_RGB(0x30, 0x30, 0x30));
    }
}

static void show_number(const struct pel_surface *sheet,
                        const struct rules_place *place)
{
    const int32_t y = place->y - 14;
    if (place->number >= 10)
        show_digit(sheet, place->x, y, place->number / 10);
    show_digit(sheet, place->x + (place->number >= 10 ? 8 : 0), y,
               place->number % 10);
}

/* One pixel: its colour inside a grid line, red when painted more than once;
 * its centre, dark when covered. */
static void show_pixel(const struct pel_surface *sheet,
                       const struct pel_point *corner, pel_color color,
                       int hits)
{
    const struct pel_rect grid = {corner->x, corner->y, corner->x + RULES_ZOOM,
                                  corner->y + RULES_ZOOM};
    const struct pel_rect inner = {grid.x0 + 1, grid.y0 + 1, grid.x1, grid.y1};
    const struct pel_flat dot =
        PEL_FLAT(hits ? PEL_RGB(0x20, 0x20, 0x20) : PEL_RGB(0xB8, 0xB8, 0xB8));
    const struct pel_point center = {PEL_PX(grid.x0) + RULES_ZOOM * 128,
                                     PEL_PX(grid.y0) + RULES_ZOOM * 128};
    fill_box(sheet, &grid, PEL_RGB(0xDD, 0xDD, 0xDD));
    fill_box(sheet, &inner, hits > 1 ? PEL_RGB(255, 0, 0) : color);
    pel_circle(sheet, center, 2 * 256, &dot.paint);
}

static void show_pixels(const struct pel_surface *sheet,
                        const struct rules_place *place,
                        const struct rules_pixels *pixels)
{
    for (int32_t y = 0; y < RULES_HEIGHT; y++) {
        for (int32_t x = 0; x < RULES_WIDTH; x++) {
            const struct pel_point corner = {place->x + x * RULES_ZOOM,
                                             place->y + y * RULES_ZOOM};
            show_pixel(sheet, &corner, pixels->color[y][x], pixels->hits[y][x]);
        }
    }
}

/* A vertex in quarters of a pixel on the sheet. */
static struct pel_point zoom_point(const struct rules_place *place,
                                   const uint8_t *q)
{
    const int32_t up = RULES_HEIGHT * 4 - q[1];
    struct pel_point p;
    p.x = PEL_PX(place->x) + q[0] * RULES_ZOOM * 64;
    p.y = PEL_PX(place->y) + (place->y_up ? up : q[1]) * RULES_ZOOM * 64;
    return p;
}

static void show_edges(const struct pel_surface *sheet,
                       const struct rules_place *place,
                       const struct rules_case *rules)
{
    const struct pel_flat paint = PEL_FLAT(PEL_RGB(0x10, 0x30, 0x80));
    for (int i = 0; i < rules->count; i++) {
        for (int side = 0; side < 3; side++) {
            const uint8_t *v = rules->v[i];
            pel_line(sheet, zoom_point(place, v + 2 * side),
                     zoom_point(place, v + 2 * ((side + 1) % 3)), &paint.paint);
        }
    }
}

void rules_show(const struct pel_surface *sheet,
                const struct rules_place *place, const struct rules_case *rules,
                const struct rules_pixels *pixels)
{
    show_number(sheet, place);
    show_pixels(sheet, place, pixels);
    show_edges(sheet, place, rules);
}
