/* PLY whose faces have colours: text and binary of either order. A face's
 * colour is that of its corners, whatever they have of their own. Integers are
 * of the whole range of their type, floats 0 to 1. */
#include "sim/mesh/mend.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "sim/cli/bytes.h"
#include "sim/cli/message.h"

enum { ELEMENTS = 16, PROPERTIES = 32, NAME = 32 };

enum type { NONE, INT8, UINT8, INT16, UINT16, INT32, UINT32, REAL32, REAL64 };

struct property {
    char name[NAME];
    enum type type, count; /* count: of a list; or NONE */
};

struct element {
    char name[NAME];
    double count;
    struct property property[PROPERTIES];
    int properties;
};

struct ply {
    struct mend *m;
    struct element element[ELEMENTS];
    int elements;
    int order; /* 0: text; 1: the lowest byte first; 2: the highest */
    const char *at, *end;
    struct mend_corner *vertex;
    size_t vertices;
    double *list; /* the numbers of one */
    size_t room;
};

static enum type type_of(const char *name)
{
    static const char *const names[][2] = {
        {"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
        {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
        {"float", "float32"}, {"double", "float64"}};
    for (int i = 0; i < 8; i++)
        if (strcmp(name, names[i][0]) == 0 || strcmp(name, names[i][1]) == 0)
            return (enum type)(i + 1);
    return NONE;
}

static bool read_property(struct ply *p, const char *line)
{
    struct element *e = p->elements ? &p->element[p->elements - 1] : NULL;
    char a[NAME], b[NAME], name[NAME];
    struct property new = {.count = NONE};
    if (!e || e->properties == PROPERTIES)
        return false;
    if (sscanf(line, "property list %31s %31s %31s", a, b, name) == 3) {
        new.count = type_of(a);
        new.type = type_of(b);
        if (new.count == NONE || new.count >= REAL32)
            return false;
    } else if (sscanf(line, "property %31s %31s", a, name) == 2)
        new.type = type_of(a);
    else
        return false;
    strcpy(new.name, name);
    e->property[e->properties++] = new;
    return new.type != NONE;
}

static bool read_head_line(struct ply *p, const char *line)
{
    char word[NAME];
    struct element *e = &p->element[p->elements];
    if (sscanf(line, "format %31s", word) == 1) {
        p->order = strcmp(word, "binary_little_endian") == 0 ? 1
                   : strcmp(word, "binary_big_endian") == 0  ? 2
                                                             : 0;
        return p->order || strcmp(word, "ascii") == 0;
    }
    if (p->elements < ELEMENTS &&
        sscanf(line, "element %31s %lf", e->name, &e->count) == 2) {
        p->elements++;
        return e->count >= 0 && e->count <= 1 << 28;
    }
    return strncmp(line, "property ", 9) == 0
               ? read_property(p, line)
               : strncmp(line, "element", 7) != 0;
}

/* The next line of the head, of a long one the beginning. False when there is
 * none, or one with a NUL in it, which no text has. */
static bool take_line(struct ply *p, char *line, size_t size)
{
    const size_t left = (size_t)(p->end - p->at);
    const char *end = memchr(p->at, '\n', left);
    const size_t n = end ? (size_t)(end - p->at) : left;
    if (left == 0 || memchr(p->at, '\0', n))
        return false;
    snprintf(line, size, "%.*s", (int)(n < size ? n : size), p->at);
    line[strcspn(line, "\r")] = '\0';
    p->at += n + (end ? 1 : 0);
    p->m->line++;
    return true;
}

/* Is it the first word, whatever comes behind? */
static bool begins(const char *line, const char *word)
{
    const size_t n = strlen(word);
    return strncmp(line, word, n) == 0 &&
           (!line[n] || isspace((unsigned char)line[n]));
}

/* Up to end_header. False without a message. */
static bool read_head(struct ply *p)
{
    char line[256];
    p->m->line = 0;
    p->at = p->m->text;
    p->end = p->m->text + p->m->size;
    while (take_line(p, line, sizeof(line))) {
        if (p->m->line == 1 ? !begins(line, "ply") && !begins(line, "PLY")
                            : !read_head_line(p, line))
            return false;
        if (begins(line, "end_header")) {
            p->m->line++; /* that of the first element */
            return true;
        }
    }
    return false;
}

static int property_of(const struct element *e, const char *names)
{
    for (int i = 0; i < e->properties; i++) {
        char word[NAME + 2];
        snprintf(word, sizeof(word), " %s ", e->property[i].name);
        if (strstr(names, word))
            return i;
    }
    return -1;
}

/* Of a strip assimp's reader keeps the last triangle alone, and in a header
 * without an end, in small letters, it stays for ever. It refuses what does not
 * begin with ply, or at all. */
bool mend_ply_check(struct mend *m)
{
    char line[256];
    unsigned long strips = 0;
    struct ply p = {.m = m, .at = m->text, .end = m->text + m->size};
    bool more = take_line(&p, line, sizeof(line)), ended = false;
    if (m->size == 0 || (more && strncasecmp(line, "ply", 3) != 0))
        return true;
    while (more && !ended) {
        more = take_line(&p, line, sizeof(line));
        sscanf(line, "element tristrips %lu", &strips);
        ended = more && begins(line, "end_header") && p.at[-1] == '\n';
    }
    if (!ended && memchr(p.at, 0, (size_t)(p.end - p.at)))
        return message_error_at(m->path, 0,
                                "has a zero byte in its header: expected lines "
                                "of text up to end_header");
    if (!ended)
        return message_error_at(m->path, 0,
                                "ends inside of its header: expected a line "
                                "end_header, and the mesh after it");
    return strips == 0 ||
           message_error_at(
               m->path, 0,
               "has %lu triangle strips, of which assimp would lose all but a "
               "triangle each: expected a file with faces",
               strips);
}

bool mend_ply_wanted(struct mend *m)
{
    struct ply *p = calloc(1, sizeof(*p));
    bool wanted = false;
    if (!p)
        return false;
    p->m = m;
    if (read_head(p))
        for (int i = 0; i < p->elements; i++)
            wanted = wanted ||
                     (strcmp(p->element[i].name, "face") == 0 &&
                      property_of(&p->element[i], " red diffuse_red ") >= 0);
    free(p);
    m->line = 0;
    return wanted;
}

static bool refuse(const struct ply *p, const char *what)
{
    return message_error_at(p->m->path, p->order ? 0 : p->m->line, "%s", what);
}

static bool read_text(struct ply *p, double *value)
{
    char *end;
    for (; p->at < p->end && isspace((unsigned char)*p->at); p->at++)
        p->m->line += *p->at == '\n';
    *value = strtod(p->at, &end);
    if (end == p->at)
        return refuse(p, p->at == p->end ? "ends before its faces do"
                                         : "something else than a number");
    p->at = end;
    return true;
}

static bool read_number(struct ply *p, enum type type, double *value)
{
    static const int bytes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    const int n = bytes[type];
    uint32_t half[2];
    uint64_t bits;
    float real;
    if (!p->order)
        return read_text(p, value);
    if (p->end - p->at < n)
        return refuse(p, "ends before its faces do");
    for (int i = 0; i < 2; i++) {
        const uint8_t *at = (const uint8_t *)p->at + (n == 8 ? 4 * i : 0);
        half[i] = p->order == 1 ? bytes_little(at, n == 8 ? 4 : n)
                                : bytes_big(at, n == 8 ? 4 : n);
    }
    p->at += n;
    bits = p->order == 1 ? (uint64_t)half[1] << 32 | half[0]
                         : (uint64_t)half[0] << 32 | half[1];
    memcpy(&real, &half[0], sizeof(real));
    memcpy(value, &bits, sizeof(*value));
    if (type != REAL64)
        *value = type == REAL32 ? (double)real : half[0];
    if (type == INT8 || type == INT16 || type == INT32)
        *value -= half[0] >> (8 * n - 1) ? ldexp(1, 8 * n) : 0;
    return true;
}

/* One property of one element: its number, or a list of them, which goes to
 * p->list; how many there are. */
static bool read_values(struct ply *p, const struct property *q, size_t *n)
{
    double count = 1;
    if (q->count && !read_number(p, q->count, &count))
        return false;
    if (!(count >= 0 && count <= 1 << 20))
        return message_error_at(p->m->path, p->order ? 0 : p->m->line,
                                "a list has %g numbers: expected 0 to %d",
                                count, 1 << 20);
    *n = (size_t)count;
    if (*n >= p->room) {
        free(p->list);
        p->room = 2 * *n + 1;
        p->list = malloc(p->room * sizeof(*p->list));
    }
    if (!p->list)
        return message_error("no memory for %zu numbers", p->room);
    for (size_t i = 0; i < *n; i++)
        if (!read_number(p, q->type, &p->list[i]))
            return false;
    return true;
}

static double as_color(double value, enum type type)
{
    static const double most[] = {1,          127,        255, 32767, 65535,
                                  2147483647, 4294967295, 1,   1};
    const double v = value / most[type];
    return v > 0 ? v < 1 ? v : 1 : 0;
}

/* Where a number of a vertex goes; NULL: nowhere. */
static double *place_of(struct mend_corner *c, const char *name)
{
    static const char *const names[] = {" x ",
                                        " y ",
                                        " z ",
                                        " nx ",
                                        " ny ",
                                        " nz ",
                                        " u s tx texture_u ",
                                        " v t ty texture_v ",
                                        " red diffuse_red ",
                                        " green diffuse_green ",
                                        " blue diffuse_blue "};
    double *const places[] = {&c->at[0],     &c->at[1],     &c->at[2],
                              &c->normal[0], &c->normal[1], &c->normal[2],
                              &c->uv[0],     &c->uv[1],     &c->color[0],
                              &c->color[1],  &c->color[2]};
    char word[NAME + 2];
    snprintf(word, sizeof(word), " %s ", name);
    for (int i = 0; i < 11; i++)
        if (strstr(names[i], word)) {
            c->has_normal = c->has_normal || (i >= 3 && i < 6);
            c->has_uv = c->has_uv || (i >= 6 && i < 8);
            return places[i];
        }
    return NULL;
}

static bool read_vertex(struct ply *p, const struct element *e,
                        struct mend_corner *c)
{
    *c = (struct mend_corner){
        .color = {MEND_NO_COLOR, MEND_NO_COLOR, MEND_NO_COLOR}};
    for (int i = 0; i < e->properties; i++) {
        size_t n;
        if (!read_values(p, &e->property[i], &n))
            return false;
        double *to = n == 1 ? place_of(c, e->property[i].name) : NULL;
        if (to)
            *to = to >= c->color && to < c->color + 3
                      ? as_color(p->list[0], e->property[i].type)
                      : p->list[0];
    }
    return true;
}

/* The indices come before or behind the colour: both are kept till the end. */
static bool read_face(struct ply *p, const struct element *e)
{
    struct mend_corner like = {.has_uv = false};
    double *index = NULL;
    size_t corners = 0, n;
    bool good = true;
    for (int i = 0; i < e->properties && good; i++) {
        const struct property *q = &e->property[i];
        double *to;
        good = read_values(p, q, &n);
        if (good && q->count &&
            property_of(e, " vertex_indices vertex_index ") == i) {
            index = p->list;
            corners = n;
            p->list = NULL;
            p->room = 0;
        } else if (good && !q->count && (to = place_of(&like, q->name)))
            *to = as_color(p->list[0], q->type);
    }
    for (size_t i = 0; i < corners && good; i++) {
        good = index[i] >= 0 && index[i] < (double)p->vertices;
        if (!good) {
            refuse(p, "a face names a vertex that is out of range");
            break;
        }
        struct mend_corner c = p->vertex[(size_t)index[i]];
        memcpy(c.color, like.color, sizeof(c.color));
        mend_corner(p->m, &c);
    }
    if (good && corners)
        mend_face(p->m, (long)corners, p->vertex);
    free(index);
    return good;
}

static bool read_element(struct ply *p, const struct element *e)
{
    const bool vertex = strcmp(e->name, "vertex") == 0;
    const bool face = strcmp(e->name, "face") == 0;
    if (vertex && !p->vertex) {
        p->vertices = (size_t)e->count;
        p->vertex = calloc(p->vertices + 1, sizeof(*p->vertex));
        if (!p->vertex)
            return message_error("no memory for %zu vertices", p->vertices);
    }
    if (face && !p->vertex && e->count > 0)
        return refuse(p, "has faces before its vertices: expected the vertices "
                         "first");
    for (size_t i = 0; i < (size_t)e->count; i++) {
        struct mend_corner other;
        if (face
                ? !read_face(p, e)
                : !read_vertex(
                      p, e, vertex && i < p->vertices ? &p->vertex[i] : &other))
            return false;
    }
    return true;
}

bool mend_ply(struct mend *m)
{
    struct ply *p = calloc(1, sizeof(*p));
    if (!p)
        return message_error("no memory for a PLY");
    p->m = m;
    mend_white(m);
    bool good = read_head(p) || refuse(p, "no head of a PLY");
    for (int i = 0; i < p->elements && good; i++)
        good = read_element(p, &p->element[i]);
    free(p->list);
    free(p->vertex);
    free(p);
    return good;
}
