#include "sim/mesh/pel2d.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "sim/cli/output.h"
#include "sim/cli/text_line.h"

void pel2d_free(struct pel2d *flat)
{
    free(flat->vertex);
    free(flat->triangle);
    memset(flat, 0, sizeof(*flat));
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
