#include "display_linux_paper.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <pel/pel.h>

#include "epaper_chip.h"

/* With the glass of usual modules. */
static const struct model {
    const char *name;
    uint16_t width, height;
    const struct pel_epaper_chip *chip;
    const struct pel_format *format;
} models[] = {
    {"ssd1680", 122, 250, &pel_epaper_ssd1680, &pel_mono1},
    {"ssd1680_inks2", 122, 250, &pel_epaper_ssd1680, &pel_inks2},
    {"ssd1680_gray2", 122, 250, &pel_epaper_ssd1680_gray2, &pel_gray2},
    {"ssd1681", 200, 200, &pel_epaper_ssd1681, &pel_mono1},
    {"ssd1681_inks2", 200, 200, &pel_epaper_ssd1681, &pel_inks2},
    {"il3897", 122, 250, &pel_epaper_il3897, &pel_mono1},
    {"uc8151", 128, 296, &pel_epaper_uc8151, &pel_mono1},
    {"uc8151_inks2", 128, 296, &pel_epaper_uc8151, &pel_inks2},
    {"uc8151_gray2", 128, 296, &pel_epaper_uc8151_gray2, &pel_gray2},
    {"uc8179", 800, 480, &pel_epaper_uc8179, &pel_mono1},
    {"uc8179_inks2", 800, 480, &pel_epaper_uc8179, &pel_inks2},
    {"uc8179_gray2", 800, 480, &pel_epaper_uc8179_gray2, &pel_gray2},
};
enum { MODELS = sizeof models / sizeof *models };

void pel_display_paper_names(char *text, size_t size)
{
    size_t n = strlen(text);
    for (int i = 0; i < MODELS && n + strlen(models[i].name) + 3 < size; i++) {
        strcpy(text + n, ", ");
        strcpy(text + n + 2, models[i].name);
        n += strlen(text + n);
    }
}

bool pel_display_paper_find(struct pel_display_panel *panel,
                            const struct pel_panel_request *r)
{
    int i = 0;
    while (i < MODELS && strcmp(models[i].name, r->chip) != 0)
        i++;
    if (i == MODELS)
        return false;
    panel->paper = (struct pel_epaper){
        .chip = models[i].chip,
        .format = models[i].format,
        .width = r->width < 0 ? models[i].width : (uint16_t)r->width,
        .height = r->width < 0 ? models[i].height : (uint16_t)r->height,
        .rotation = (uint8_t)(r->rotation / 90)};
    if (panel->paper.chip == &pel_epaper_uc8151_gray2)
        panel->paper.waveform = pel_epaper_uc8151_grays;
    return true;
}

/* For all but a full refresh. */
static bool needs_waveform(const struct pel_epaper_chip *chip)
{
    return chip == &pel_epaper_il3897 || chip == &pel_epaper_uc8151;
}

int pel_display_paper_open(struct pel_display_panel *panel,
                           const struct pel_panel_request *r,
                           struct pel_message *message)
{
    if (!r->busy)
        return pel_message_set(message, EINVAL,
                               "panel: '%.60s': expected busy=LINE: e-paper "
                               "has a line BUSY",
                               r->chip);
    if (r->left >= 0 || r->brightness >= 0 || r->inverted || r->swapped)
        return pel_message_set(message, EINVAL,
                               "panel: offset, brightness, inverted and "
                               "swapped are not for e-paper");
    if (r->partial && panel->paper.format->bits > 1)
        return pel_message_set(message, EINVAL,
                               "panel: partial is for black and white");
    if (r->partial && needs_waveform(panel->paper.chip))
        return pel_message_set(message, EINVAL,
                               "panel: partial: the chip '%.60s' needs its "
                               "maker's waveform for that",
                               r->chip);
    return pel_bus_line_open(&panel->busy, r->busy, PEL_GPIO_FLOATING, message);
}

static enum pel_status pause_fails(const struct pel_bus *bus, bool reset,
                                   uint32_t ms)
{
    (void)bus, (void)reset, (void)ms;
    return PEL_ERROR_DEVICE;
}

/* A line that cannot be read any more is not waited for: the next pause ends
 * that, and nothing is sent to a chip that may be busy. */
static bool is_high(const struct pel_epaper *paper)
{
    struct pel_display_panel *const panel =
        (void *)((uintptr_t)paper - offsetof(struct pel_display_panel, paper));
    uint32_t low = 0;
    const int error = pel_gpio_levels(&panel->busy, &low);
    if (!error)
        return !(low & 1);
    pel_message_set(panel->bus.message, error, "the line BUSY at %s: %s",
                    panel->busy.path, strerror(error));
    panel->bus.bus.pause = pause_fails;
    return paper->chip->busy;
}

/* The bus has said what it could not do. */
static enum pel_status told(struct pel_display_panel *panel,
                            enum pel_status status)
{
    if (status == PEL_ERROR_DEVICE && !panel->bus.message->text[0])
        pel_message_set(panel->bus.message, EIO,
                        "the panel is busy for a minute: is busy= its line?");
    return status;
}

static enum pel_status paper_flush(const struct pel_display *display,
                                   const struct pel_surface *surface)
{
    struct pel_display_panel *panel = display->context;
    return told(panel, pel_display_flush(&panel->paper_display, surface));
}

static enum pel_status paper_flip(const struct pel_display *display)
{
    struct pel_display_panel *panel = display->context;
    const enum pel_status status =
        told(panel, pel_display_flip(&panel->paper_display));
    if (status == PEL_OK && panel->partial)
        panel->paper.refresh = PEL_EPAPER_PARTIAL;
    return status;
}

enum pel_status pel_display_paper_init(struct pel_display *display,
                                       struct pel_display_panel *panel)
{
    struct pel_epaper *const paper = &panel->paper;
    const size_t plane = (size_t)PEL_EPAPER_FRAME(paper->width, paper->height);
    paper->bus = &panel->bus.bus;
    paper->busy = is_high;
    paper->frame = calloc(2, plane + 1);
    if (!paper->frame) {
        pel_message_set(panel->bus.message, ENOMEM, "no memory for a frame");
        return PEL_ERROR_DEVICE;
    }
    const enum pel_status status =
        told(panel, pel_epaper_init(&panel->paper_display, paper));
    *display = panel->paper_display;
    display->context = panel;
    display->flush = paper_flush;
    display->flip = paper_flip;
    return status;
}

/* A refresh that goes on ends before. */
void pel_display_paper_close(struct pel_display_panel *panel)
{
    if (panel->told)
        pel_epaper_sleep(&panel->paper);
    free(panel->paper.frame);
    panel->paper.frame = NULL;
    pel_gpio_close(&panel->busy);
}
