/* The lines of docs/guide.md that send what a hand has left and where it is. */
#include <pel/pel.h>
#include "drivers/dirty.h"

static uint16_t band[2][240 * 8];
static int32_t sent; /* px */

static void draw(void *context, const struct pel_surface *screen)
{
    (void)context;
    pel_clear(screen, PEL_RGB(0, 0, 0));
}

static enum pel_status flush(const struct pel_display *display,
                             const struct pel_surface *s)
{
    (void)display;
    sent += (s->clip.x1 - s->clip.x0) * (s->clip.y1 - s->clip.y0);
    return PEL_OK;
}

int main(void)
{
    static const struct pel_rect where_the_hand_was = {120, 20, 130, 120};
    static const struct pel_rect where_it_is = {140, 150, 200, 160};
    static const struct pel_display display = {
        .width = 240, .height = 240, .format = &pel_rgb565_be, .flush = flush};
    struct pel_dirty_areas dirty = {.window = 64};
#include "dirty.inc"
    return sent != 10 * 100 + 60 * 10;
}
