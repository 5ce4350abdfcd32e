/* A script of a file with the styles of its shapes, written as a script. */
#include <math.h>
#include <string.h>

#include "sim/script/commands.h"
#include "sim/view/sheet.h"

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
    static const char *const names[] = {"paint", "option spread",
                                        "option phase", "option cells"};
    enum { NAMES = sizeof names / sizeof names[0] };
    const char *last[NAMES] = {"paint flat #ffffff", "option spread pad",
                               "option phase 0", "option cells 2048"};
    for (size_t i = 0; i < line; i++)
        for (int k = 0; k < NAMES; k++)
            if (begins(s->lines.text[i], names[k]))
                last[k] = s->lines.text[i];
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

void sheet_write_file(FILE *out, const struct sheet *s)
{
    int shape = 0;
    size_t item = 0;
    for (size_t i = 0; i < s->lines.count; i++) {
        const struct script *script = &s->base;
        while (item < script->item_count &&
               script->items[item].line < (long)i + 1)
            item++;
        const struct script_item *at =
            item < script->item_count && script->items[item].line == (long)i + 1
                ? &script->items[item]
                : NULL;
        const struct style *style =
            at && sheet_is_shape(at) ? &s->style[shape++] : NULL;
        if (style &&
            (style->fill != FILL_OWN || style->alpha != 255 || style->marked))
            write_styled(out, s, i, style, at);
        else
            fprintf(out, "%s\n", s->lines.text[i]);
        if (at && at->command->role == SCRIPT_CANVAS &&
            inspect_formats[s->inspect.format].dithered)
            fputs("option dither on\n", out);
    }
}
