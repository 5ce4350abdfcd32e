/* A badge with e-paper of 296 x 128 pixels in 1 bit (SSD1680): the whole
 * picture is 4,736 bytes. A button turns to the next message, and only the
 * lines that it takes are drawn and sent: a partial refresh. */
#include "bold_30.h"
#include "drivers/dirty.h"
#include "mono_15.h"
#include "panel.h"
#include "portrait.h"

enum { WIDTH = 296, HEIGHT = 128 };

static uint8_t memory[WIDTH / 8 * HEIGHT];
static int page;

static const struct pel_flat black = PEL_FLAT(PEL_RGB(0, 0, 0));
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

/* The lines of text are broken at the width of the column. */
static const struct pel_text_column message[3] = {
    {{&mono_15, "Firmware, mostly at night. Ask me about triangles.", 116, 66},
     172,
     16,
     PEL_TEXT_LEFT},
    {{&mono_15,
      "Talk: \xE2\x80\x9CNo heap, no float, no fear\xE2\x80\x9D, "
      "Friday at 14:00, hall 2",
      116, 66},
     172,
     16,
     PEL_TEXT_LEFT},
    {{&mono_15, "Looking for: a logic analyser, a job in the north, good tea",
      116, 66},
     172,
     16,
     PEL_TEXT_LEFT}};

/* The picture is dithered already, by `pel import`. */
static void draw_portrait(const struct pel_surface *screen)
{
    struct pel_surface picture;
    if (pel_image_asset_surface(&picture, &portrait, &pel_mono1) == PEL_OK) {
        const struct pel_copy_part part = {&picture, picture.bounds, 8, 8};
        pel_copy(screen, &part);
    }
}

static void draw(void *context, const struct pel_surface *screen)
{
    static const struct pel_text_block name = {&bold_30, "Ada Krause", 115, 8};
    static const struct pel_text_block event = {&mono_15, "Embedded Days 2026",
                                                122, 41};
    static const struct pel_rect bar = {116, 40, 288, 60};
    (void)context;
    pel_clear(screen, white.color);
    draw_portrait(screen);
    pel_text(screen, &name, &black.paint);
    pel_box(screen, &bar, &black.paint);
    pel_text(screen, &event, &white.paint);
    pel_text_column_draw(screen, &message[page], &black.paint);
}

/* The box of a message. */
static void add_message(struct pel_dirty_areas *dirty)
{
    const struct pel_text_size size =
        pel_text_column_draw(NULL, &message[page], NULL);
    const struct pel_rect box = {116, 66, 116 + size.width, 66 + size.height};
    pel_dirty_areas_add(dirty, &box);
}

int main(void)
{
    static const struct pel_dirty_work work = {
        {memory, NULL}, sizeof memory, draw, NULL};
    struct pel_dirty_areas dirty = {400, 1, {{0, 0, WIDTH, HEIGHT}}};
    struct pel_display panel;
    enum pel_status status = panel_open(&panel, WIDTH, HEIGHT, &pel_mono1);
    for (int i = 0; i < 4 && status == PEL_OK; i++) {
        status = pel_dirty_areas_show(&dirty, &panel, &work);
        add_message(&dirty);
        page = (page + 1) % 3;
        add_message(&dirty);
    }
    panel_close();
    return status != PEL_OK;
}
