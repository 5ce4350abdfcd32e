/* The earth on a round panel of 240 x 240 pixels (GC9A01): a mesh of 440
 * triangles with a texture, turning in the light of the sun, in 20 KB of RAM
 * with its stack. Light, camera and pose are told where they are set. */
#include "drivers/dirty.h"
#include "earth.h"
#include "panel.h"
#include "sphere.h"

enum { SIDE = 240, LINES = 16, VERTICES = 271, TRIANGLES = 440 };

static uint16_t band[SIDE * LINES];

/* Memory of one picture: a place for every vertex, the order of triangles. */
static uint64_t scratch[PEL_SCENE_SCRATCH_SIZE(VERTICES, TRIANGLES, 1) / 8 + 1];

/* The sun, far away: all its light comes from one direction, from the right,
 * above and before the earth; it is a little yellow. */
static const struct pel_light sun = {
    .at = {5, 2, 4},
    .directional = true,
    .color = {PEL_FACTOR(100), PEL_FACTOR(98), PEL_FACTOR(92)}};

/* What the surface makes of it: 8 % are seen at night, the rest is as bright as
 * the sun is high; nothing shines like a mirror. */
static const struct pel_lighting lighting = {
    .light = &sun,
    .lights = 1,
    .ambient_color = {PEL_FACTOR(100), PEL_FACTOR(100), PEL_FACTOR(140)},
    .ambient = PEL_FACTOR(8),
    .diffuse = PEL_FACTOR(115),
    .shininess = 1};

static struct pel_mesh mesh;
static struct pel_surface map;          /* the picture in flash */
static struct pel_mesh_texture texture; /* and how it lies on the mesh */
static struct pel_pose pose;
static struct pel_frame frame;
static struct pel_linear air; /* a blue that is seen through, to the right */

/* The camera is 5 units before the middle of the earth, whose radius is 1, and
 * looks at it; y is up. Lens and sensor are in any unit: the sensor sees
 * 24 / 50 of a distance, so that the earth is 208 pixels wide. */
static const struct pel_scene scene = {
    .mesh = &mesh,
    .pose = &pose,
    .camera = {.eye = {0, 0, PEL_UNITS(5)},
               .target = {0, 0, 0},
               .up = {0, 1, 0},
               .focal = 5080,
               .sensor = {2400, 2400},
               .near_plane = PEL_UNITS(1)},
    .viewport = {0, 0, SIDE, SIDE},
    .shading = &pel_shade_lit_gouraud, /* light at the vertices */
    .lighting = &lighting,
    .texture = &texture,
    .cull = PEL_CULL_BACK, /* of a closed mesh nobody sees the far side: then */
    .sort = NULL};         /* no triangle hides another one */

/* The pose: first the earth turns around its own axis, y, then the axis leans
 * to the right by 23.4 degrees, around z. The last matrix is done first. */
static void set_pose(int32_t turn)
{
    struct pel_matrix spin, lean;
    pel_matrix_turn(&spin, 1, (uint16_t)turn);
    pel_matrix_turn(&lean, 2, (uint16_t)PEL_DEGREES(-23.4));
    pel_matrix_multiply(&pose.turn, &lean, &spin);
}

static enum pel_status set_up(void)
{
    static const struct pel_mesh_image picture = {&earth, PEL_WRAP_REPEAT,
                                                  PEL_WRAP_CLAMP, false};
    static const pel_color blues[2] = {PEL_RGBA(110, 170, 255, 10),
                                       PEL_RGBA(150, 205, 255, 170)};
    static const struct pel_ramp ramp = {blues, 2, PEL_PAD};
    enum pel_status status =
        pel_linear_init(&air, pel_at(60, 0), pel_at(220, 0), &ramp);
    if (status == PEL_OK)
        status = pel_mesh_asset_check(&sphere);
    if (status == PEL_OK)
        status =
            pel_mesh_texture_of_image(&texture, &map, &picture, &pel_rgb565_le);
    texture.mapping = &pel_map_affine; /* straight on every triangle */
    texture.sampler = pel_texture_init_bilinear; /* four texels are mixed */
    pel_mesh_of_asset(&mesh, &sphere);
    return status;
}

/* Triangles have whole pixels: a ring in the color of the sky covers their rim,
 * and makes it smooth; over it lies the air. */
static void draw(void *context, const struct pel_surface *screen)
{
    static const struct pel_flat sky = PEL_FLAT(PEL_RGB(6, 8, 16));
    static const struct pel_ring_shape rim = {PEL_AT(120, 120), PEL_PX(101.5),
                                              PEL_PX(110)};
    static const struct pel_ring_shape haze = {PEL_AT(120, 120), PEL_PX(99),
                                               PEL_PX(104)};
    (void)context;
    pel_clear(screen, sky.color);
    pel_scene_draw(&frame, screen);
    pel_smooth_ring(screen, &rim, &sky.paint);
    pel_smooth_ring(screen, &haze, &air.base.paint);
}

int main(void)
{
    static const struct pel_dirty_work work = {
        {band, NULL}, sizeof band, draw, NULL};
    static const struct pel_rect globe = {16, 16, 224, 224};
    struct pel_dirty_areas dirty = {200, 1, {{0, 0, SIDE, SIDE}}};
    struct pel_display panel;
    enum pel_status status = panel_open(&panel, SIDE, SIDE, &pel_rgb565_be);
    if (status == PEL_OK)
        status = set_up();
    for (int i = 0; i < 12 && status == PEL_OK; i++) {
        set_pose(PEL_DEGREES(3 * i - 48));
        status = pel_scene_prepare(&frame, &scene, scratch, sizeof scratch);
        if (status == PEL_OK)
            status = pel_dirty_areas_show(&dirty, &panel, &work);
        pel_dirty_areas_add(&dirty, &globe);
    }
    panel_close();
    return status != PEL_OK;
}
