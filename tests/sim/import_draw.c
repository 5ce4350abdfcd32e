/* A firmware's way with a mesh asset, built with each asset by
 * test_asset_import.sh: draws it with core/scene in RGB565, and compares with
 * the picture that pel render drew of the mesh file, with the same numbers:
 * they are equal.
 *
 *     import_draw EXPECTED.ppm flat|gouraud|phong|measured [STEPS]
 *
 * measured: with the shading and the mappings of pel import --view, to a number
 * of steps of 255 that a channel may differ by. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/pel.h"
#include "core/scene/pipeline.h"

extern const struct pel_mesh_asset asset;
#ifdef MEASURED
extern const struct pel_shading *const asset_shading;
extern const struct pel_mapping *const asset_mapping[];
extern const uint8_t asset_span[];
#endif

enum { SIZE = 600 };

/* The camera and the light of test_asset_import.sh: of --print-camera, or of
 * the same numbers. */
#ifdef CAMERA
static const struct pel_camera camera =
#include CAMERA
    ;
#else
static const double eye[3] = {EYE}, target[3] = {TARGET};

static void set_camera(struct pel_camera *camera)
{
    *camera = (struct pel_camera){.up = {0, 1, 0},
                                  .focal = 50000,
                                  .sensor = {36000, 36000},
                                  .near_plane = PEL_UNITS(1) / 8};
    for (int k = 0; k < 3; k++) {
        camera->eye[k] = (pel_length)(eye[k] * 65536);
        camera->target[k] = (pel_length)(target[k] * 65536);
    }
}
#endif

static const struct pel_light sun = {
    .at = {1, 2, 3}, .directional = true, .color = {65536, 65536, 65536}};
static const struct pel_lighting lighting = {
    .light = &sun,
    .lights = 1,
    .ambient_color = {65536, 65536, 65536},
    .ambient = 19661, /* 0.3, 0.7 and 0.3 */
    .diffuse = 45875,
    .specular = 19661,
    .shininess = 20};

static uint16_t memory[SIZE * SIZE];

/* The textures of the asset, in RGB565. */
static bool set_textures(struct pel_scene *scene)
{
    enum { MOST = 8 };
    static struct pel_mesh_texture texture[MOST];
    static struct pel_surface surface[MOST];
    scene->texture = asset.images ? texture : NULL;
    scene->textures = asset.images;
    for (uint32_t i = 0; i < asset.images; i++) {
#ifdef MEASURED
        texture[i].mapping = asset_mapping[i];
        texture[i].span = asset_span[i];
#else
        texture[i].mapping = &pel_map_affine;
#endif
        texture[i].sampler = pel_texture_init_nearest;
        if (i == MOST ||
            pel_mesh_texture_of_image(&texture[i], &surface[i], &asset.image[i],
                                      &pel_rgb565_le) != PEL_OK)
            return false;
    }
    return true;
}

static void set_scene(struct pel_scene *scene, struct pel_mesh *mesh,
                      const char *shade)
{
    if (!set_textures(scene)) {
        fprintf(stderr, "a texture is refused\n");
        exit(1);
    }
    pel_mesh_of_asset(mesh, &asset);
    scene->mesh = mesh;
    scene->lighting = &lighting;
    scene->color = PEL_RGB(0xa0, 0xb4, 0xc8);
    scene->sort = &pel_depth_sort;
    scene->viewport = (struct pel_rect){0, 0, SIZE, SIZE};
#ifdef CAMERA
    scene->camera = camera;
#else
    set_camera(&scene->camera);
#endif
    scene->shading = shade[0] == 'f'   ? &pel_shade_flat
                     : shade[0] == 'g' ? &pel_shade_gouraud
                                       : &pel_shade_phong;
#ifdef MEASURED
    scene->shading = asset_shading;
#endif
    if (shade[0] == 'p') {
        mesh->colors = NULL;
        mesh->parts = 0;
        scene->texture = NULL;
    }
}

static enum pel_status draw(const struct pel_surface *surface,
                            const char *shade)
{
    struct pel_mesh mesh;
    struct pel_scene scene = {.mesh = NULL};
    struct pel_frame frame;
    set_scene(&scene, &mesh, shade);
    const size_t size = pel_scene_scratch_size(&scene);
    void *scratch = malloc(size);
    const enum pel_status status =
        pel_scene_prepare(&frame, &scene, scratch, size);
    pel_clear(surface, PEL_RGB(255, 255, 255));
    if (status == PEL_OK)
        pel_scene_draw(&frame, surface);
    free(scratch);
    return status;
}

/* Channels of pixels that differ by more than `steps`, or -1. */
static long count_wrong(const struct pel_surface *surface, const char *path,
                        int steps)
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
            for (int k = 0; k < 3; k++)
                wrong += abs((int)(color[x] >> (16 - 8 * k) & 255) -
                             rgb[3 * x + k]) > steps;
    }
    fclose(file);
    return wrong;
}

/* What the asset's check must refuse, where it has parts and textures. */
static bool check_passes(void)
{
    struct pel_mesh_asset other = asset;
    struct pel_mesh_part part[8];
    if (asset.parts == 0 || asset.parts > 8)
        return true;
    memcpy(part, asset.part, asset.parts * sizeof *part);
    other.part = part;
    part[asset.parts - 1].triangles++;
    bool right = pel_mesh_asset_check(&other) == PEL_ERROR_SIZE;
    part[asset.parts - 1].triangles--;
    part[0].texture = asset.images + 1;
    right = right &&
            (!asset.images || pel_mesh_asset_check(&other) == PEL_ERROR_SIZE);
    other.part = NULL;
    right = right && pel_mesh_asset_check(&other) == PEL_ERROR_NULL;
    other = asset;
    other.version--;
    return right && pel_mesh_asset_check(&other) == PEL_ERROR_RANGE;
}

int main(int argc, char **argv)
{
    struct pel_surface surface;
    if (argc < 3 || pel_mesh_asset_check(&asset) != PEL_OK || !check_passes() ||
        pel_surface_init(&surface, &pel_rgb565_le, memory, sizeof memory,
                         &(struct pel_rect){0, 0, SIZE, SIZE}) != PEL_OK ||
        draw(&surface, argv[2]) != PEL_OK) {
        fprintf(stderr, "the asset or the surface is refused\n");
        return 1;
    }
    long wrong = count_wrong(&surface, argv[1], argc > 3 ? atoi(argv[3]) : 0);
    printf("%s %s: %ld channels of %d pixels differ\n", argv[1], argv[2], wrong,
           SIZE * SIZE);
    return wrong != 0;
}
