/* Textures that the colours of vertices multiply, as glTF has it: light times
 * light, which is linear over a triangle. */
#include "sim/render/scene.h"

#include <stddef.h>

#include "core/scene/select.h"
#include "core/scene/shading.h"
#include "core/scene/work.h"

enum { LEVELS = 65536 }; /* of light: 0 to 1 */

/* The light of a byte, and the byte that shows it. */
static uint16_t light_of[256];
static uint8_t byte_of[LEVELS];

struct colored {
    struct pel_color_paint base;
    const struct pel_color_paint *texture;
    struct pel_plane light[3]; /* of blue, green, red */

    /* What shines is added, mapped as the texture is; or NULL. */
    const struct pel_color_paint *shining;
    struct pel_texture glow;
    struct pel_divided_texture perspective;
};

/* Light of a texel times `light`, plus that of another, as a byte. */
static uint32_t mixed(uint32_t texel, int32_t light, uint32_t glow)
{
    const uint32_t factor = (uint32_t)pel_max(0, pel_min(light, LEVELS - 1));
    const uint32_t product = light_of[texel & 255] * factor;
    const uint32_t sum =
        (product + LEVELS / 2) / (LEVELS - 1) + light_of[glow & 255];
    return byte_of[sum < LEVELS ? sum : LEVELS - 1];
}

enum { PIXELS = 64 };

static void take(const struct colored *p, const struct pel_span *row, int32_t y,
                 pel_color *out)
{
    const int32_t n = row->x1 - row->x0;
    pel_color glow[PIXELS] = {0};
    uint64_t at[3];
    for (int k = 0; k < 3; k++)
        at[k] = pel_plane_at(&p->light[k], row->x0, y);
    p->texture->colors(p->texture, row->x0, y, n, out);
    if (p->shining)
        p->shining->colors(p->shining, row->x0, y, n, glow);
    for (int32_t i = 0; i < n; i++) {
        pel_color color = out[i] & UINT32_C(0xFF000000);
        for (int k = 0; k < 3; k++) {
            color |= (pel_color)mixed(out[i] >> 8 * k, pel_plane_whole(at[k]),
                                      glow[i] >> 8 * k)
                     << 8 * k;
            at[k] += p->light[k].dx;
        }
        out[i] = color;
    }
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct colored *p = (const void *)paint;
    for (int32_t end = x + n, k; x < end; x += k, out += k) {
        k = pel_min(end - x, PIXELS);
        take(p, &(struct pel_span){x, x + k}, y, out);
    }
}

/* What shines in the texture of the part at hand. */
static const struct pel_color_paint *shining(
    const struct pel_frame *frame, const struct pel_color_paint *texture,
    struct colored *p)
{
    const struct scene *scene = (const void *)((const char *)frame->scene -
                                               offsetof(struct scene, core));
    const pel_color *glow =
        scene->model->texture[frame->mesh_texture - scene->texture].glow.pixels;
    if (!glow)
        return NULL;
    p->glow = frame->work->texture;
    p->glow.memory = (const uint8_t *)glow;
    if (texture == &frame->work->texture.base)
        return &p->glow.base;
    p->perspective = frame->work->perspective;
    p->perspective.by.inner = &p->glow.base;
    return &p->perspective.by.base;
}

/* Of the triangle that this thread draws. */
static const struct pel_color_paint *times_vertices(
    struct pel_frame *frame, const struct pel_color_paint *texture)
{
    static __thread struct colored paint;
    const uint8_t(*own)[3] = frame->scene->mesh->colors;
    const uint32_t *vertex = frame->work->triangle.vertex;
    if (!own)
        return texture;
    pel_color_paint_init(&paint.base, colors, texture->opaque);
    paint.texture = texture;
    paint.shining = shining(frame, texture, &paint);
    for (int k = 0; k < 3; k++) {
        int32_t light[3];
        for (int i = 0; i < 3; i++)
            light[i] = light_of[own[vertex[i]][2 - k]];
        pel_frame_plane(frame, light, &paint.light[k]);
    }
    return &paint.base;
}

static const struct pel_color_paint *affine(struct pel_frame *frame)
{
    return times_vertices(frame, pel_map_affine.surface(frame));
}

static const struct pel_color_paint *perspective(struct pel_frame *frame)
{
    return times_vertices(frame, pel_map_perspective.surface(frame));
}

static const struct pel_color_paint *chosen(struct pel_frame *frame)
{
    return times_vertices(frame, pel_map_chosen.surface(frame));
}

static const struct {
    const struct pel_mapping *plain;
    const struct pel_color_paint *(*surface)(struct pel_frame *frame);
} kinds[] = {{&pel_map_affine, affine},
             {&pel_map_perspective, perspective},
             {&pel_map_chosen, chosen}};

const struct pel_mapping *scene_colored(const struct pel_mapping *plain)
{
    static struct pel_mapping made[3];
    for (unsigned i = 0; i < 256 && !light_of[255]; i++)
        light_of[i] = (uint16_t)(mesh_linear(i) * (LEVELS - 1) + 0.5);
    for (unsigned i = 0; i < LEVELS && !byte_of[LEVELS - 1]; i++)
        byte_of[i] = (uint8_t)mesh_byte(i / (LEVELS - 1.0));
    for (int i = 0; i < 3; i++) {
        made[i] = *kinds[i].plain;
        made[i].surface = kinds[i].surface;
        if (plain == kinds[i].plain)
            return &made[i];
    }
    return plain;
}
