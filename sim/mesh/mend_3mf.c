/* 3MF: meshes of a package, where the build places them, in the colours of
 * their triangles or of the corners of those: basematerials and colorgroup.
 * Where neither triangle nor object names one, they have none. */
#include "sim/mesh/mend.h"

#include "sim/cli/message.h"

#if defined(HAVE_LIBZIP) && defined(HAVE_EXPAT)
#include <expat.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "sim/cli/list.h"

/* Objects inside of objects; and how often they may be placed in all: each that
 * has the next one twice doubles that. */
enum { DEPTH_MAX = 1000, INSTANCES_MAX = 1 << 20 };

struct group {
    long id;
    size_t first, end; /* of the colors */
};

struct color {
    double rgb[3];
};

struct triangle {
    unsigned long vertex[3];
    long group;    /* -1: the object's */
    long color[3]; /* -1: none; the second and third: as the first */
};

struct component {
    long object;
    double place[12];
};

struct object {
    long id, group, color;
    size_t vertices, triangles, components; /* where they end */
};

struct package {
    struct mend *m;
    XML_Parser parser;
    char model[256]; /* the name of its part */
    double (*vertex)[3];
    struct group *group;
    struct color *color;
    struct triangle *triangle;
    struct component *component, *item;
    struct object *object;
    size_t vertices, groups, colors, triangles, components, items, objects;
    size_t instances;        /* of objects */
    unsigned long colorless; /* triangles whose property is no color */
    bool bad;
};

static void refuse(struct package *p, const char *format, const char *what)
{
    char text[200];
    snprintf(text, sizeof(text), format, what);
    if (!p->bad)
        message_error_at(p->m->path, 0, "%s", text);
    p->bad = true;
    XML_StopParser(p->parser, XML_FALSE);
}

/* Names without their prefixes. */
static const char *local(const char *name)
{
    const char *colon = strrchr(name, ':');
    return colon ? colon + 1 : name;
}

static const char *attribute(const char **list, const char *name)
{
    for (; *list; list += 2)
        if (strcmp(local(*list), name) == 0)
            return list[1];
    return NULL;
}

static long number(const char **list, const char *name, long fallback)
{
    const char *text = attribute(list, name);
    return text ? strtol(text, NULL, 10) : fallback;
}

static void add(struct package *p, void *list, size_t *count, const void *entry,
                size_t size)
{
    if (!list_add(list, count, entry, size))
        refuse(p, "%s", "is too large for the memory");
}

static void add_color(struct package *p, const char *text)
{
    struct color c;
    unsigned v[3];
    if (!text || sscanf(text, "#%2x%2x%2x", &v[0], &v[1], &v[2]) != 3) {
        refuse(p, "'%.40s' is no colour", text ? text : "");
        return;
    }
    for (int k = 0; k < 3; k++)
        c.rgb[k] = v[k] / 255.0;
    if (p->groups == 0)
        return;
    add(p, &p->color, &p->colors, &c, sizeof(c));
    p->group[p->groups - 1].end = p->colors;
}

static void add_triangle(struct package *p, const char **list)
{
    struct triangle t = {{0, 0, 0}, number(list, "pid", -1), {0, 0, 0}};
    const char *const corner[] = {"v1", "v2", "v3"};
    const char *const color[] = {"p1", "p2", "p3"};
    for (int k = 0; k < 3; k++) {
        t.vertex[k] = (unsigned long)number(list, corner[k], -1);
        t.color[k] = number(list, color[k], k ? t.color[0] : -1);
    }
    add(p, &p->triangle, &p->triangles, &t, sizeof(t));
    p->object[p->objects - 1].triangles = p->triangles;
}

static void add_vertex(struct package *p, const char **list)
{
    const char *const axes[] = {"x", "y", "z"};
    double at[3];
    for (int k = 0; k < 3; k++) {
        const char *text = attribute(list, axes[k]);
        if (!text || mend_numbers(p->m, text, &at[k], 1) != 1) {
            refuse(p, "a vertex has no %s", axes[k]);
            return;
        }
    }
    add(p, &p->vertex, &p->vertices, at, sizeof(at));
    p->object[p->objects - 1].vertices = p->vertices;
}

static void add_component(struct package *p, const char **list, bool item)
{
    const char *text = attribute(list, "transform");
    struct component c = {number(list, "objectid", -1),
                          {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}};
    if (attribute(list, "path"))
        refuse(p, "%s", "has objects in other parts, which pel does not read");
    if (text && mend_numbers(p->m, text, c.place, 12) != 12)
        refuse(p, "%s", "a transform has not 12 numbers");
    if (item)
        add(p, &p->item, &p->items, &c, sizeof(c));
    else
        add(p, &p->component, &p->components, &c, sizeof(c));
    if (!item)
        p->object[p->objects - 1].components = p->components;
}

/* Materials, and names of objects in other parts, are known by their parts. */
static void check_extensions(struct package *p, const char **list)
{
    const char *text = attribute(list, "requiredextensions");
    char words[200], *rest = words, *word;
    snprintf(words, sizeof(words), "%s", text ? text : "");
    while ((word = strtok_r(rest, " \t\n", &rest))) {
        char name[64];
        const char *uri = NULL;
        snprintf(name, sizeof(name), "xmlns:%.50s", word);
        for (const char **a = list; *a; a += 2)
            uri = strcmp(*a, name) == 0 ? a[1] : uri;
        if (!uri || !(strstr(uri, "/material/") || strstr(uri, "/production/")))
            refuse(p, "requires the extension %.120s, which pel does not have",
                   uri ? uri : word);
    }
}

static void XMLCALL start(void *data, const char *name, const char **list)
{
    struct package *p = data;
    const bool inside = p->objects > 0;
    name = local(name);
    if (strcmp(name, "model") == 0)
        check_extensions(p, list);
    else if (strcmp(name, "object") == 0) {
        const struct object o = {number(list, "id", -1),
                                 number(list, "pid", -1),
                                 number(list, "pindex", -1),
                                 p->vertices,
                                 p->triangles,
                                 p->components};
        add(p, &p->object, &p->objects, &o, sizeof(o));
    } else if (strcmp(name, "basematerials") == 0 ||
               strcmp(name, "colorgroup") == 0) {
        const struct group g = {number(list, "id", -1), p->colors, p->colors};
        add(p, &p->group, &p->groups, &g, sizeof(g));
    } else if (strcmp(name, "base") == 0)
        add_color(p, attribute(list, "displaycolor"));
    else if (strcmp(name, "color") == 0)
        add_color(p, attribute(list, "color"));
    else if (strcmp(name, "vertex") == 0 && inside)
        add_vertex(p, list);
    else if (strcmp(name, "triangle") == 0 && inside)
        add_triangle(p, list);
    else if (strcmp(name, "component") == 0 && inside)
        add_component(p, list, false);
    else if (strcmp(name, "item") == 0)
        add_component(p, list, true);
}

static void XMLCALL find_model(void *data, const char *name, const char **list)
{
    struct package *p = data;
    const char *type = attribute(list, "Type");
    const char *target = attribute(list, "Target");
    if (strcmp(local(name), "Relationship") == 0 && type && target &&
        strstr(type, "/3dmodel"))
        snprintf(p->model, sizeof(p->model), "%s", target + (*target == '/'));
}

/* Parses a part of the package. False, with a message. */
static bool parse(struct package *p, zip_t *zip, const char *name,
                  XML_StartElementHandler begin)
{
    zip_file_t *file = zip_fopen(zip, name, ZIP_FL_NOCASE);
    char part[65536];
    zip_int64_t n = 0;
    if (!file)
        return message_error_at(p->m->path, 0, "has no part %.100s", name);
    p->parser = XML_ParserCreate(NULL);
    XML_SetUserData(p->parser, p);
    XML_SetStartElementHandler(p->parser, begin);
    bool good = true;
    while (good && (n = zip_fread(file, part, sizeof(part))) > 0)
        good = XML_Parse(p->parser, part, (int)n, 0) == XML_STATUS_OK;
    good = good && n == 0 && XML_Parse(p->parser, part, 0, 1) == XML_STATUS_OK;
    if (!good && !p->bad)
        message_error_at(p->m->path, 0, "%.100s, line %lu: %s", name,
                         XML_GetCurrentLineNumber(p->parser),
                         n < 0 ? "damaged"
                               : XML_ErrorString(XML_GetErrorCode(p->parser)));
    XML_ParserFree(p->parser);
    zip_fclose(file);
    return good && !p->bad;
}

/* Color i of a group; NULL: it has none. */
static const double *color_of(const struct package *p, long group, long i)
{
    for (size_t k = 0; k < p->groups; k++) {
        const struct group *g = &p->group[k];
        if (g->id == group && i >= 0 && (size_t)i < g->end - g->first)
            return p->color[g->first + (size_t)i].rgb;
    }
    return NULL;
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

static bool put_triangle(struct package *p, const struct object *o,
                         const struct triangle *t, const double place[12])
{
    const size_t first = o > p->object ? o[-1].vertices : 0;
    const struct mend_corner none = {.has_uv = false};
    for (int i = 0; i < 3; i++) {
        const int k = is_mirror(place) ? 2 - i : i;
        const bool own = t->color[0] >= 0;
        const double *color = color_of(p, t->group >= 0 ? t->group : o->group,
                                       own ? t->color[k] : o->color);
        struct mend_corner c = {
            .color = {MEND_NO_COLOR, MEND_NO_COLOR, MEND_NO_COLOR}};
        if (t->vertex[k] >= o->vertices - first)
            return message_error_at(p->m->path, 0,
                                    "a triangle of object %ld names a vertex "
                                    "that is out of range",
                                    o->id);
        if (color)
            memcpy(c.color, color, sizeof(c.color));
        p->colorless += i == 0 && !color && (own || o->color >= 0);
        put_place(place, p->vertex[first + t->vertex[k]], c.at);
        mend_corner(p->m, &c);
    }
    mend_face(p->m, 3, &none);
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

bool mend_3mf(struct mend *m)
{
    struct package p = {.m = m};
    zip_t *zip = zip_open(m->path, ZIP_RDONLY, NULL);
    if (!zip)
        return message_error_at(m->path, 0, "is no package of 3MF");
    strcpy(p.model, "3D/3dmodel.model");
    bool good = parse(&p, zip, "_rels/.rels", find_model) &&
                parse(&p, zip, p.model, start);
    for (size_t i = 0; i < p.items && good; i++)
        good = put_object(&p, p.item[i].object, p.item[i].place, 1);
    if (good && p.colorless)
        message_error_at(m->path, 0,
                         "%lu triangles have textures or mixtures, which are "
                         "left out",
                         p.colorless);
    zip_close(zip);
    return good; /* the process ends with the lists */
}

#else

bool mend_3mf(struct mend *m)
{
    return message_error_at(m->path, 0,
                            "this pel was built without libzip or expat, "
                            "which read 3MF: the packages libzip-dev and "
                            "libexpat1-dev bring them");
}

#endif
