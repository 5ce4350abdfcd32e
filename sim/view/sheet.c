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
    const struct pel_format *format = s->inspect.heat ? &pel_heat
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
    s->figures.smooth = s->inspect.smooth;
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

/* Middle and reach of a shape: those of its box. */
static struct outline outline_of(const struct sheet *s,
                                 const struct script_item *item)
{
    const int32_t *v = s->base.values + item->first;
    const char *kinds = item->command->kinds;
    double box[4] = {1e9, 1e9, -1e9, -1e9};
    const size_t pairs = strncmp(kinds, "pp", 2) == 0 ? item->count / 2 : 1;
    const bool corners = strspn(kinds, "p*") == strlen(kinds);
    for (size_t i = 0; i < (corners ? 2 * pairs : 2); i++) {
        const size_t k = i % 2;
        box[k] = fmin(box[k], v[i] / 256.0);
        box[k + 2] = fmax(box[k + 2], v[i] / 256.0);
    }
    if (strncmp(kinds, "ppll", 4) == 0 && strstr(item->command->name, "rect")) {
        box[2] += v[2] / 256.0;
        box[3] += v[3] / 256.0;
    } else if (!corners && item->count > 2) {
        const double r = v[item->count > 3 && kinds[3] == 'l' ? 3 : 2] / 256.0;
        for (int k = 0; k < 4; k++)
            box[k] += k < 2 ? -r : r;
    }
    struct outline o = {.x = (box[0] + box[2]) / 2,
                        .y = (box[1] + box[3]) / 2,
                        .corners = 4,
                        .phase = s->figures.phase};
    o.r = fmax(hypot(box[2] - box[0], box[3] - box[1]) / 2, 1);
    for (int i = 0; i < 4; i++) {
        o.corner[i][0] = o.x + (i == 0 || i == 3 ? -o.r : o.r);
        o.corner[i][1] = o.y + (i < 2 ? -o.r : o.r);
    }
    return o;
}

/* A line that draws a shape in a style, between paints and options that are as
 * they were after it. */
static void write_styled(FILE *out, const struct sheet *s, size_t line,
                         const struct style *style,
                         const struct script_item *item)
{
    static const char *const names[] = {"paint", "option spread",
                                        "option phase", "option cells"};
    enum { NAMES = sizeof names / sizeof names[0] };
    const char *last[NAMES] = {"paint flat #ffffff", "option spread pad",
                               "option phase 0", "option cells 2048"};
    for (size_t i = 0; i < line; i++) {
        const char *text = s->lines.text[i];
        text += strspn(text, " \t");
        for (int k = 0; k < NAMES; k++)
            if (strncmp(text, names[k], strlen(names[k])) == 0)
                last[k] = text;
    }
    const char *paint = last[0];
    const bool has_color = strchr(paint, '#') != NULL;
    const struct outline o = outline_of(s, item);
    if (style->fill == FILL_OWN && (has_color || !style->marked))
        style_recolor(out, style, paint);
    else
        style_write(out, style, &o);
    fprintf(out, "%s\n", s->lines.text[line]);
    for (int k = 0; k < NAMES; k++)
        fprintf(out, "%s\n", last[k]);
}

/* What the keys ask for before the script does. */
static void write_options(FILE *out, const struct inspect *show)
{
    if (inspect_formats[show->format].dithered)
        fputs("option dither on\n", out);
    if (show->smooth)
        fputs("option smooth on\n", out);
}

void sheet_write_file(FILE *out, const struct sheet *s)
{
    const struct script_item *item = s->base.items;
    const struct script_item *end = item + s->base.item_count;
    int shape = 0;
    for (size_t i = 0; i < s->lines.count; i++) {
        const struct script_item *at =
            item < end && item->line == (long)i + 1 ? item++ : NULL;
        const struct style *style =
            at && sheet_is_shape(at) ? &s->style[shape++] : NULL;
        if (style &&
            (style->fill != FILL_OWN || style->alpha != 255 || style->marked))
            write_styled(out, s, i, style, at);
        else
            fprintf(out, "%s\n", s->lines.text[i]);
        if (at && at->command->role == SCRIPT_CANVAS)
            write_options(out, &s->inspect);
    }
}
