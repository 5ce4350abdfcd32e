#include <stdlib.h>

#include "core/outline/outline.h"
#include "sim/cli/message.h"
#include "sim/script/commands.h"

/* A part of the list, drawn by one pen for every band: each begins as `start`
 * and ends as `end`. */
struct replay {
    const struct script *script;
    size_t from, to; /* items */
    struct script_pen start, end;
};

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

void script_perform(struct script_pen *pen,
                    const struct script_command *command, const int32_t *v,
                    size_t n)
{
    char *settings =
        command->role == SCRIPT_SCENE ? (char *)pen->scene : (char *)pen;
    if (command->role == SCRIPT_PAINT || command->role == SCRIPT_PAINT_VERTEX) {
        pen->make = command->make;
        pen->values = v;
        pen->value_count = n;
    }
    if (command->size)
        set_values(settings + command->offset, command->size, v, n);
    if (command->flag)
        *(bool *)(settings + command->flag) = true;
    pen->command = command;
    pen->drawn = v;
    pen->count = n;
    if (command->draw)
        command->draw(pen, v);
}

static void replay_draw(struct pel_surface *surface, void *context)
{
    struct replay *replay = context;
    const struct script *script = replay->script;
    struct script_pen pen = replay->start;
    pen.surface = surface;
    pel_surface_clip(surface, &pen.clip);
    for (size_t i = replay->from; i < replay->to; i++) {
        const struct script_item *item = &script->items[i];
        if (item->command->role != SCRIPT_SCENE)
            script_perform(&pen, item->command, script->values + item->first,
                           item->count);
    }
    replay->end = pen;
}

bool script_needs_whole(const struct script *script)
{
    for (size_t i = 0; i < script->item_count; i++)
        if (script->items[i].command->role == SCRIPT_WHOLE)
            return true;
    return false;
}

/* False, with a message, when commands move pixels of a picture that is not
 * whole. `rows` as in script_draw. */
static bool check_whole(const struct script *script,
                        const struct pel_rect *shown, int rows)
{
    const int32_t width = shown->x1 - shown->x0;
    const int32_t height = shown->y1 - shown->y0;
    int band = rows > 0 ? rows : 0;
    for (size_t i = 0; i < script->item_count; i++) {
        const struct script_item *item = &script->items[i];
        const char *name = item->command->name;
        if (item->command->role == SCRIPT_BANDS && rows < 0)
            band = script->values[item->first];
        if (item->command->role != SCRIPT_WHOLE)
            continue;
        if (band > 0)
            return message_error_at(
                script->path, item->line,
                "%s: a band of %d rows has no pixels of "
                "the others: expected %s",
                name, band, rows < 0 ? "bands 0 before it" : "--bands 0");
        if (width != script->width || height != script->height)
            return message_error_at(script->path, item->line,
                                    "%s: the screen has %d x %d pixels of %d "
                                    "x %d, and all are needed",
                                    name, (int)width, (int)height,
                                    script->width, script->height);
    }
    return true;
}

static bool draw_part(struct replay *replay, size_t to, struct canvas *canvas,
                      int rows)
{
    replay->to = to;
    if (!canvas_draw(canvas, rows, replay_draw, replay))
        return false;
    replay->from = to;
    replay->start = replay->end;
    return !replay->end.failed;
}

static bool draw_parts(struct replay *replay, struct canvas *canvas)
{
    const struct script *script = replay->script;
    int rows = 0;
    for (size_t i = 0; i < script->item_count; i++) {
        const struct script_item *item = &script->items[i];
        if (item->command->role != SCRIPT_BANDS)
            continue;
        if (!draw_part(replay, i, canvas, rows))
            return false;
        rows = script->values[item->first];
    }
    return draw_part(replay, script->item_count, canvas, rows);
}

bool script_pen_init(struct script_pen *pen, const struct script *script,
                     struct pel_surface *surface)
{
    const size_t size =
        pel_polygon_outline_scratch_size((int32_t)script->polygon_max);
    *pen = (struct script_pen){.surface = surface,
                               .clip = surface->bounds,
                               .assets = script->assets,
                               .scratch = malloc(size + 1),
                               .scratch_size = size};
    if (script_paint_init(pen) && pen->scratch)
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

bool script_draw(const struct script *script, struct canvas *canvas, int rows)
{
    struct replay replay = {.script = script};
    struct script_pen *pen = &replay.start;
    if (rows > 0 && !canvas_bands_legal(script->format, rows))
        return message_error("bands of %d rows: expected a multiple of 8 for "
                             "mono1_pages",
                             rows);
    if (!check_whole(script, &canvas->surface.bounds, rows))
        return false;
    if (!script_pen_init(pen, script, &canvas->surface))
        return false;
    const bool done = rows >= 0
                          ? draw_part(&replay, script->item_count, canvas, rows)
                          : draw_parts(&replay, canvas);
    script_pen_free(pen);
    return done;
}
