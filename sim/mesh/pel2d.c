#include "sim/mesh/pel2d.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "sim/cli/list.h"
#include "sim/cli/number.h"
#include "sim/cli/output.h"
#include "sim/cli/text_line.h"

void pel2d_free(struct pel2d *flat)
{
    free(flat->vertex);
    free(flat->triangle);
    memset(flat, 0, sizeof(*flat));
}

enum { FIELDS_MAX = 8, LINE_MAX_BYTES = 1024 };

struct reader {
    FILE *file;
    const char *path;
    long line;
    char text[LINE_MAX_BYTES];
    char *field[FIELDS_MAX + 1]; /* one more than any line may have */
    int fields;
    uint32_t vertices, triangles; /* as the first line has them */
};

/* The next line, which is to be text of exactly `fields` fields: `wanted`. */
static bool next_fields(struct reader *r, int fields, const char *wanted)
{
    char *rest = NULL, *text = r->text;
    const enum text_line got = text_line_read(r->file, text, sizeof(r->text));
    r->line++;
    if (ferror(r->file))
        return file_refuse(r->path);
    if (got != TEXT_LINE)
        return ERROR_AT(r, "%s: expected %s",
                        got == TEXT_LINE_ZERO   ? "a NUL byte"
                        : got == TEXT_LINE_LONG ? "a line of over 1,023 bytes"
                                                : "the file ends here",
                        wanted);
    if (r->line == 1)
        text += byte_order_mark(text);
    r->fields = 0;
    while (r->fields <= FIELDS_MAX &&
           (r->field[r->fields] = strtok_r(text, " \t\r\n", &rest)) != NULL) {
        r->fields++;
        text = NULL;
    }
    return r->fields == fields ||
           ERROR_AT(r, "%s%d fields: expected %s",
                    r->fields > FIELDS_MAX ? "more than " : "",
                    r->fields > FIELDS_MAX ? FIELDS_MAX : r->fields, wanted);
}

static bool parse_integer(struct reader *r, int i, const char *name,
                          uint32_t most, uint32_t *value)
{
    int64_t n = 0;
    if (number_integer(r->field[i], 0, most, &n) == NUMBER_OK) {
        *value = (uint32_t)n;
        return true;
    }
    return ERROR_AT(r, "%s is '%s': expected a whole number from 0 to %u", name,
                    r->field[i], most);
}

/* True when the decimal is a whole number of 1/256 = 0.00390625. */
static bool is_multiple(const char *text)
{
    char first[9] = "00000000"; /* the digits down to 10^-8 */
    const char *dot = strchr(text, '.');
    size_t n = dot ? strlen(dot + 1) : 0;
    if (n > 0)
        memcpy(first, dot + 1, n < 8 ? n : 8);
    if (n > 8 && strspn(dot + 9, "0") != n - 8)
        return false;
    return strtol(first, NULL, 10) % 390625 == 0;
}

static bool parse_coordinate(struct reader *r, int i, const char *name,
                             int32_t *value)
{
    const char *text = r->field[i];
    enum number_status status = number_subpixels(text, value);
    if (status == NUMBER_MALFORMED)
        return ERROR_AT(r, "%s is '%s': expected decimal pixels such as -12.25",
                        name, text);
    if (status == NUMBER_RANGE)
        return ERROR_AT(r, "%s is %s: expected -32768 to 32767.99609375", name,
                        text);
    if (!is_multiple(text))
        return ERROR_AT(
            r, "%s is %s: expected a whole number of 1/256 px such as %.8f",
            name, text, *value / 256.0);
    return true;
}

static bool parse_uv(struct reader *r, int i, const char *name, double *value)
{
    char *end;
    const char *text = r->field[i];
    *value = strtod(text, &end);
    if (*end == '\0' && text[strspn(text, "+-.eE0123456789")] == '\0' &&
        fabs(*value) <= 1e6)
        return true;
    return ERROR_AT(r, "%s is '%s': expected a decimal from -1e6 to 1e6", name,
                    text);
}

static bool read_header(struct reader *r)
{
    const char *wanted = "'pel2d VERTICES TRIANGLES'";
    if (!next_fields(r, 3, wanted))
        return false;
    if (strcmp(r->field[0], "pel2d") != 0)
        return ERROR_AT(r, "the file begins with '%s': expected %s",
                        r->field[0], wanted);
    return parse_integer(r, 1, "VERTICES", 1u << 28, &r->vertices) &&
           parse_integer(r, 2, "TRIANGLES", 1u << 28, &r->triangles);
}

static bool read_vertex(struct reader *r, struct pel2d *flat)
{
    struct pel2d_vertex v;
    uint32_t c[3] = {0};
    if (!next_fields(r, 8, "a vertex, 'x y r g b depth u v'"))
        return false;
    if (!parse_coordinate(r, 0, "x", &v.at.x) ||
        !parse_coordinate(r, 1, "y", &v.at.y) ||
        !parse_integer(r, 2, "r", 255, &c[0]) ||
        !parse_integer(r, 3, "g", 255, &c[1]) ||
        !parse_integer(r, 4, "b", 255, &c[2]))
        return false;
    if (!mesh_depth_parse(r->field[5], &v.depth))
        return ERROR_AT(r,
                        "depth is '%s': expected a decimal below 1e18 in size "
                        "with at most 36 digits after the point",
                        r->field[5]);
    if (!parse_uv(r, 6, "u", &v.u) || !parse_uv(r, 7, "v", &v.v))
        return false;
    v.color = PEL_RGB(c[0], c[1], c[2]);
    return list_add(&flat->vertex, &flat->vertices, &v, sizeof v);
}

static bool read_triangle(struct reader *r, struct pel2d *flat)
{
    static const char *const name[3] = {"i", "j", "k"};
    uint32_t index[3] = {0};
    if (!next_fields(r, 3, "a triangle, 'i j k'"))
        return false;
    if (r->vertices == 0)
        return ERROR_AT(
            r, "a triangle in a file without vertices: expected TRIANGLES 0");
    for (int k = 0; k < 3; k++)
        if (!parse_integer(r, k, name[k], r->vertices - 1, &index[k]))
            return false;
    return list_add(&flat->triangle, &flat->triangles, index, sizeof index);
}

/* Blank lines may follow the last triangle, nothing else. */
static bool read_end(struct reader *r)
{
    int c;
    r->line++;
    while ((c = getc(r->file)) != EOF) {
        if (c == '\n')
            r->line++;
        else if (!strchr(" \t\r", c) || c == '\0')
            return ERROR_AT(r,
                            "text after the last triangle; the first line says "
                            "that there are %u",
                            r->triangles);
    }
    return !ferror(r->file) || file_refuse(r->path);
}

bool pel2d_load(struct pel2d *flat, const char *path)
{
    struct reader r = {.file = file_open(path), .path = path};
    memset(flat, 0, sizeof(*flat));
    if (!r.file)
        return false;
    bool done = read_header(&r);
    for (uint32_t i = 0; done && i < r.vertices; i++)
        done = read_vertex(&r, flat);
    for (uint32_t i = 0; done && i < r.triangles; i++)
        done = read_triangle(&r, flat);
    done = done && read_end(&r);
    fclose(r.file);
    if (!done)
        pel2d_free(flat);
    return done;
}

bool pel2d_is_file(const char *path)
{
    char start[10];
    struct stat status;
    const char *dot = strrchr(path, '.');
    if (strcmp(path, "-") == 0 || (dot && strcmp(dot, ".pel2d") == 0))
        return true;
    if (stat(path, &status) != 0 || S_ISDIR(status.st_mode))
        return false;
    if (!S_ISREG(status.st_mode)) /* what is read from a pipe is gone */
        return true;
    text_start(path, start, sizeof(start));
    const char *text = start + byte_order_mark(start);
    return strncmp(text, "pel2d", 5) == 0 &&
           (text[5] == ' ' || text[5] == '\t');
}

/* As few digits as give the same double. */
static void print_double(FILE *out, double value, char after)
{
    char text[40];
    for (int digits = 1; digits <= 17; digits++) {
        snprintf(text, sizeof(text), "%.*g", digits, value);
        double back = strtod(text, NULL);
        if (back <= value && back >= value)
            break;
    }
    fprintf(out, "%s%c", text, after);
}

static void print_vertex(FILE *out, const struct pel2d_vertex *v)
{
    char depth[MESH_DEPTH_TEXT];
    mesh_depth_format(&v->depth, depth);
    /* 1/256 has eight places behind the point. */
    fprintf(out, "%.13g %.13g %u %u %u %s ", v->at.x / 256.0, v->at.y / 256.0,
            pel_red(v->color), pel_green(v->color), pel_blue(v->color), depth);
    print_double(out, v->u, ' ');
    print_double(out, v->v, '\n');
}

bool pel2d_save(const struct pel2d *flat, const char *path)
{
    struct output output;
    if (!output_open(&output, path))
        return false;
    FILE *out = output.stream;
    fprintf(out, "pel2d %zu %zu\n", flat->vertices, flat->triangles);
    for (size_t i = 0; i < flat->vertices; i++)
        print_vertex(out, &flat->vertex[i]);
    for (size_t i = 0; i < flat->triangles; i++)
        fprintf(out, "%u %u %u\n", flat->triangle[i][0], flat->triangle[i][1],
                flat->triangle[i][2]);
    return output_commit(&output);
}
