#include "pen.h"

static bool line_to(struct pel_fill_pen *f, struct pel_point p)
{
    const struct pel_point from = f->at;
    f->at = p;
    return f->sides->kind->add(f->sides, &from, &p);
}

/* Parts that are left open are closed. */
static enum pel_status draw(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p)
{
    struct pel_fill_pen *const f = (struct pel_fill_pen *)(void *)pen;
    const bool room = line_to(f, verb == PEL_LINE ? *p : f->start);
    if (verb == PEL_MOVE && p)
        f->start = f->at = *p;
    return room ? PEL_OK : PEL_ERROR_SCRATCH;
}

void pel_fill_pen_begin(struct pel_fill_pen *pen, struct pel_sides *sides)
{
    *pen = (struct pel_fill_pen){.pen = {draw, sides->top, sides->bottom},
                                 .sides = sides};
}

enum pel_status pel_path_walk_fill(const void *shape, struct pel_sides *sides)
{
    struct pel_fill_pen f;
    pel_fill_pen_begin(&f, sides);
    return pel_path_walk(shape, &f.pen);
}

enum pel_status pel_path_fill(const struct pel_surface *surface,
                              const struct pel_path_shape *shape,
                              const struct pel_paint *paint, void *scratch,
                              size_t size)
{
    const struct pel_outline_source source = {pel_path_walk_fill, shape};
    const struct pel_scratch memory = {scratch, size};
    return shape ? pel_sides_fill(surface, &source, shape->rule, paint, &memory)
                 : PEL_ERROR_NULL;
}

bool pel_hit_path_fill(const struct pel_path_shape *shape, int32_t x, int32_t y)
{
    const struct pel_outline_source source = {pel_path_walk_fill, shape};
    return pel_sides_hit(&source, shape->rule, x, y);
}
