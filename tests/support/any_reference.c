#include "any_shape.h"
#include "check.h"
#include "reference.h"
#include "reference_shape.h"

static bool rectangle_at(const struct any_shape *s, int32_t x, int32_t y)
{
    return x * 256 + 128 >= s->v[0].x && x * 256 + 128 < s->v[1].x &&
           y * 256 + 128 >= s->v[0].y && y * 256 + 128 < s->v[1].y;
}

/* The corners have a test of their own. */
static bool thick_line_at(const struct any_shape *s, int32_t x, int32_t y)
{
    struct pel_point v[4];
    const struct pel_polygon_shape outline = {v, 4, PEL_NON_ZERO};
    return pel_thick_line_corners(THICK(s), v) &&
           reference_polygon_at(&outline, x, y);
}

bool any_reference_at(const struct any_shape *s, int32_t x, int32_t y)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        return reference_triangle_at(s->v, x, y);
    case ANY_RECTANGLE:
        return rectangle_at(s, x, y);
    case ANY_POLYGON:
        return reference_polygon_at(POLYGON(s), x, y);
    case ANY_CIRCLE:
        return reference_disc_at(s->v[0], s->radius, x, y);
    case ANY_ELLIPSE:
        return reference_ellipse_at(ELLIPSE(s), x, y);
    case ANY_ROUNDED_RECTANGLE:
        return reference_rounded_at(ROUNDED(s), x, y);
    case ANY_RING:
        return reference_ring_at(RING(s), x, y);
    case ANY_SECTOR:
        return reference_sector_at(SECTOR(s), x, y);
    case ANY_ARC:
        return reference_arc_at(ARC(s), x, y);
    case ANY_LINE:
        return reference_line_at(s->v[0], s->v[1], x, y);
    default:
        return thick_line_at(s, x, y);
    }
}

bool any_reference_outline_at(const struct any_shape *s, int32_t x, int32_t y)
{
    struct any_shape whole = *s;
    if (!any_reference_at(s, x, y))
        return false;
    if (s->kind == ANY_SECTOR)
        whole.kind = ANY_CIRCLE;
    return !any_reference_at(&whole, x - 1, y) ||
           !any_reference_at(&whole, x + 1, y) ||
           !any_reference_at(&whole, x, y - 1) ||
           !any_reference_at(&whole, x, y + 1);
}

bool any_fill_expected(const void *s, int32_t x, int32_t y)
{
    const bool covered = any_reference_at(s, x, y);
    if (covered != any_hit(s, x, y))
        fail_msg("%s: hit test of %d, %d: expected %d; %s", any_name(s), x, y,
                 covered, cases_replay());
    return covered;
}

bool any_outline_expected(const void *s, int32_t x, int32_t y)
{
    return any_reference_outline_at(s, x, y);
}
