#include "display_linux_paper.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <pel/pel.h>

/* Chips by name; the glass of modules by size, where it does not begin at the
 * chip's first pixel. Without `turned` the chip takes colors. */
static const struct model {
    const char *name;
    int width, height, left, top;
    const struct pel_panel_chip *chip, *turned; /* by 90 and 270 degrees */
} models[] = {
    {"st7789", 240, 320, 0, 0, &pel_panel_st7789, NULL},
    {"st7789", 135, 240, 52, 40, &pel_panel_st7789, NULL},
    {"st7789", 170, 320, 35, 0, &pel_panel_st7789, NULL},
    {"st7789", 240, 280, 0, 20, &pel_panel_st7789, NULL},
    {"st7735", 128, 160, 2, 1, &pel_panel_st7735, NULL},
    {"st7735", 128, 128, 2, 3, &pel_panel_st7735_132x132, NULL},
    {"st7735", 80, 160, 26, 1, &pel_panel_st7735, NULL},
    {"st7735_128x160", 128, 160, 0, 0, &pel_panel_st7735_128x160, NULL},
    {"st7735_128x160", 80, 160, 24, 0, &pel_panel_st7735_128x160, NULL},
    {"st7796", 320, 480, 0, 0, &pel_panel_st7796, NULL},
    {"ili9341", 240, 320, 0, 0, &pel_panel_ili9341, NULL},
    {"ili9342", 320, 240, 0, 0, &pel_panel_ili9342, NULL},
    {"ili9488", 320, 480, 0, 0, &pel_panel_ili9488, NULL},
    {"gc9a01", 240, 240, 0, 0, &pel_panel_gc9a01, NULL},
    {"ssd1351", 128, 128, 0, 0, &pel_panel_ssd1351, NULL},
    {"ssd1306", 128, 64, 0, 0, &pel_panel_ssd1306, &pel_panel_ssd1306_turned},
    {"ssd1306", 128, 32, 0, 0, &pel_panel_ssd1306_32,
     &pel_panel_ssd1306_32_turned},
    {"ssd1309", 128, 64, 0, 0, &pel_panel_ssd1309, &pel_panel_ssd1309_turned},
    {"sh1106", 128, 64, 0, 0, &pel_panel_sh1106, &pel_panel_sh1106_turned},
    {"sh1107", 64, 128, 0, 0, &pel_panel_sh1107, &pel_panel_sh1107_turned},
    {"sh1107", 128, 128, 0, 0, &pel_panel_sh1107_128,
     &pel_panel_sh1107_128_turned},
    {"st7565", 128, 64, 0, 0, &pel_panel_st7565, &pel_panel_st7565_turned},
    {"pcd8544", 84, 48, 0, 0, &pel_panel_pcd8544, &pel_panel_pcd8544_turned},
};
enum { MODELS = sizeof models / sizeof *models };

/* The one of the size asked for, else the chip's first. */
static const struct model *find(const struct pel_panel_request *r)
{
    const struct model *found = NULL;
    for (int i = 0; i < MODELS; i++)
        if (strcmp(models[i].name, r->chip) == 0 &&
            (!found ||
             (models[i].width == r->width && models[i].height == r->height)))
            found = &models[i];
    return found;
}

static int refuse(const char *name, struct pel_message *message)
{
    char known[400] = "";
    for (int i = 0; i < MODELS; i++)
        if (i == 0 || strcmp(models[i].name, models[i - 1].name) != 0)
            sprintf(known + strlen(known), "%s%s", i ? ", " : "",
                    models[i].name);
    pel_display_paper_names(known, sizeof known);
    return pel_message_set(message, EINVAL,
                           "unknown panel '%.60s': expected one of %s", name,
                           known);
}

static int set_panel(struct pel_panel *panel, const struct pel_panel_request *r,
                     struct pel_message *message)
{
    const struct model *model = find(r);
    const int quarters = r->rotation / 90;
    if (!model)
        return refuse(r->chip, message);
    const bool turned = model->turned && quarters & 1;
    panel->chip = turned ? model->turned : model->chip;
    panel->format = model->chip == &pel_panel_ili9488 ? &pel_bgr888
                    : !model->turned                  ? &pel_rgb565_be
                    : turned                          ? &pel_mono1
                                                      : &pel_mono1_pages;
    panel->width = (uint16_t)(r->width < 0 ? model->width : r->width);
    panel->height = (uint16_t)(r->width < 0 ? model->height : r->height);
    panel->left = (uint16_t)(r->left < 0 ? model->left : r->left);
    panel->top = (uint16_t)(r->left < 0 ? model->top : r->top);
    panel->rotation = (uint8_t)quarters;
    panel->inverted = r->inverted;
    panel->swapped = r->swapped;
    return 0;
}

static enum pel_status panel_begin(const struct pel_display *display,
                                   const struct pel_rect *area,
                                   struct pel_surface *surface)
{
    const struct pel_display_panel *panel = display->context;
    *surface = panel->frame;
    pel_surface_clip(surface, area);
    return PEL_OK;
}

static int make_frame(struct pel_display_panel *panel,
                      const struct pel_display *display,
                      struct pel_message *message)
{
    const struct pel_rect whole = {0, 0, display->width, display->height};
    const size_t size = (size_t)display->width * (size_t)display->height * 3;
    void *pixels = calloc(1, size);
    if (!pixels || pel_surface_init(&panel->frame, display->format, pixels,
                                    size, &whole)) {
        free(pixels);
        errno = ENOMEM;
        return pel_message_errno(message, "a frame of the panel");
    }
    return 0;
}

int pel_display_panel_open(struct pel_display_panel *panel,
                           const struct pel_panel_request *request,
                           struct pel_message *message)
{
    memset(panel, 0, sizeof *panel);
    panel->partial = request->partial;
    const int error = pel_display_paper_find(panel, request)
                          ? pel_display_paper_open(panel, request, message)
                          : set_panel(&panel->panel, request, message);
    return error ? error
                 : pel_bus_linux_open(&panel->bus, &request->bus, message);
}

int pel_display_panel_start(struct pel_display *display,
                            struct pel_display_panel *panel,
                            const struct pel_panel_request *r)
{
    struct pel_message *message = panel->bus.message;
    panel->panel.bus = &panel->bus.bus;
    enum pel_status status = panel->paper.chip
                                 ? pel_display_paper_init(display, panel)
                                 : pel_panel_init(display, &panel->panel);
    panel->told = status != PEL_ERROR_SIZE;
    if (status == PEL_ERROR_SIZE)
        return pel_message_set(
            message, EINVAL,
            "panel: size and offset reach beyond the memory of %s%s", r->chip,
            panel->panel.format && panel->panel.format->bits == 1
                ? ", or are no multiples of 8 rows"
                : "");
    if (status == PEL_OK && r->brightness >= 0)
        status = pel_panel_brightness(&panel->panel, (uint8_t)r->brightness);
    if (status != PEL_OK)
        return EIO;
    display->begin = panel_begin;
    return make_frame(panel, display, message);
}

/* What this says is not the first error, or comes too late. */
void pel_display_panel_close(struct pel_display_panel *panel)
{
    struct pel_message ignored;
    panel->bus.message = &ignored;
    if (panel->paper.chip)
        pel_display_paper_close(panel);
    else if (panel->told)
        pel_panel_sleep(&panel->panel, true);
    panel->told = false;
    free(panel->frame.pixels);
    panel->frame.pixels = NULL;
    pel_bus_linux_close(&panel->bus);
}
