/* A firmware's way with a mesh asset, built with each asset by test_import.sh:
 * projects the quantised positions with a fixed camera, paints them back to
 * front in RGB565, and compares with the picture that pel render drew of the
 * mesh itself. The assets are off by half a step of 1/65,532 of the mesh, so
 * vertices move by at most 1/50 px at 600 px: single pixels along edges differ.
 *
 *     import_draw EXPECTED.ppm flat|gouraud
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/asset/mesh_asset.h"
#include "core/pel.h"

extern const struct pel_mesh_asset asset;

enum { SIZE = 600, WRONG_PPM = 50 };

/* The camera of test_import.sh: the eye looks along -z from EYE. */
static const double eye[3] = {EYE};
static const double focal = 50, sensor = 36;

struct face {
    uint32_t index;
    double depth;
};

static uint16_t memory[SIZE * SIZE];

static double coordinate(uint32_t vertex, int axis)
{
    int32_t n = pel_mesh_quantum_value(&asset.position, axis,
                                       asset.positions[vertex][axis]);
    return ldexp(n, -asset.position.shift);
}

static double depth_of(uint32_t vertex)
{
    return eye[2] - coordinate(vertex, 2);
}

static struct pel_point project(uint32_t vertex)
{
    double scale = SIZE / sensor * focal / depth_of(vertex);
    double x = SIZE / 2.0 + scale * (coordinate(vertex, 0) - eye[0]);
    double y = SIZE / 2.0 - scale * (coordinate(vertex, 1) - eye[1]);
    struct pel_point p = {(int32_t)floor(x * 256 + 0.5),
                          (int32_t)floor(y * 256 + 0.5)};
    return p;
}

static int farther_first(const void *left, const void *right)
{
    const struct face *a = left, *b = right;
    if (a->depth < b->depth || a->depth > b->depth)
        return a->depth > b->depth ? -1 : 1;
    return a->index < b->index ? -1 : 1;
}

static struct face *sort(void)
{
    struct face *face = calloc(asset.triangles, sizeof(*face));
    for (uint32_t i = 0; face && i < asset.triangles; i++) {
        face[i].index = i;
        for (int k = 0; k < 3; k++)
            face[i].depth += depth_of(pel_mesh_asset_index(&asset, i, k));
    }
    if (face)
        qsort(face, asset.triangles, sizeof(*face), farther_first);
    return face;
}

static void draw(const struct pel_surface *surface, uint32_t triangle, int flat)
{
    struct pel_point v[3];
    pel_color c[3];
    unsigned mean[3] = {1, 1, 1};
    for (int k = 0; k < 3; k++) {
        uint32_t i = pel_mesh_asset_index(&asset, triangle, k);
        const uint8_t *rgb = asset.colors[i];
        v[k] = project(i);
        c[k] = PEL_RGB(rgb[0], rgb[1], rgb[2]);
        for (int j = 0; j < 3; j++)
            mean[j] += rgb[j];
    }
    const struct pel_flat paint =
        PEL_FLAT(PEL_RGB(mean[0] / 3, mean[1] / 3, mean[2] / 3));
    if (flat)
        pel_triangle(surface, v, &paint.paint);
    else
        pel_triangle_gouraud(surface, v, c);
}

static int draw_all(const struct pel_surface *surface, int flat)
{
    struct face *face = sort();
    if (!face)
        return 0;
    pel_clear(surface, PEL_RGB(255, 255, 255));
    for (uint32_t i = 0; i < asset.triangles; i++)
        draw(surface, face[i].index, flat);
    free(face);
    return 1;
}

/* Pixels that differ by more than one native step of a channel, or -1. */
static long count_wrong(const struct pel_surface *surface, const char *path)
{
    long wrong = 0;
    static unsigned char rgb[SIZE * 3];
    static pel_color color[SIZE];
    int width = 0, height = 0;
    FILE *file = fopen(path, "rb");
    if (!file || fscanf(file, "P6 %d %d 255", &width, &height) != 2 ||
        width != SIZE || height != SIZE || getc(file) != '\n')
        return -1;
    for (int y = 0; y < SIZE; y++) {
        if (fread(rgb, 3, SIZE, file) != SIZE)
            return -1;
        surface->format->load(surface, 0, y, SIZE, color);
        for (int x = 0; x < SIZE; x++)
            wrong += abs((int)pel_red(color[x]) - rgb[3 * x]) > 9 ||
                     abs((int)pel_green(color[x]) - rgb[3 * x + 1]) > 5 ||
                     abs((int)pel_blue(color[x]) - rgb[3 * x + 2]) > 9;
    }
    fclose(file);
    return wrong;
}

int main(int argc, char **argv)
{
    struct pel_surface surface;
    if (argc != 3 || pel_mesh_asset_check(&asset) != PEL_OK ||
        pel_surface_init(&surface, &pel_rgb565_le, memory, SIZE, SIZE) !=
            PEL_OK ||
        !draw_all(&surface, strcmp(argv[2], "flat") == 0)) {
        fprintf(stderr, "the asset or the surface is refused\n");
        return 1;
    }
    long wrong = count_wrong(&surface, argv[1]);
    printf("%s %s: %ld of %d pixels differ\n", argv[1], argv[2], wrong,
           SIZE * SIZE);
    return wrong < 0 || wrong * 1000000 / (SIZE * SIZE) > WRONG_PPM;
}
