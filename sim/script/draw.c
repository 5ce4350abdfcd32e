#include <stdlib.h>
#include <string.h>

#include "core/outline/outline.h"
#include "sim/cli/message.h"
#include "sim/script/commands.h"

const struct script_command *script_next(const struct script_command *command)
{
    command++;
    return command->name ? command : command->next;
}

/* `v` in units of the kind; the setting has `size` bytes a value. */
static void set_values(char *to, size_t size, const int32_t *v, size_t n)
{
    for (size_t i = 0; i < n; i++, to += size) {
        if (size == sizeof(double))
            *(double *)(void *)to = v[i] / 65536.0;
        else if (size == sizeof(int32_t))
            *(int32_t *)(void *)to = v[i];
        else if (size == sizeof(uint16_t))
            *(uint16_t *)(void *)to = (uint16_t)v[i];
        else
            *(uint8_t *)to = (uint8_t)v[i];
    }
}

void script_perform(struct script_pen *pen, const struct script_item *item)
{
    const struct script_command *command = item->command;
    const enum script_role role = command->role;
    const int32_t *v = script_values(pen, item);
    char *settings = role == SCRIPT_SCENE ? (char *)pen->scene : (char *)pen;
    if (!settings)
        return;
    if (role == SCRIPT_PAINT || role == SCRIPT_PAINT_VERTEX)
        pen->paint = item;
    if (command->size)
        set_values(settings + command->offset, command->size, v, item->count);
    if (command->flag)
        *(bool *)(settings + command->flag) = true;
    pen->item = item;
    if (command->draw)
        command->draw(pen, v);
}

bool script_needs_whole(const struct script *script)
{
    for (size_t i = 0; i < script->item_count; i++)
        if (script->items[i].command->role == SCRIPT_WHOLE)
            return true;
    return false;
}

/* False, with a message, when commands move pixels of a picture that is not
 * whole: drawn in bands of `rows`, or a part of the script's. */
static bool check_whole(const struct script *script,
                        const struct pel_rect *shown, int rows,
                        const char *instead)
{
    const int width = (int)(shown->x1 - shown->x0);
    const int height = (int)(shown->y1 - shown->y0);
    const struct script_item *item = script->items;
    while (item < script->items + script->item_count &&
           item->command->role != SCRIPT_WHOLE)
        item++;
    if (item == script->items + script->item_count)
        return true;
    if (rows > 0)
        return message_error_at(script->path, item->line,
                                "%s: a band of %d rows has no pixels of the "
                                "others: expected %s",
                                item->command->name, rows, instead);
    return (width == script->width && height == script->height) ||
           message_error_at(script->path, item->line,
                            "%s: the screen has %d x %d pixels of %d x %d, and "
                            "all are needed",
                            item->command->name, width, height, script->width,
                            script->height);
}

/* Does it draw strokes, paths, outlines of letters or icons, which have many
 * more sides than points? */
static bool has_strokes(const struct script *script)
{
    const struct script_item *item = script->items;
    for (; item < script->items + script->item_count; item++) {
        if (item->command->role == SCRIPT_TEXT ||
            strchr(item->command->kinds, KIND_ICON))
            return true;
        for (const struct script_command *c = script_strokes; c->name; c++)
            if (item->command == c && c->role == SCRIPT_SHAPE)
                return true;
    }
    return false;
}

bool script_pen_init(struct script_pen *pen, const struct script *script,
                     struct pel_surface *surface)
{
    const size_t n = script->polygon_max;
    const int32_t width = surface->bounds.x1 - surface->bounds.x0;
    const size_t outline = pel_polygon_outline_scratch_size((int32_t)n);
    const size_t smooth = PEL_SMOOTH_POLYGON_SCRATCH_SIZE(n, width);
    const size_t stroke =
        has_strokes(script) ? PEL_ICON_SCRATCH_SIZE(65536, width) : 0;
    const size_t polygon = outline > smooth ? outline : smooth;
    const size_t size = polygon > stroke ? polygon : stroke;
    *pen = (struct script_pen){.surface = surface,
                               .clip = surface->bounds,
                               .script = script,
                               .scratch = malloc(size + 1),
                               .scratch_size = size,
                               .paints = malloc(script_paint_size())};
    if (pen->scratch && pen->paints)
        return true;
    script_pen_free(pen);
    return message_error("no memory for a polygon of %zu vertices",
                         script->polygon_max);
}

void script_pen_free(struct script_pen *pen)
{
    free(pen->scratch);
    free(pen->paints);
}

void script_finish(struct script_pen *pen, enum pel_status status)
{
    if (status == PEL_ERROR_SCRATCH && !pen->failed)
        message_error_at(pen->script->path, pen->item->line,
                         "%s: a row of pixels has more than 65536 sides: "
                         "expected fewer",
                         pen->item->command->name);
    pen->failed = pen->failed || status == PEL_ERROR_SCRATCH;
}

/* `context` is the pen with which each band begins. */
static void draw_all(struct pel_surface *surface, void *context)
{
    struct script_pen *start = context, pen = *start;
    const struct script *script = pen.script;
    pen.surface = surface;
    for (size_t i = 0; i < script->item_count; i++)
        script_perform(&pen, &script->items[i]);
    start->failed = start->failed || pen.failed;
}

bool script_draw(const struct script *script, struct canvas *canvas, int rows)
{
    struct script_pen pen;
    const char *instead = rows < 0 ? "bands 0 before it" : "--bands 0";
    if (rows < 0)
        rows = script->bands;
    if (!check_whole(script, &canvas->surface.bounds, rows, instead) ||
        !script_pen_init(&pen, script, &canvas->surface))
        return false;
    const bool done = canvas_draw(canvas, rows, draw_all, &pen);
    script_pen_free(&pen);
    return done && !pen.failed;
}
