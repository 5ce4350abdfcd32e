/* A watch on a round panel of 240 x 240 pixels (GC9A01), in two bands of 20
 * lines; each second only what moved is drawn and sent. */
#include "drivers/dirty.h"
#include "digits_20.h"
#include "panel.h"

static uint16_t band[2][240 * 20];
static int now = 10 * 3600 + 8 * 60 + 18; /* seconds of the day */

static const struct pel_point center = PEL_AT(120, 120);

/* Where a hand or a mark points: 0 at twelve, `steps` around. */
static int32_t turn_of(int step, int steps)
{
    return step * 65536 / steps - PEL_DEGREES(90);
}

static void draw_ticks(const struct pel_surface *screen)
{
    static const struct pel_flat minute = PEL_FLAT(PEL_RGB(110, 120, 135));
    static const struct pel_flat hour = PEL_FLAT(PEL_RGB(240, 240, 235));
    for (int i = 0; i < 60; i++) {
        const bool at_hour = i % 5 == 0;
        const int32_t turn = turn_of(i, 60);
        const struct pel_thick_line_shape tick = {
            pel_polar(center, PEL_PX(at_hour ? 88 : 97), turn),
            pel_polar(center, PEL_PX(102), turn),
            at_hour ? PEL_PX(4) : PEL_PX(1.5)};
        pel_smooth_thick_line(screen, &tick,
                              at_hour ? &hour.paint : &minute.paint);
    }
}

/* A hand is a quad that gets narrower, behind the centre a little shorter. */
static void draw_hand(const struct pel_surface *screen, int32_t turn,
                      int length, int width, const struct pel_paint *paint)
{
    struct pel_point v[4] = {
        {center.x - PEL_PX(18), center.y + PEL_PX(width) / 2},
        {center.x + PEL_PX(length), center.y + PEL_PX(1)},
        {center.x + PEL_PX(length), center.y - PEL_PX(1)},
        {center.x - PEL_PX(18), center.y - PEL_PX(width) / 2}};
    for (int i = 0; i < 4; i++)
        v[i] = pel_turned(v[i], center, turn);
    pel_smooth_convex(screen, v, 4, paint);
}

/* The ring, as far as the seconds have come. */
static void draw_ring(const struct pel_surface *screen, int from, int to,
                      const struct pel_paint *paint)
{
    const struct pel_arc_shape ring = {center, PEL_PX(110), PEL_PX(116),
                                       turn_of(from, 60), turn_of(to, 60)};
    pel_smooth_arc_round(screen, &ring, paint);
}

static void draw(void *context, const struct pel_surface *screen)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(240, 240, 235));
    static const struct pel_flat track = PEL_FLAT(PEL_RGB(34, 38, 48));
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 82, 60));
    static const struct pel_ring_shape ring = {PEL_AT(120, 120), PEL_PX(110),
                                               PEL_PX(116)};
    static const struct pel_rounded_shape window = {
        PEL_AT(152, 109), PEL_AT(186, 131), PEL_PX(4)};
    static const struct pel_text_block date = {&digits_20, "26", 158, 110};
    (void)context;
    pel_clear(screen, PEL_RGB(8, 10, 16));
    pel_smooth_ring(screen, &ring, &track.paint);
    draw_ticks(screen);
    pel_smooth_rounded_rectangle(screen, &window, &track.paint);
    pel_text(screen, &date, &white.paint);
    draw_hand(screen, turn_of(now / 60, 720), 58, 12, &white.paint);
    draw_hand(screen, turn_of(now / 60 % 60, 60), 86, 8, &white.paint);
    draw_ring(screen, 0, now % 60, &red.paint);
    draw_hand(screen, turn_of(now % 60, 60), 96, 3, &red.paint);
    pel_smooth_circle(screen, center, PEL_PX(7), &red.paint);
    pel_smooth_circle(screen, center, PEL_PX(2.5), &track.paint);
}

/* Where the second hand and the end of the ring are is dirty: called before a
 * second is over, and after it. */
static void add_seconds(struct pel_dirty_areas *dirty)
{
    static const struct pel_surface no_pixels = PEL_NO_PIXELS(240, 240);
    struct pel_dirty hand;
    pel_dirty_begin(&hand, NULL);
    draw_hand(&no_pixels, turn_of(now % 60, 60), 96, 3, &hand.paint);
    pel_dirty_areas_add(dirty, &hand.box);
    pel_dirty_begin(&hand, NULL);
    draw_ring(&no_pixels, now % 60 - 1, now % 60, &hand.paint);
    pel_dirty_areas_add(dirty, &hand.box);
}

int main(void)
{
    static const struct pel_dirty_work work = {
        {band[0], band[1]}, sizeof band[0], draw, NULL};
    static const struct pel_rect all = {0, 0, 240, 240};
    struct pel_dirty_areas dirty = {.window = 200};
    struct pel_display panel;
    enum pel_status status = panel_open(&panel, 240, 240, &pel_rgb565_be);
    pel_dirty_areas_add(&dirty, &all);
    for (int i = 0; i < 20 && status == PEL_OK; i++) {
        status = pel_dirty_areas_show(&dirty, &panel, &work);
        add_seconds(&dirty);
        now++;
        add_seconds(&dirty);
        if (now % 60 == 0)
            pel_dirty_areas_add(&dirty, &all);
    }
    panel_close();
    return status != PEL_OK;
}
