#include <stdlib.h>

#include "core/outline/outline.h"
#include "message.h"
#include "scene_paints.h"

/* A part of the list, drawn by one pen for every band: each begins as `start`
 * and ends as `end`. */
struct replay {
    const struct scene *scene;
    size_t from, to; /* items */
    struct scene_pen start, end;
};

static void replay_draw(struct pel_surface *surface, void *context)
{
    struct replay *replay = context;
    const struct scene *scene = replay->scene;
    struct scene_pen pen = replay->start;
    pen.surface = surface;
    pel_surface_clip(surface, &pen.clip);
    for (size_t i = replay->from; i < replay->to; i++) {
        const struct scene_item *item = &scene->items[i];
        if (item->command->draw && item->command->role != SCENE_STAGE)
            item->command->draw(&pen, scene->values + item->first, item->count);
    }
    replay->end = pen;
}

bool scene_needs_whole(const struct scene *scene)
{
    for (size_t i = 0; i < scene->item_count; i++)
        if (scene->items[i].command->role == SCENE_WHOLE)
            return true;
    return false;
}

/* Is the whole picture there for what moves its pixels? `rows` as in
 * scene_draw. */
static bool check_whole(const struct scene *scene, const struct pel_rect *shown,
                        int rows)
{
    const int32_t width = shown->x1 - shown->x0;
    const int32_t height = shown->y1 - shown->y0;
    int band = rows > 0 ? rows : 0;
    for (size_t i = 0; i < scene->item_count; i++) {
        const struct scene_item *item = &scene->items[i];
        const char *name = item->command->name;
        if (item->command->role == SCENE_BANDS && rows < 0)
            band = scene->values[item->first];
        if (item->command->role != SCENE_WHOLE)
            continue;
        if (band > 0)
            return message_error_at(
                scene->path, item->line,
                "%s: a band of %d rows has no pixels of "
                "the others; %s would be right",
                name, band, rows < 0 ? "bands 0 before it" : "--bands 0");
        if (width != scene->width || height != scene->height)
            return message_error_at(scene->path, item->line,
                                    "%s: the screen has %d x %d pixels of %d "
                                    "x %d, and all are needed",
                                    name, (int)width, (int)height, scene->width,
                                    scene->height);
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
    const struct scene *scene = replay->scene;
    int rows = 0;
    for (size_t i = 0; i < scene->item_count; i++) {
        const struct scene_item *item = &scene->items[i];
        if (item->command->role != SCENE_BANDS)
            continue;
        if (!draw_part(replay, i, canvas, rows))
            return false;
        rows = scene->values[item->first];
    }
    return draw_part(replay, scene->item_count, canvas, rows);
}

bool scene_draw(const struct scene *scene, struct canvas *canvas, int rows)
{
    struct replay replay = {.scene = scene};
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    struct scene_pen *pen = &replay.start;
    if (rows > 0 && !canvas_bands_legal(scene->format, rows))
        return message_error("bands of %d rows: mono1_pages needs a multiple "
                             "of 8",
                             rows);
    if (!check_whole(scene, &canvas->surface.bounds, rows))
        return false;
    pen->flat = white;
    pen->clip = canvas->surface.bounds;
    pen->assets = scene->assets;
    pen->scratch_size =
        pel_polygon_outline_scratch_size((int32_t)scene->polygon_max);
    pen->scratch = malloc(pen->scratch_size + 1);
    pen->paints = malloc(sizeof *pen->paints);
    if (!pen->scratch || !pen->paints) {
        free(pen->scratch);
        free(pen->paints);
        return message_error("no memory for a polygon of %zu vertices",
                             scene->polygon_max);
    }
    const bool done = rows >= 0
                          ? draw_part(&replay, scene->item_count, canvas, rows)
                          : draw_parts(&replay, canvas);
    free(pen->scratch);
    free(pen->paints);
    return done;
}
