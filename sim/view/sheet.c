#include "sim/view/sheet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/font/asset.h"
#include "sim/script/commands.h"

int sheet_count_shapes(const struct script *script, size_t items)
{
    int n = 0;
    for (size_t i = 0; i < items; i++)
        n += script_is_painted(&script->items[i]);
    return n;
}

/* What the keys ask for before the script does. */
static bool add_options(struct script *script, const struct inspect *show)
{
    const int32_t dither = inspect_formats[show->format].dithered;
    const int32_t smooth = show->smooth;
    return script_add(script, "option dither", &dither, 1) &&
           script_add(script, "option smooth", &smooth, 1);
}

/* The paint and the options in force, which styles replace and put back. */
enum { PAINT, SPREAD, PHASE, CELLS, KEPT };

static bool add_first(struct script *script, struct script_item kept[KEPT])
{
    static const struct {
        const char *name;
        int32_t value;
    } first[KEPT] = {{"paint flat", -1},
                     {"option spread", 0},
                     {"option phase", 0},
                     {"option cells", 0}};
    bool done = true;
    for (int k = 0; done && k < KEPT; k++) {
        done = script_add(script, first[k].name, &first[k].value, 1);
        if (done)
            kept[k] = script->items[script->item_count - 1];
    }
    return done;
}

static void keep(struct script_item kept[KEPT], const struct script_item *item)
{
    const enum script_role role = item->command->role;
    if (role == SCRIPT_PAINT || role == SCRIPT_PAINT_VERTEX)
        kept[PAINT] = *item;
    for (int k = SPREAD; k < KEPT; k++)
        if (item->command == kept[k].command)
            kept[k] = *item;
}

/* Middle and reach of a shape: of its points and its last length. */
static struct outline outline_of(const struct sheet *s,
                                 const struct script_item *item)
{
    const int32_t *v = s->script.values + item->first;
    const char *kinds = item->command->kinds, *length = strrchr(kinds, 'l');
    const bool sized = item->command->form == FORM_RECTANGLE;
    const double r = length && !sized ? v[length - kinds] / 256.0 : 0;
    const size_t first = kinds[0] == KIND_LENGTH; /* the width of a stroke */
    const size_t n =
        strchr(kinds, '*') ? item->count - first : strspn(kinds, "pi");
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    for (size_t i = 0; i < n; i++) {
        const double at = v[first + i] / (kinds[0] == KIND_PIXEL ? 1 : 256.0);
        low[i % 2] = fmin(low[i % 2], at - r);
        high[i % 2] =
            fmax(high[i % 2], at + r + (sized ? v[i + 2] / 256.0 : 0));
    }
    const double x = (low[0] + high[0]) / 2, y = (low[1] + high[1]) / 2;
    const double reach = fmax(hypot(high[0] - low[0], high[1] - low[1]) / 2, 1);
    const double x0 = x - reach, x1 = x + reach;
    const double y0 = y - reach, y1 = y + reach;
    return (struct outline){.x = x,
                            .y = y,
                            .r = reach,
                            .corner = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}},
                            .corners = 4,
                            .phase = s->figures.phase};
}

static bool add_styled(struct sheet *s, const struct script_item *item,
                       const struct style *style,
                       const struct script_item kept[KEPT])
{
    const struct outline o = outline_of(s, item);
    const bool own =
        style->fill == FILL_OWN &&
        (!style->marked || strchr(kept[PAINT].command->kinds, KIND_COLOR));
    bool done = (own ? style_recolor(&s->script, style, &kept[PAINT])
                     : style_add(&s->script, style, &o)) &&
                script_add_item(&s->script, item);
    for (int k = 0; k < KEPT; k++)
        done = done && script_add_item(&s->script, &kept[k]);
    return done;
}

static bool add_file(struct sheet *s)
{
    struct script_item kept[KEPT];
    const struct style *style = s->style;
    bool done = add_first(&s->script, kept);
    for (size_t i = 0; done && i < s->item_count; i++) {
        const struct script_item *item = &s->items[i];
        const struct style *own = script_is_painted(item) ? style++ : NULL;
        if (own && (own->fill != FILL_OWN || own->alpha != 255 || own->marked))
            done = add_styled(s, item, own, kept);
        else
            done = script_add_item(&s->script, item);
        keep(kept, item);
    }
    return done;
}

bool sheet_compose(struct sheet *s)
{
    const struct inspect_format *as = &inspect_formats[s->inspect.format];
    if (!s->stale)
        return true;
    s->script.format = s->inspect.heat                     ? &pel_heat
                       : !s->path || s->inspect.format > 0 ? as->format
                                                           : s->format;
    s->script.item_count = 0;
    s->script.value_count = s->value_count;
    s->figures.width = pel_max(s->width / s->zoom, 1);
    s->figures.height = pel_max(s->height / s->zoom, 1);
    s->figures.dithered = as->dithered;
    s->figures.smooth = s->inspect.smooth;
    const bool done =
        add_options(&s->script, &s->inspect) &&
        (s->path ? add_file(s)
                 : figures_add(&s->script, &s->figures, s->style));
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

static bool read_file(struct sheet *s, const char *path)
{
    struct script *script = &s->script;
    if (!script_load(script, path, NULL))
        return false;
    s->shapes = sheet_count_shapes(script, script->item_count);
    s->format = script->format;
    s->value_count = script->value_count;
    s->item_count = script->item_count;
    s->items = script->items;
    script->items = NULL;
    script->item_count = 0;
    return true;
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
        .shapes = FIGURES,
        .picked = -1,
        .zoom = 1,
        .moving = true,
        .areas = {.window = 256},
    };
    if ((path && !read_file(s, path)) || !font_asset_builtin(&s->font))
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
    free(s->items);
    free(s->style);
    free(s->drawn_style);
    font_asset_free(&s->font);
    script_free(&s->script);
    canvas_free(&s->canvas);
}
