/* 3MF: meshes of a package, where the build places them, in the colours of
 * their triangles or of the corners of those, or with textures: basematerials,
 * colorgroup, texture2dgroup. Where neither triangle nor object names one, they
 * have none. */
#include "sim/mesh/mend.h"

#include "sim/cli/message.h"

#if defined(HAVE_LIBZIP) && defined(HAVE_EXPAT)
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "sim/cli/list.h"
#include "sim/mesh/mend_3mf.h"

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

static void add_entry(struct package *p, const struct entry *e)
{
    if (p->groups == 0)
        return;
    add(p, &p->entry, &p->entries, e, sizeof(*e));
    p->group[p->groups - 1].end = p->entries;
}

static void add_color(struct package *p, const char *text)
{
    struct entry e;
    unsigned v[3];
    if (!text || sscanf(text, "#%2x%2x%2x", &v[0], &v[1], &v[2]) != 3) {
        refuse(p, "'%.40s' is no colour", text ? text : "");
        return;
    }
    for (int k = 0; k < 3; k++)
        e.v[k] = v[k] / 255.0;
    add_entry(p, &e);
}

/* The numbers of attributes; false, with a message, where one is none. */
static bool numbers(struct package *p, const char **list,
                    const char *const *names, int n, double *to)
{
    for (int k = 0; k < n; k++) {
        const char *text = attribute(list, names[k]);
        if (!text || mend_numbers(p->m, text, &to[k], 1) != 1) {
            refuse(p, n == 3 ? "a vertex has no %s" : "a tex2coord has no %s",
                   names[k]);
            return false;
        }
    }
    return true;
}

static void add_place(struct package *p, const char **list)
{
    static const char *const names[] = {"u", "v"};
    struct entry e = {{0, 0, 0}};
    if (numbers(p, list, names, 2, e.v))
        add_entry(p, &e);
}

/* OBJ has no mirrors, and one way to end for both directions. */
static void add_texture(struct package *p, const char **list)
{
    const char *path = attribute(list, "path");
    const char *u = attribute(list, "tilestyleu");
    const char *v = attribute(list, "tilestylev");
    struct texture t = {.id = number(list, "id", -1)};
    u = u ? u : "wrap";
    v = v ? v : "wrap";
    snprintf(t.part, sizeof(t.part), "%s", path ? path : "");
    t.is_clamped = strcmp(u, "clamp") == 0 || strcmp(u, "none") == 0;
    if (strcmp(u, v) != 0 || strcmp(u, "mirror") == 0)
        message_error_at(
            p->m->path, 0,
            "the texture %.100s is repeated as %.20s and %.20s: it "
            "is shown as %s both ways",
            t.part, u, v, t.is_clamped ? "clamp" : "wrap");
    add(p, &p->texture, &p->textures, &t, sizeof(t));
}

static void add_group(struct package *p, const char **list)
{
    const struct group g = {number(list, "id", -1), number(list, "texid", -1),
                            p->entries, p->entries};
    add(p, &p->group, &p->groups, &g, sizeof(g));
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
    static const char *const axes[] = {"x", "y", "z"};
    double at[3];
    if (!numbers(p, list, axes, 3, at))
        return;
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
               strcmp(name, "colorgroup") == 0 ||
               strcmp(name, "texture2dgroup") == 0)
        add_group(p, list);
    else if (strcmp(name, "texture2d") == 0)
        add_texture(p, list);
    else if (strcmp(name, "tex2coord") == 0)
        add_place(p, list);
    else if (strcmp(name, "base") == 0)
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

bool mend_3mf(struct mend *m)
{
    struct package p = {.m = m};
    zip_t *zip = zip_open(m->path, ZIP_RDONLY, NULL);
    if (!zip)
        return message_error_at(m->path, 0, "is no package of 3MF");
    strcpy(p.model, "3D/3dmodel.model");
    const bool good = parse(&p, zip, "_rels/.rels", find_model) &&
                      parse(&p, zip, p.model, start) && mend_3mf_put(&p);
    if (good && p.colorless)
        message_error_at(m->path, 0,
                         "%lu triangles have compositematerials or "
                         "multiproperties, which pel does not have: they are "
                         "left out",
                         p.colorless);
    zip_close(zip);
    return good; /* the process ends with the lists */
}

unsigned char *mend_3mf_part(const char *path, const char *name, size_t *size)
{
    zip_t *zip = zip_open(path, ZIP_RDONLY, NULL);
    zip_stat_t about;
    unsigned char *bytes = NULL;
    name += *name == '/';
    if (!zip)
        return NULL;
    if (zip_stat(zip, name, ZIP_FL_NOCASE, &about) == 0 &&
        (about.valid & ZIP_STAT_SIZE) && about.size < 1u << 31 &&
        (bytes = malloc(about.size + 1))) {
        zip_file_t *file = zip_fopen(zip, name, ZIP_FL_NOCASE);
        const zip_int64_t n = file ? zip_fread(file, bytes, about.size) : -1;
        *size = n > 0 ? (size_t)n : 0;
        if (file)
            zip_fclose(file);
    }
    zip_close(zip);
    return bytes;
}

#else

bool mend_3mf(struct mend *m)
{
    return message_error_at(m->path, 0,
                            "this pel was built without libzip or expat, "
                            "which read 3MF: the packages libzip-dev and "
                            "libexpat1-dev bring them");
}

unsigned char *mend_3mf_part(const char *path, const char *name, size_t *size)
{
    (void)path;
    (void)name;
    (void)size;
    return NULL;
}

#endif
