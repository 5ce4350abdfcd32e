#include "core/asset/outline_font_asset.h"
#include "sim/font/outline.h"

#include <string.h>

/* A point is put when the next one shows that it is not left out. */
struct putting {
    struct font_points *to;
    FT_Vector begin;   /* of the part */
    FT_Vector control; /* the last of a quadratic curve */
    FT_Vector at;      /* where it ends, which is still to be put */
    enum { NOTHING, POINT, QUAD_END } waits;
};

static int unit(FT_Pos x)
{
    return (int)((x + 32) >> 6);
}

static void put(const struct putting *p, int kind, const FT_Vector *v)
{
    font_points_add(p->to, kind, unit(v->x), unit(v->y));
}

/* The end of the last line or curve. */
static void put_waiting(struct putting *p)
{
    if (p->waits != NOTHING)
        put(p, PEL_OUTLINE_ON, &p->at);
    p->waits = NOTHING;
}

/* Parts close by themselves. */
static void close_part(struct putting *p)
{
    if (unit(p->at.x) != unit(p->begin.x) || unit(p->at.y) != unit(p->begin.y))
        put_waiting(p);
    p->waits = NOTHING;
}

static int move_to(const FT_Vector *to, void *user)
{
    struct putting *p = user;
    close_part(p);
    put(p, PEL_OUTLINE_BEGIN, to);
    p->begin = p->at = *to;
    return 0;
}

static int line_to(const FT_Vector *to, void *user)
{
    struct putting *p = user;
    put_waiting(p);
    p->at = *to;
    p->waits = POINT;
    return 0;
}

/* FreeType rounds what lies half-way between two whole numbers to either. */
static bool is_half_way(FT_Pos a, FT_Pos b, FT_Pos middle)
{
    const FT_Pos off = a + b - 2 * middle;
    return off >= -1 && off <= 1;
}

static int conic_to(const FT_Vector *control, const FT_Vector *to, void *user)
{
    struct putting *p = user;
    if (p->waits != QUAD_END ||
        !is_half_way(p->control.x, control->x, p->at.x) ||
        !is_half_way(p->control.y, control->y, p->at.y))
        put_waiting(p);
    put(p, PEL_OUTLINE_QUAD, control);
    p->control = *control;
    p->at = *to;
    p->waits = QUAD_END;
    return 0;
}

static int cubic_to(const FT_Vector *a, const FT_Vector *b, const FT_Vector *to,
                    void *user)
{
    struct putting *p = user;
    put_waiting(p);
    put(p, PEL_OUTLINE_CUBIC, a);
    put(p, PEL_OUTLINE_CUBIC, b);
    p->at = *to;
    p->waits = POINT;
    return 0;
}

/* A part that begins with a control and ends with one, from point `a` to `z`,
 * begins half-way between them for FreeType: on no unit, perhaps. */
static bool begins_between(const FT_Outline *o, int a, int z)
{
    const FT_Vector *v = o->points;
    return FT_CURVE_TAG(o->tags[a]) == FT_CURVE_TAG_CONIC &&
           FT_CURVE_TAG(o->tags[z]) == FT_CURVE_TAG_CONIC &&
           ((v[a].x + v[z].x) % 128 != 0 || (v[a].y + v[z].y) % 128 != 0);
}

/* Lets a part begin elsewhere, on a unit, if it can. */
static void turn_part(FT_Outline *o, int a, int z)
{
    for (int i = a; i <= z && begins_between(o, a, z); i++) {
        const FT_Vector first = o->points[a];
        const char tag = (char)o->tags[a];
        memmove(o->points + a, o->points + a + 1,
                (size_t)(z - a) * sizeof first);
        memmove(o->tags + a, o->tags + a + 1, (size_t)(z - a));
        o->points[z] = first;
        o->tags[z] = tag;
    }
}

void outline_put(FT_Outline *outline, struct font_points *points)
{
    static const FT_Outline_Funcs functions = {move_to,  line_to, conic_to,
                                               cubic_to, 0,       0};
    struct putting p = {.to = points};
    for (int i = 0, a = 0; i < outline->n_contours; i++) {
        turn_part(outline, a, outline->contours[i]);
        a = outline->contours[i] + 1;
    }
    FT_Outline_Decompose(outline, &functions, &p);
    close_part(&p);
}
