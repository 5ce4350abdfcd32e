/* Shapes with their paint, drawn by one of the builds of core. */
#ifndef TESTS_SUPPORT_ITEMS_H
#define TESTS_SUPPORT_ITEMS_H

#include "cases.h"
#include "core/pel.h"

enum item_kind {
    ITEM_TRIANGLE,
    ITEM_GOURAUD,
    ITEM_POLYGON,
    ITEM_CIRCLE,
    ITEM_LINE,
    ITEM_RECTANGLE,
    ITEM_KINDS
};

enum { ITEM_POINTS = 8 };

struct item {
    enum item_kind kind;
    struct pel_point v[ITEM_POINTS]; /* circle: v[0]; line, rectangle: two */
    int32_t n;
    int32_t radius;
    enum pel_fill_rule rule;
    pel_color color[3]; /* color[0] alone but for Gouraud */
};

/* The functions of one build of core. */
struct core {
    void (*triangle)(const struct pel_surface *, const struct pel_point *,
                     const struct pel_paint *);
    void (*gouraud)(const struct pel_surface *, const struct pel_point *,
                    const pel_color *);
    enum pel_status (*polygon)(const struct pel_surface *,
                               const struct pel_polygon_shape *,
                               const struct pel_paint *, void *, size_t);
    void (*circle)(const struct pel_surface *, struct pel_point, int32_t,
                   const struct pel_paint *);
    void (*line)(const struct pel_surface *, struct pel_point, struct pel_point,
                 const struct pel_paint *);
    void (*rectangle)(const struct pel_surface *, struct pel_point,
                      struct pel_point, const struct pel_paint *);
    struct pel_paint flat;
};

extern const struct core core_default;

/* Reaches into the box, from inside it or from far away. Alpha 255, 0 or any;
 * `opaque` allows 255 alone. */
void item_random(struct random *r, struct item *item,
                 const struct pel_rect *box, bool opaque);

void item_draw(const struct core *core, const struct pel_surface *surface,
               const struct item *item);

/* The item's coverage, through another paint. */
void item_cover(const struct pel_surface *surface, const struct item *item,
                const struct pel_paint *paint);

#endif
