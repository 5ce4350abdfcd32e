#include "items.h"

#include "check.h"
#include "shapes.h"

const struct core core_default = {pel_triangle,
                                  pel_triangle_gouraud,
                                  pel_polygon,
                                  pel_circle,
                                  pel_line,
                                  pel_rectangle,
                                  PEL_PAINT(pel_flat_fill, pel_flat_fast)};

static pel_color random_color(struct random *r, bool opaque)
{
    pel_color c = random_word(r);
    uint32_t kind = random_word(r) % 4;
    if (opaque || kind < 2)
        return c | 0xFF000000u;
    return kind == 2 ? c : c & 0x00FFFFFFu;
}

void item_random(struct random *r, struct item *item,
                 const struct pel_rect *box, bool opaque)
{
    static const int32_t points[ITEM_KINDS] = {3, 3, 8, 1, 2, 2};
    struct pel_rect around = {box->x0 - 6, box->y0 - 6, box->x1 + 6,
                              box->y1 + 6};
    item->kind = (enum item_kind)(random_word(r) % ITEM_KINDS);
    item->n = points[item->kind];
    if (item->kind == ITEM_POLYGON)
        item->n = random_between(r, 3, 8);
    around.x0 = pel_max(around.x0, -32768);
    around.y0 = pel_max(around.y0, -32768);
    around.x1 = pel_min(around.x1, 32767);
    around.y1 = pel_min(around.y1, 32767);
    shape_in_box(r, item->v, item->n, random_word(r) & 1 ? box : &around);
    if (random_word(r) % 8 == 0)
        shape_adversarial(r, item->v, item->n - (item->n > 1));
    item->radius = random_between(r, 0, PEL_PX(box->x1 - box->x0));
    item->rule = random_word(r) & 1 ? PEL_EVEN_ODD : PEL_NON_ZERO;
    for (int i = 0; i < 3; i++)
        item->color[i] = random_color(r, opaque);
}

static void draw(const struct core *core, const struct pel_surface *surface,
                 const struct item *item, const struct pel_paint *paint)
{
    uint32_t scratch[64 * ITEM_POINTS / 4];
    const struct pel_polygon_shape outline = {item->v, item->n, item->rule};
    switch (item->kind) {
    case ITEM_POLYGON:
        assert_int_equal(
            core->polygon(surface, &outline, paint, scratch, sizeof scratch),
            PEL_OK);
        break;
    case ITEM_CIRCLE:
        core->circle(surface, item->v[0], item->radius, paint);
        break;
    case ITEM_LINE:
        core->line(surface, item->v[0], item->v[1], paint);
        break;
    case ITEM_RECTANGLE:
        core->rectangle(surface, item->v[0], item->v[1], paint);
        break;
    default:
        core->triangle(surface, item->v, paint);
    }
}

void item_draw(const struct core *core, const struct pel_surface *surface,
               const struct item *item)
{
    const struct pel_flat flat = {core->flat, item->color[0]};
    if (item->kind == ITEM_GOURAUD)
        core->gouraud(surface, item->v, item->color);
    else
        draw(core, surface, item, &flat.paint);
}

void item_cover(const struct pel_surface *surface, const struct item *item,
                const struct pel_paint *paint)
{
    draw(&core_default, surface, item, paint);
}
