/* A mesh in 3-D, flat, with a certificate of the painter's order; where that is
 * in doubt, with depths for eight rows at a time. */
#include "core/scene/certificate.h"

#include "scene.h"

enum { ROWS = 8 };

static const struct pel_mesh mesh = SCENE_MESH(scene_uv);

static int draw_rows(struct pel_frame *frame, const struct pel_doubt *doubt,
                     int32_t y)
{
    static uint32_t depths[SCREEN_SIDE * ROWS];
    struct pel_surface band = SCREEN(pel_rgb565_le);
    struct pel_depth depth;
    band.clip.y0 = y;
    band.clip.y1 = y + ROWS;
    const struct pel_rect part = pel_rect_intersect(&band.clip, &doubt->bounds);
    const int status =
        pel_rect_empty(&part)
            ? PEL_OK
            : pel_depth_init(&depth, &part, 32, depths, sizeof depths);
    if (status == PEL_OK)
        pel_scene_draw_certified(frame, &band, &doubt->bounds, &depth);
    return status;
}

int main(void)
{
    static const struct pel_scene scene = SCENE(mesh, pel_shade_flat);
    static uint64_t scratch[250];
    static uint32_t proof[PEL_CERTIFICATE_SCRATCH_SIZE(4) / 4];
    static struct pel_frame frame;
    struct pel_doubt doubt;
    int status = pel_scene_prepare(&frame, &scene, scratch, sizeof scratch);
    if (status == PEL_OK)
        status = pel_scene_certify(&frame, proof, sizeof proof, 10000, &doubt);
    for (int32_t y = 0; y < SCREEN_SIDE && status == PEL_OK; y += ROWS)
        status = draw_rows(&frame, &doubt, y);
    return status;
}
