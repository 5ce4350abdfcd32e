#include "sim/view/sheet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/font/asset.h"
#include "sim/script/commands.h"

bool sheet_is_shape(const struct script_item *item)
{
    const enum script_role role = item->command->role;
    return role == SCRIPT_SHAPE || role == SCRIPT_TRIANGLE ||
           role == SCRIPT_TEXT;
}

int sheet_count_shapes(const struct script *script, size_t items)
{
    int n = 0;
    for (size_t i = 0; i < items; i++)
        n += sheet_is_shape(&script->items[i]);
    return n;
}

bool sheet_compose(struct sheet *s)
{
    const struct inspect_format *as = &inspect_formats[s->inspect.format];
    const struct pel_format *format = s->inspect.heat ? &inspect_heat
                                      : !s->path || s->inspect.format > 0
                                          ? as->format
                                          : NULL;
    if (!s->stale)
        return true;
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    s->figures.width = pel_max(s->width / s->zoom, 1);
    s->figures.height = pel_max(s->height / s->zoom, 1);
    s->figures.dithered = as->dithered;
    if (file && s->path)
        sheet_write_file(file, s);
    else if (file)
        figures_write(file, &s->figures, s->style);
    if (!file || fclose(file) != 0 || !(file = fmemopen(text, size, "r"))) {
        free(text);
        return message_error("out of memory");
    }
    script_free(&s->script);
    const bool done =
        script_read(&s->script, file, s->path ? s->path : "figures", format);
    fclose(file);
    free(text);
    s->stale = !done;
    return done;
}

/* One step, however long the frame took: a recorded run can be drawn again. */
static bool advance(struct show *show, double time)
{
    struct sheet *s = (struct sheet *)show;
    (void)time;
    bool changes = false;
    for (int i = 0; i < s->shapes; i++)
        changes = changes || s->style[i].fill == FILL_RADIAL;
    changes = s->moving && (changes || !s->path);
    if (!changes)
        return false;
    s->figures.turn = fmod(s->figures.turn + 1 / 240.0, 1);
    s->figures.phase = fmod(s->figures.phase + 1 / 30.0, 1);
    s->stale = true;
    return true;
}

static enum view_action input(struct show *show, const struct pel_input *input)
{
    struct sheet *s = (struct sheet *)show;
    const struct inspect before = s->inspect;
    const int zoom = s->zoom;
    const enum view_action action = sheet_take(s, input);
    s->stale = s->stale || action == VIEW_CHANGED;
    s->whole = s->whole || zoom != s->zoom || before.heat != s->inspect.heat ||
               before.format != s->inspect.format;
    return action;
}

static bool resize(struct show *show, int width, int height)
{
    struct sheet *s = (struct sheet *)show;
    s->width = width;
    s->height = height;
    s->stale = s->whole = true;
    return true;
}

static void title(const struct show *show, char *text)
{
    const struct sheet *s = (const struct sheet *)show;
    snprintf(text, SHOW_TITLE_SIZE, "%s, %d x %d pixels, %s",
             s->path ? s->path : "figures", s->script.width, s->script.height,
             inspect_formats[s->inspect.format].name);
}

bool sheet_init(struct sheet *s, const char *path)
{
    *s = (struct sheet){
        .show = {.resize = resize,
                 .input = input,
                 .advance = advance,
                 .draw = sheet_draw,
                 .title = title,
                 .keys = SHEET_KEYS_HELP,
                 .period = 1000 / 30.0,
                 .width = 800,
                 .height = 800},
        .path = path,
        .picked = -1,
        .zoom = 1,
        .moving = true,
        .areas = {.window = 256},
    };
    if (path) {
        if (!text_lines_read(&s->lines, path) ||
            !script_load(&s->base, path, NULL))
            return false;
        s->shapes = sheet_count_shapes(&s->base, s->base.item_count);
    } else {
        s->shapes = FIGURES;
    }
    if (!font_asset_builtin(&s->font))
        return false;
    s->style = malloc(((size_t)s->shapes + 1) * sizeof *s->style);
    s->drawn_style = malloc(((size_t)s->shapes + 1) * sizeof *s->style);
    if (!s->style || !s->drawn_style)
        return message_error("out of memory");
    for (int i = 0; i < s->shapes; i++)
        s->style[i] =
            (struct style){FILL_OWN, PEL_RGB(0, 128, 255), 255, false};
    if (!path)
        figures_styles(s->style);
    return true;
}

void sheet_free(struct sheet *s)
{
    text_lines_free(&s->lines);
    free(s->style);
    free(s->drawn_style);
    font_asset_free(&s->font);
    script_free(&s->base);
    script_free(&s->script);
    canvas_free(&s->canvas);
}
