#include "sim/render/scene.h"

#include <stdlib.h>

#include "sim/cli/message.h"
#include "core/scene/perspective.h"
#include "core/scene/work.h"

/* Measured (docs/MEASUREMENTS.md): with fewer pixels to a triangle the proof
 * takes longer than depths; a step of it takes as long as 16 pixels. */
enum { PIXELS_PER_TRIANGLE = 2048, PIXELS_PER_STEP = 16 };

static int64_t pixels_of(const struct pel_rect *r)
{
    return pel_rect_empty(r) ? 0 : (int64_t)(r->x1 - r->x0) * (r->y1 - r->y0);
}

void scene_set_order(struct scene *scene, const struct scene_settings *s)
{
    scene->depth_bits = s->order == SCENE_PAINTER     ? 0
                        : s->order == SCENE_ZBUFFER16 ? 16
                                                      : 32;
    /* The painter draws what is hidden later too: that is cheap for flat and
     * Gouraud alone. */
    scene->is_proven =
        s->order == SCENE_AUTO && !scene->core.sort &&
        s->shade != SCENE_PHONG &&
        (!scene->core.texture || s->mapping == SCENE_MAP_VERTICES) &&
        scene->mesh.triangles <=
            pixels_of(&scene->core.viewport) / PIXELS_PER_TRIANGLE;
    if (s->order == SCENE_PAINTER || scene->is_proven)
        scene->core.sort = &pel_depth_sort_radix;
}

/* Examines the painter's order of the frame; false when memory is short. */
static bool certify(const struct scene *scene, uint32_t work,
                    struct pel_doubt *doubt)
{
    const size_t size = PEL_CERTIFICATE_SCRATCH_SIZE(scene->frame.triangles);
    void *scratch = malloc(size);
    const bool done = scratch && pel_scene_certify(&scene->frame, scratch, size,
                                                   work, doubt) == PEL_OK;
    free(scratch);
    return done;
}

void scene_prove_order(struct scene *scene)
{
    const int64_t pixels = pixels_of(&scene->core.viewport);
    if (!scene->is_proven)
        return;
    scene->is_proven =
        !scene->frame.translucent &&
        certify(scene, (uint32_t)(pixels / PIXELS_PER_STEP), &scene->doubt) &&
        pixels_of(&scene->doubt.bounds) <= pixels / 2;
    if (!scene->is_proven) { /* as if it had not been sorted */
        scene->frame.order = NULL;
        scene->frame.triangles = scene->mesh.triangles;
    }
}

/* Vertices and order are only read; the rest is this call's own. */
bool scene_draw(const struct scene *scene, const struct pel_surface *surface)
{
    struct pel_frame frame = scene->frame;
    struct {
        struct pel_frame_work of_all;
        uint64_t in_world[PEL_PERSPECTIVE_SCRATCH_SIZE / 8];
    } work = {.of_all = *frame.work};
    const struct pel_rect *part =
        scene->is_proven ? &scene->doubt.bounds : &scene->core.viewport;
    const struct pel_rect bounds = pel_rect_intersect(&surface->clip, part);
    const int bits = scene->depth_bits;
    const size_t size = bits > 0 ? pel_depth_size(&bounds, bits) : 0;
    struct pel_depth depth = {0};
    void *memory = size > 0 ? malloc(size) : NULL;
    frame.work = &work.of_all;
    if (size > 0 && (!memory || pel_depth_init(&depth, &bounds, bits, memory,
                                               size) != PEL_OK)) {
        free(memory);
        return message_error("no memory for a depth buffer of %zu bytes", size);
    }
    if (bits == 0)
        pel_scene_draw(&frame, surface);
    else if (scene->is_proven)
        pel_scene_draw_certified(&frame, surface, part, &depth);
    else if (size > 0)
        pel_scene_draw_depth(&frame, surface, &depth);
    free(memory);
    return true;
}

void scene_print_order(FILE *out, const struct scene *scene)
{
    const struct pel_rect *part = &scene->doubt.bounds;
    struct pel_doubt doubt;
    if (scene->is_proven)
        fprintf(out, "painter's order, proven but for %dx%d px with depths\n",
                (int)(part->x1 - part->x0), (int)(part->y1 - part->y0));
    else if (scene->depth_bits > 0)
        fprintf(out, "depths of %d bits\n", scene->depth_bits);
    else if (!scene->frame.translucent && certify(scene, UINT32_MAX, &doubt))
        fprintf(out,
                "painter's order: at most %lu pixels are wrong, of %lu "
                "triangles\n",
                (unsigned long)doubt.pixels, (unsigned long)doubt.triangles);
}
