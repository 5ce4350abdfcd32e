#include "sim/view/sheet.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/image/copy.h"
#include "core/paint/paint_texture.h"
#include "core/raster/rectangle.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"
#include "sim/script/pick.h"

enum { ZOOM_MOST = 32, BAND_ROWS = 16 };

/* Shapes that a style may paint. */
static bool is_shape(const struct script_item *item)
{
    const enum script_role role = item->command->role;
    return role == SCRIPT_SHAPE || role == SCRIPT_TRIANGLE ||
           role == SCRIPT_TEXT;
}

static int count_shapes(const struct script *script, size_t items)
{
    int n = 0;
    for (size_t i = 0; i < items; i++)
        n += is_shape(&script->items[i]);
    return n;
}

static bool read_lines(struct sheet *s)
{
    char *text = NULL;
    size_t size = 0;
    FILE *file = fopen(s->path, "r");
    if (!file)
        return message_error_at(s->path, 0, "cannot be read: %s",
                                strerror(errno));
    while (getline(&text, &size, file) > 0) {
        char **list = list_grow(s->line, s->lines, sizeof *list);
        if (!list)
            break;
        s->line = list;
        list[s->lines++] = text;
        text = NULL;
    }
    free(text);
    const bool whole = feof(file) && !ferror(file);
    fclose(file);
    return whole || message_error_at(s->path, 0, "cannot be read");
}

bool sheet_init(struct sheet *s, const char *path)
{
    *s = (struct sheet){.path = path, .picked = -1, .zoom = 1, .moving = true};
    s->stale = true;
    if (path) {
        if (!read_lines(s) || !script_load(&s->base, path, NULL))
            return false;
        s->shapes = count_shapes(&s->base, s->base.item_count);
    } else {
        s->shapes = FIGURES;
    }
    s->style = malloc(((size_t)s->shapes + 1) * sizeof *s->style);
    if (!s->style)
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
    for (size_t i = 0; i < s->lines; i++)
        free(s->line[i]);
    free(s->line);
    free(s->style);
    script_free(&s->base);
    script_free(&s->script);
    canvas_free(&s->canvas);
}

void sheet_resize(struct sheet *s, int width, int height)
{
    s->width = width;
    s->height = height;
    s->stale = true;
}

/* A line of the file whose first words are these. */
static bool begins(const char *line, const char *with)
{
    line += strspn(line, " \t");
    return strncmp(line, with, strlen(with)) == 0;
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
    const char *paint = "paint flat #ffffff\n", *spread = "option spread pad\n",
               *phase = "option phase 0\n";
    for (size_t i = 0; i < line; i++) {
        paint = begins(s->line[i], "paint") ? s->line[i] : paint;
        spread = begins(s->line[i], "option spread") ? s->line[i] : spread;
        phase = begins(s->line[i], "option phase") ? s->line[i] : phase;
    }
    const bool has_color = strchr(paint, '#') != NULL;
    const struct outline o = outline_of(s, item);
    if (style->fill == FILL_OWN && (has_color || !style->marked))
        style_recolor(out, style, paint);
    else
        style_write(out, style, &o);
    fprintf(out, "%s\n%s\n%s\n%s\n", s->line[line], paint, spread, phase);
}

static void write_file(FILE *out, const struct sheet *s)
{
    int shape = 0;
    size_t item = 0;
    for (size_t i = 0; i < s->lines; i++) {
        const struct script *script = &s->base;
        while (item < script->item_count &&
               script->items[item].line < (long)i + 1)
            item++;
        const struct script_item *at =
            item < script->item_count && script->items[item].line == (long)i + 1
                ? &script->items[item]
                : NULL;
        const struct style *style =
            at && is_shape(at) ? &s->style[shape++] : NULL;
        if (style &&
            (style->fill != FILL_OWN || style->alpha != 255 || style->marked))
            write_styled(out, s, i, style, at);
        else
            fprintf(out, "%s\n", s->line[i]);
        if (at && at->command->role == SCRIPT_CANVAS &&
            inspect_formats[s->inspect.format].dithered)
            fputs("option dither on\n", out);
    }
}

/* The script as it is to be shown, read from memory. */
static bool compose(struct sheet *s)
{
    const struct inspect_format *as = &inspect_formats[s->inspect.format];
    const struct pel_format *format = s->inspect.heat ? &inspect_heat
                                      : !s->path || s->inspect.format > 0
                                          ? as->format
                                          : NULL;
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    s->figures.width = pel_max(s->width / s->zoom, 1);
    s->figures.height = pel_max(s->height / s->zoom, 1);
    s->figures.dithered = as->dithered;
    if (file && s->path)
        write_file(file, s);
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

/* The picture in the middle of the window. */
static struct pel_rect place(const struct sheet *s)
{
    const int width = s->script.width * s->zoom;
    const int height = s->script.height * s->zoom;
    const int left = (s->width - width) / 2, top = (s->height - height) / 2;
    return (struct pel_rect){left, top, left + width, top + height};
}

/* The picture's pixel under the pointer; false: none is. */
static bool pixel_at(const struct sheet *s, int *x, int *y)
{
    const struct pel_rect at = place(s);
    *x = (s->pointer[0] - at.x0) / s->zoom;
    *y = (s->pointer[1] - at.y0) / s->zoom;
    return s->pointer[0] >= at.x0 && s->pointer[0] < at.x1 &&
           s->pointer[1] >= at.y0 && s->pointer[1] < at.y1;
}

static bool draw_picture(struct sheet *s)
{
    const double start = milliseconds();
    if (s->stale && !compose(s))
        return false;
    canvas_free(&s->canvas);
    if (!canvas_init(&s->canvas, s->script.format, s->script.width,
                     s->script.height))
        return false;
    if (s->inspect.heat)
        memset(s->canvas.memory, 0,
               (size_t)s->canvas.surface.stride * (size_t)s->script.height);
    const bool done = script_draw(&s->script, &s->canvas, -1);
    s->milliseconds = milliseconds() - start;
    return done;
}

/* The picture, a pixel as a square of zoom x zoom. */
static void show_picture(const struct sheet *s,
                         const struct pel_surface *surface)
{
    const struct pel_surface *from = &s->canvas.surface;
    const struct pel_rect at = place(s);
    if (s->zoom == 1) {
        const struct pel_copy_part all = {from, from->bounds, at.x0, at.y0};
        pel_copy(surface, &all);
        return;
    }
    const uint64_t step = (UINT64_C(1) << 32) / (uint64_t)s->zoom + 1;
    const struct pel_texture_map map = {
        {step / 2 - (uint64_t)at.x0 * step, step, 0},
        {step / 2 - (uint64_t)at.y0 * step, 0, step}};
    const struct pel_texels texels = {.surface = from};
    struct pel_texture paint;
    pel_texture_init_nearest(&paint, &texels, &map);
    pel_box(surface, &at, &paint.base.paint);
}

static void show_overlays(const struct sheet *s,
                          const struct pel_surface *surface)
{
    const struct inspect *show = &s->inspect;
    const struct pel_rect at = place(s);
    int x, y;
    if (show->bands)
        inspect_bands(surface, &at, BAND_ROWS, s->zoom);
    if (show->magnifier && pixel_at(s, &x, &y))
        inspect_magnifier(surface, &s->canvas.surface, &s->script, x, y);
}

bool sheet_draw(struct sheet *s, const struct pel_surface *surface)
{
    if (!draw_picture(s))
        return false;
    pel_clear(surface, PEL_RGB(0, 0, 0));
    show_picture(s, surface);
    show_overlays(s, surface);
    return true;
}

bool sheet_advance(struct sheet *s)
{
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

/* Marks one shape alone; -1: none. */
static void mark(struct sheet *s, int shape)
{
    s->picked = shape;
    for (int i = 0; i < s->shapes; i++)
        s->style[i].marked = i == shape;
}

static enum view_action pick(struct sheet *s)
{
    int x, y;
    const long item = pixel_at(s, &x, &y) ? script_pick(&s->script, x, y) : -1;
    const bool shape = item >= 0 && is_shape(&s->script.items[item]);
    mark(s, shape ? count_shapes(&s->script, (size_t)item) : -1);
    return VIEW_CHANGED;
}

static void set_fill(struct style *style, enum fill fill)
{
    style->fill = fill;
}

static void fade(struct style *style, enum fill steps)
{
    const int alpha = style->alpha + 17 * ((int)steps - 1);
    style->alpha = (uint8_t)pel_max(0, pel_min(alpha, 255));
}

/* The picked shape, or all where none is. */
static enum view_action change(struct sheet *s,
                               void (*by)(struct style *, enum fill),
                               int argument)
{
    for (int i = 0; i < s->shapes; i++)
        if (s->picked < 0 || s->picked == i)
            by(&s->style[i], (enum fill)argument);
    return VIEW_CHANGED;
}

static enum view_action zoom(struct sheet *s, int by)
{
    s->zoom = pel_max(1, pel_min(s->zoom + by, ZOOM_MOST));
    return VIEW_CHANGED;
}

static enum view_action toggle(bool *which)
{
    *which = !*which;
    return VIEW_CHANGED;
}

static enum view_action press(struct sheet *s, int key)
{
    struct inspect *show = &s->inspect;
    switch (key) {
    case '1':
    case '2':
    case '3':
    case '4':
        return change(s, set_fill, FILL_FLAT + key - '1');
    case '0':
        if (s->path)
            return change(s, set_fill, FILL_OWN);
        mark(s, -1);
        figures_styles(s->style);
        return VIEW_CHANGED;
    case '+':
    case '=':
    case PEL_KEY_UP:
        return change(s, fade, 2);
    case '-':
    case PEL_KEY_DOWN:
        return change(s, fade, 0);
    case PEL_KEY_TAB:
    case PEL_KEY_RIGHT:
        mark(s, s->picked + 1 < s->shapes ? s->picked + 1 : -1);
        return VIEW_CHANGED;
    case PEL_KEY_LEFT:
        mark(s, s->picked >= 0 ? s->picked - 1 : s->shapes - 1);
        return VIEW_CHANGED;
    case PEL_KEY_ENTER:
        mark(s, -1);
        return VIEW_CHANGED;
    case PEL_KEY_F1 + 1:
        return zoom(s, -1);
    case PEL_KEY_F1 + 2:
        return zoom(s, 1);
    case ' ':
        return toggle(&s->moving);
    case 'o':
        return toggle(&show->heat);
    case 'b':
        return toggle(&show->bands);
    case 'd':
        return toggle(&show->areas);
    case 'm':
        return toggle(&show->magnifier);
    case 'i':
        return toggle(&show->numbers);
    case 'h':
        return toggle(&show->help);
    case 'x':
        show->format = (show->format + 1) % INSPECT_FORMATS;
        return VIEW_CHANGED;
    case 'w':
        return VIEW_SAVE;
    case 'q':
    case PEL_KEY_ESCAPE:
        return VIEW_END;
    default:
        return VIEW_NOTHING;
    }
}

static void point(struct sheet *s, int x, int y)
{
    s->pointer[0] = pel_max(0, pel_min(x, s->width - 1));
    s->pointer[1] = pel_max(0, pel_min(y, s->height - 1));
}

static enum view_action take(struct sheet *s, const struct pel_input *input)
{
    const bool down = input->state == PEL_INPUT_DOWN;
    switch (input->kind) {
    case PEL_INPUT_KEY:
        return input->state == PEL_INPUT_UP ? VIEW_NOTHING
                                            : press(s, input->code);
    case PEL_INPUT_MOVE:
        point(s, s->pointer[0] + input->x, s->pointer[1] + input->y);
        return s->inspect.magnifier ? VIEW_CHANGED : VIEW_NOTHING;
    case PEL_INPUT_POINT:
        point(s, input->x, input->y);
        return s->inspect.magnifier ? VIEW_CHANGED : VIEW_NOTHING;
    case PEL_INPUT_BUTTON:
        return down && input->code == 1 ? pick(s) : VIEW_NOTHING;
    case PEL_INPUT_TOUCH:
        point(s, input->x, input->y);
        return down ? pick(s) : VIEW_NOTHING;
    case PEL_INPUT_WHEEL:
        return change(s, fade, input->y > 0 ? 2 : 0);
    default:
        return VIEW_NOTHING;
    }
}

enum view_action sheet_input(struct sheet *s, const struct pel_input *input)
{
    const enum view_action action = take(s, input);
    s->stale = s->stale || action == VIEW_CHANGED;
    return action;
}
