/* A field of tiles that scrolls below twenty sprites and one that turns and
 * grows, on 240 x 240 pixels in two bands of 20 lines. Tiles are drawn with Pel
 * once, into 16 x 16 pixels each; the sprite is a picture of letters. */
#include "drivers/dirty.h"
#include "panel.h"

enum { TILE = 16, TILES = 4, SPRITES = 20, FRAMES = 30 };

static uint16_t band[2][240 * 20];
static uint16_t tile_memory[TILES][TILE * TILE];
static uint32_t bug_memory[TILE * TILE];
static struct pel_surface tile[TILES], bug;
static int frame;

/* A ladybird, seen from above. */
static const char art[TILE][TILE + 1] = {
    "................", "....k......k....", ".....k....k.....",
    "......kkkk......", ".....kwkkwk.....", "....kkkkkkkk....",
    "...rrrrkkrrrr...", "..rrkrrrrrrkrr..", "..rrrrrrkrrrrr..",
    ".rrrrkrrkrrkrrr.", ".rrrrrrrkrrrrrr.", "..rkrrrrkrrrrkr.",
    "..rrrrkrkrkrrr..", "...rrrrrkrrrrr..", "....rrrrkrrrr...",
    "......rrrr......"};

static void make_bug(void)
{
    for (int i = 0; i < TILE * TILE; i++)
        switch (art[i / TILE][i % TILE]) {
        case 'k':
            bug_memory[i] = PEL_RGB(30, 24, 24);
            break;
        case 'r':
            bug_memory[i] = PEL_RGB(226, 48, 36);
            break;
        case 'w':
            bug_memory[i] = PEL_RGB(255, 255, 255);
            break;
        default:
            bug_memory[i] = PEL_RGBA(0, 0, 0, 0);
        }
}

static enum pel_status set_surface(struct pel_surface *surface,
                                   const struct pel_format *format,
                                   void *memory, size_t size)
{
    static const struct pel_rect bounds = {0, 0, TILE, TILE};
    return pel_surface_init(surface, format, memory, size, &bounds);
}

/* Grass, flowers, sand, water. */
static void draw_tile(int kind)
{
    static const pel_color ground[TILES] = {
        PEL_RGB(96, 160, 72), PEL_RGB(96, 160, 72), PEL_RGB(222, 200, 140),
        PEL_RGB(64, 130, 200)};
    static const pel_color spots[TILES] = {
        PEL_RGB(78, 138, 60), PEL_RGB(250, 230, 120), PEL_RGB(200, 176, 116),
        PEL_RGB(120, 180, 230)};
    const struct pel_flat spot = PEL_FLAT(spots[kind]);
    pel_clear(&tile[kind], ground[kind]);
    for (int i = 0; i < 4; i++) {
        const struct pel_point center = {PEL_PX(i * 11 % 13) + PEL_PX(1.5),
                                         PEL_PX(i * 7 % 12) + PEL_PX(2.5)};
        pel_circle(&tile[kind], center, PEL_PX(i % 2) + 128, &spot.paint);
    }
}

/* Lakes with beaches, on meadows. */
static int kind_of(int x, int y)
{
    const int dx = x % 24 - 9, dy = y % 24 - 7, d = dx * dx + dy * dy;
    return d < 10 ? 3 : d < 21 ? 2 : (x * 7 + y * 13) % 5 == 0;
}

static void draw_field(const struct pel_surface *screen)
{
    const int shift = frame * 2;
    for (int y = screen->clip.y0 / TILE; y * TILE < screen->clip.y1; y++)
        for (int x = shift / TILE; x * TILE - shift < 240; x++) {
            const struct pel_surface *t = &tile[kind_of(x, y)];
            const struct pel_copy_part part = {t, t->bounds, x * TILE - shift,
                                               y * TILE};
            pel_copy(screen, &part);
        }
}

static void draw(void *context, const struct pel_surface *screen)
{
    struct pel_turned_picture big = {.texels = {&bug, NULL, 0, 0, false},
                                     .pivot = {PEL_PX(8), PEL_PX(8)},
                                     .at = PEL_AT(120, 120)};
    (void)context;
    draw_field(screen);
    for (int i = 0; i < SPRITES; i++) {
        const struct pel_point at = pel_polar(
            big.at, PEL_PX(72 + i % 2 * 28), i * 65536 / SPRITES - frame * 300);
        const struct pel_copy_part part = {
            &bug, bug.bounds, pel_pixel_of(at.x) - 8, pel_pixel_of(at.y) - 8};
        pel_copy_alpha(screen, &part, 255);
    }
    big.turn = PEL_DEGREES(20 + frame * 5);
    big.scale = 4 * PEL_SCALE_ONE + pel_direction((uint16_t)(frame * 2000)).x;
    pel_turned_picture_draw(screen, &big);
}

int main(void)
{
    static const struct pel_dirty_work work = {
        {band[0], band[1]}, sizeof band[0], draw, NULL};
    static const struct pel_rect all = {0, 0, 240, 240};
    struct pel_dirty_areas dirty = {.window = 200};
    struct pel_display panel;
    enum pel_status status =
        set_surface(&bug, &pel_argb8888, bug_memory, sizeof bug_memory);
    make_bug();
    for (int i = 0; i < TILES && status == PEL_OK; i++) {
        status = set_surface(&tile[i], &pel_rgb565_be, tile_memory[i],
                             sizeof tile_memory[i]);
        if (status == PEL_OK)
            draw_tile(i);
    }
    if (status == PEL_OK)
        status = panel_open(&panel, 240, 240, &pel_rgb565_be);
    for (frame = 0; frame < FRAMES && status == PEL_OK; frame++) {
        pel_dirty_areas_add(&dirty, &all);
        status = pel_dirty_areas_show(&dirty, &panel, &work);
    }
    panel_close();
    return status != PEL_OK;
}
