#include "sim/mesh/pel2d.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "sim/cli/output.h"

/* Sub-pixels as a decimal without trailing zeros: 1/256 has eight places. */
static void print_coordinate(FILE *out, int32_t value)
{
    char text[24];
    int n = snprintf(text, sizeof(text), "%.8f", value / 256.0);
    while (text[n - 1] == '0')
        n--;
    text[text[n - 1] == '.' ? n - 1 : n] = '\0';
    fprintf(out, "%s ", text);
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
    print_coordinate(out, v->at.x);
    print_coordinate(out, v->at.y);
    fprintf(out, "%u %u %u %s ", pel_red(v->color), pel_green(v->color),
            pel_blue(v->color), depth);
    print_double(out, v->u, ' ');
    print_double(out, v->v, '\n');
}

bool pel2d_save(const struct pel2d *flat, const char *path)
{
    struct output output;
    if (!output_open(&output, path))
        return false;
    FILE *out = output.stream;
    fprintf(out, "pel2d %u %u\n", flat->vertices, flat->triangles);
    for (uint32_t i = 0; i < flat->vertices; i++)
        print_vertex(out, &flat->vertex[i]);
    for (uint32_t i = 0; i < flat->triangles; i++)
        fprintf(out, "%u %u %u\n", flat->triangle[i][0], flat->triangle[i][1],
                flat->triangle[i][2]);
    return output_commit(&output);
}
