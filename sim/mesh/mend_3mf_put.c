/* What the build of a 3MF places, as OBJ. */
#include "sim/mesh/mend_3mf.h"

#include <string.h>

#include "sim/cli/message.h"

/* Objects inside of objects; and how often they may be placed in all: each that
 * has the next one twice doubles that. */
enum { DEPTH_MAX = 1000, INSTANCES_MAX = 1 << 20 };

static const struct group *group_of(const struct package *p, long id)
{
    for (size_t k = 0; k < p->groups; k++)
        if (p->group[k].id == id)
            return &p->group[k];
    return NULL;
}

/* Entry i of a group; NULL: it has none. */
static const double *entry_of(const struct package *p, const struct group *g,
                              long i)
{
    return g && i >= 0 && (size_t)i < g->end - g->first
               ? p->entry[g->first + (size_t)i].v
               : NULL;
}

static void put_place(const double place[12], const double at[3], double to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = at[0] * place[k] + at[1] * place[3 + k] + at[2] * place[6 + k] +
                place[9 + k];
}

static bool is_mirror(const double m[12])
{
    return m[0] * (m[4] * m[8] - m[5] * m[7]) -
               m[1] * (m[3] * m[8] - m[5] * m[6]) +
               m[2] * (m[3] * m[7] - m[4] * m[6]) <
           0;
}

/* The materials: a texture each, and what has neither that nor a color. */
static void put_materials(struct package *p)
{
    fputs("mtllib pel.mtl\nusemtl none\n", p->m->obj);
    fputs("newmtl none\nKd 0.6 0.6 0.6\n", p->m->mtl);
    for (size_t i = 0; i < p->textures; i++)
        fprintf(p->m->mtl, "newmtl %ld\nKd 1 1 1\nmap_Kd %s%s\n",
                p->texture[i].id, p->texture[i].is_clamped ? "-clamp on " : "",
                p->texture[i].part);
    p->material = -1;
}

static void use_material(struct package *p, long id)
{
    if (id == p->material)
        return;
    p->material = id;
    if (id < 0)
        fputs("usemtl none\n", p->m->obj);
    else
        fprintf(p->m->obj, "usemtl %ld\n", id);
}

static bool put_triangle(struct package *p, const struct object *o,
                         const struct triangle *t, const double place[12])
{
    const size_t first = o > p->object ? o[-1].vertices : 0;
    const bool own = t->color[0] >= 0;
    const struct group *g = group_of(p, t->group >= 0 ? t->group : o->group);
    const bool is_textured =
        g && g->texture >= 0 && entry_of(p, g, own ? t->color[0] : o->color);
    struct mend_corner c = {.has_uv = is_textured};
    use_material(p, is_textured ? g->texture : -1);
    for (int i = 0; i < 3; i++) {
        const int k = is_mirror(place) ? 2 - i : i;
        const double *v = entry_of(p, g, own ? t->color[k] : o->color);
        if (t->vertex[k] >= o->vertices - first)
            return message_error_at(p->m->path, 0,
                                    "a triangle of object %ld names a vertex "
                                    "that is out of range",
                                    o->id);
        for (int j = 0; j < 3; j++)
            c.color[j] = v && !is_textured ? v[j] : MEND_NO_COLOR;
        for (int j = 0; j < 2; j++)
            c.uv[j] = v ? v[j] : 0;
        p->colorless += i == 0 && !v && (own || o->color >= 0);
        put_place(place, p->vertex[first + t->vertex[k]], c.at);
        mend_corner(p->m, &c);
    }
    mend_face(p->m, 3, &c);
    return true;
}

/* An object that may be placed once more; NULL, with a message. */
static const struct object *find_object(struct package *p, long id,
                                        size_t depth)
{
    const struct object *o = p->object;
    const char *wrong = NULL;
    while (o < p->object + p->objects && o->id != id)
        o++;
    if (o == p->object + p->objects)
        wrong = "object %ld is not there";
    else if (depth > p->objects)
        wrong = "object %ld is a part of itself";
    else if (depth > DEPTH_MAX)
        wrong = "object %ld is inside of more than 1000 others";
    else if (++p->instances > INSTANCES_MAX)
        wrong = "object %ld is one of more than 2^20 that are placed: expected "
                "fewer components and items";
    if (wrong)
        message_error_at(p->m->path, 0, wrong, id);
    return wrong ? NULL : o;
}

static bool put_object(struct package *p, long id, const double place[12],
                       size_t depth)
{
    const struct object *o = find_object(p, id, depth);
    if (!o)
        return false;
    const struct object *before = o > p->object ? o - 1 : NULL;
    for (size_t i = before ? before->triangles : 0; i < o->triangles; i++)
        if (!put_triangle(p, o, &p->triangle[i], place))
            return false;
    for (size_t i = before ? before->components : 0; i < o->components; i++) {
        const double *own = p->component[i].place;
        double both[12];
        for (int r = 0; r < 4; r++)
            for (int k = 0; k < 3; k++)
                both[3 * r + k] =
                    own[3 * r] * place[k] + own[3 * r + 1] * place[3 + k] +
                    own[3 * r + 2] * place[6 + k] + (r == 3 ? place[9 + k] : 0);
        if (!put_object(p, p->component[i].object, both, depth + 1))
            return false;
    }
    return true;
}

bool mend_3mf_put(struct package *p)
{
    put_materials(p);
    for (size_t i = 0; i < p->items; i++)
        if (!put_object(p, p->item[i].object, p->item[i].place, 1))
            return false;
    return true;
}
