/* OFF, text: [ST][C][N][4]OFF, counts, vertices, faces. Colours are 0 to 1, or
 * where one of the file is more than that 0 to 255; a face's is that of its
 * corners; one number would be an index of a table that the file does not have.
 */
#include "sim/mesh/mend.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

enum { NUMBERS = 13 }; /* of a vertex: 4, normal, colour and alpha, uv */

struct off {
    struct mend *m;
    char *at;
    bool has_uv, has_color, has_normal, has_w;
    size_t vertices, faces;
    struct mend_corner *vertex;
    double most;          /* of the colours; -1: there are none */
    unsigned long tables; /* faces whose colour is an index */
};

/* The next line that is not empty; NULL at the end, with a message. */
static char *next_line(struct off *o, const char *what)
{
    while (o->at) {
        char *line = mend_line(o->m, &o->at);
        if (*line)
            return line;
    }
    message_error_at(o->m->path, 0, "ends before its %s", what);
    return NULL;
}

static bool refuse(const struct off *o, const char *what)
{
    return message_error_at(o->m->path, o->m->line, "%s", what);
}

/* The counts may stand in the same line. */
static bool read_head(struct off *o)
{
    double count[3];
    char *line = next_line(o, "head");
    if (!line)
        return false;
    char *word = strstr(line, "OFF");
    o->has_uv = strncmp(line, "ST", 2) == 0;
    line += o->has_uv ? 2 : 0;
    o->has_color = *line == 'C';
    line += o->has_color;
    o->has_normal = *line == 'N';
    line += o->has_normal;
    o->has_w = *line == '4';
    line += o->has_w;
    if (!word || line != word)
        return refuse(o, "no OFF: expected one that begins with OFF, or with "
                         "ST, C, N or 4 before it");
    line = word + 3 + strspn(word + 3, " \t");
    if (strncmp(line, "BINARY", 6) == 0)
        return refuse(o, "a binary OFF: expected one of text");
    if (!*line && !(line = next_line(o, "counts")))
        return false;
    const int n = mend_numbers(o->m, line, count, 3);
    if (n < 0)
        return false;
    if (n < 2 || !(count[0] >= 1 && count[0] <= 1 << 28 && count[1] >= 1 &&
                   count[1] <= 1 << 28))
        return refuse(o, "expected the numbers of vertices and faces, 1 to "
                         "2^28");
    o->vertices = (size_t)count[0];
    o->faces = (size_t)count[1];
    return true;
}

static void set_color(struct off *o, const double *from, double color[3])
{
    for (int k = 0; k < 3; k++) {
        color[k] = from[k];
        o->most = fmax(o->most, from[k]);
    }
}

static bool read_vertex(struct off *o, struct mend_corner *c)
{
    double v[NUMBERS];
    const char *line = next_line(o, "vertices");
    int at = o->has_w ? 4 : 3;
    const int n = line ? mend_numbers(o->m, line, v, NUMBERS) : -1;
    const int uv = o->has_uv ? 2 : 0, normal = o->has_normal ? 3 : 0;
    const int left = n - at - normal - uv;
    *c = (struct mend_corner){.has_uv = o->has_uv, .has_normal = normal};
    if (n < 0)
        return false;
    if (left < 0 || (o->has_color && left < 3))
        return refuse(o, "a vertex has too few numbers");
    for (int k = 0; k < 3; k++) {
        c->at[k] = o->has_w && v[3] != 0 ? v[k] / v[3] : v[k];
        c->normal[k] = normal ? v[at + k] : 0;
        c->color[k] = MEND_NO_COLOR;
    }
    at += normal;
    if (left == 3 || left == 4)
        set_color(o, v + at, c->color);
    for (int k = 0; k < uv; k++)
        c->uv[k] = v[n - 2 + k];
    return true;
}

/* Skips n numbers. */
static const char *skip(const char *line, size_t n)
{
    for (; n > 0; n--) {
        line += strcspn(line, " \t");
        line += strspn(line, " \t");
    }
    return line;
}

/* Reads a face's colour; what is not there is not. */
static bool read_color(struct off *o, const char *rest, double color[3])
{
    double v[4];
    const int n = mend_numbers(o->m, rest, v, 4);
    color[0] = color[1] = color[2] = MEND_NO_COLOR;
    if (n >= 3)
        set_color(o, v, color);
    o->tables += n == 1;
    return n >= 0;
}

static void put_corner(const struct off *o, size_t i, const double color[3])
{
    struct mend_corner c = o->vertex[i];
    const double scale = o->most > 1 ? 255 : 1;
    if (color[0] >= 0)
        memcpy(c.color, color, sizeof(c.color));
    for (int k = 0; k < 3 && c.color[0] >= 0; k++)
        c.color[k] = fmin(fmax(c.color[k] / scale, 0), 1);
    mend_corner(o->m, &c);
}

/* Without any colour vertices are shared. */
static void put_index(const struct off *o, long i, bool first)
{
    const struct mend_corner *c = o->vertex;
    fprintf(o->m->obj, "%s%ld", first ? "f " : " ", i);
    if (c->has_uv)
        fprintf(o->m->obj, "/%ld", i);
    if (c->has_normal)
        fprintf(o->m->obj, "%s/%ld", c->has_uv ? "" : "/", i);
}

/* A line: corners, their indices, a colour. The first pass looks at colours. */
static bool read_face(struct off *o, bool write)
{
    const char *line = next_line(o, "faces");
    double n, color[3];
    if (!line || mend_numbers(o->m, line, &n, 1) != 1)
        return false;
    if (!(n >= 1 && n <= 1 << 20))
        return refuse(o, "a face needs 1 to 2^20 corners");
    const char *rest = skip(line, (size_t)n + 1);
    if (!read_color(o, rest, color))
        return false;
    line = skip(line, 1);
    for (size_t k = 0; k < (size_t)n; k++, line = skip(line, 1)) {
        double i;
        if (mend_numbers(o->m, line, &i, 1) != 1)
            return refuse(o, "a face has too few corners");
        if (!(i >= 0 && i < (double)o->vertices))
            return message_error_at(o->m->path, o->m->line,
                                    "vertex %.0f is out of range: there are "
                                    "%zu, counted from 0",
                                    i, o->vertices);
        if (write && o->most >= 0)
            put_corner(o, (size_t)i, color);
        else if (write)
            put_index(o, (long)i + 1, k == 0);
    }
    if (write && o->most >= 0)
        mend_face(o->m, (long)n, o->vertex);
    else if (write)
        fputc('\n', o->m->obj);
    return true;
}

/* The lines of faces are needed twice: their ends are put back. */
static bool read_faces(struct off *o)
{
    char *first = o->at;
    const long line = o->m->line;
    char *copy = first ? strdup(first) : NULL;
    bool good = copy || refuse(o, "ends before its faces");
    for (int pass = 0; pass < 2 && good; pass++) {
        o->at = pass ? first : copy;
        o->m->line = line;
        o->tables = 0;
        o->m->colorless = o->most < 0;
        for (size_t i = 0; pass && o->most < 0 && i < o->vertices; i++)
            mend_corner(o->m, &o->vertex[i]);
        for (size_t i = 0; i < o->faces && good; i++)
            good = read_face(o, pass);
    }
    free(copy);
    return good;
}

bool mend_off(struct mend *m)
{
    struct off o = {.m = m, .at = m->text, .most = -1};
    if (!read_head(&o))
        return false;
    o.vertex = calloc(o.vertices, sizeof(*o.vertex));
    if (!o.vertex)
        return message_error("no memory for %zu vertices", o.vertices);
    for (size_t i = 0; i < o.vertices; i++)
        if (!read_vertex(&o, &o.vertex[i]))
            return false;
    if (!read_faces(&o))
        return false;
    if (o.tables)
        message_error_at(m->path, 0,
                         "%lu faces have a colour of a table: left out",
                         o.tables);
    return true;
}
