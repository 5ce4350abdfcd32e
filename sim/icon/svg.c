/* The elements of SVG. What would look different without being read is refused
 * by its name; definitions that nothing refers to are not. */
#include "sim/icon/svg.h"

#include "sim/cli/message.h"

#ifdef HAVE_EXPAT
#include <math.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/cli/text_line.h"
#include "sim/icon/svg_reader.h"

#define SVG_SPACE "http://www.w3.org/2000/svg "

static void add_gradient(struct reader *r, const char **list, bool radial)
{
    static const char *const names[SVG_LENGTHS] = {"x1", "y1", "x2", "y2", "cx",
                                                   "cy", "r",  "fx", "fy"};
    struct svg_gradient g = {.radial = radial,
                             .spread = -1,
                             .user_space = -1,
                             .matrix = {1, 0, 0, 1, 0, 0},
                             .line = r->svg->line};
    for (; *list && !r->bad; list += 2) {
        const char *text = list[1];
        if (strcmp(*list, "id") == 0)
            g.id = svg_copy(r, text, strlen(text));
        else if (strcmp(*list, "href") == 0 ||
                 strcmp(*list, "http://www.w3.org/1999/xlink href") == 0)
            g.href = svg_copy(r, text + (*text == '#'), strlen(text));
        else if (strcmp(*list, "spreadMethod") == 0)
            svg_set_word(r, *list, text, "pad repeat reflect", &g.spread);
        else if (strcmp(*list, "gradientUnits") == 0)
            svg_set_word(r, *list, text, "objectBoundingBox userSpaceOnUse",
                         &g.user_space);
        else if (strcmp(*list, "gradientTransform") == 0) {
            g.has_matrix = true;
            if (!svg_transform(text, &g.matrix))
                svg_refuse(r, "gradientTransform is '%.100s'", text);
        }
        for (int i = 0; i < SVG_LENGTHS; i++)
            if (strcmp(*list, names[i]) == 0 && !svg_length(text, &g.length[i]))
                svg_refuse(r, "%s of a gradient is '%.60s': expected a length",
                           *list, text);
    }
    if (!list_add(&r->svg->gradient, &r->svg->gradients, &g, sizeof g))
        svg_refuse(r, "out of memory");
}

struct stop_style {
    struct svg_paint color;
    double opacity;
};

static bool set_of_stop(struct reader *r, void *to, const char *name,
                        const char *value)
{
    struct stop_style *const s = to;
    if (strcmp(name, "stop-color") == 0)
        return svg_set_paint(r, value, &s->color);
    return strcmp(name, "stop-opacity") != 0 ||
           svg_set_part(r, name, value, &s->opacity);
}

static void add_stop(struct reader *r, const char **list)
{
    struct stop_style s = {{SVG_COLOR, PEL_RGB(0, 0, 0), NULL}, 1};
    const char *at = svg_attribute(list, "offset");
    struct svg_stop stop = {0, 0};
    if (r->svg->gradients == 0)
        return;
    struct svg_gradient *const g = &r->svg->gradient[r->svg->gradients - 1];
    svg_each_property(r, list, &s, set_of_stop);
    if (at)
        svg_set_part(r, "offset", at, &stop.at);
    if (s.color.kind != SVG_COLOR)
        svg_refuse(r, "a stop has no colour of its own: expected #rrggbb");
    if (g->stops > 0)
        stop.at = fmax(stop.at, g->stop[g->stops - 1].at);
    stop.color = (s.color.color & 0xFFFFFF) | (pel_color)lround(255 * s.opacity)
                                                  << 24;
    if (!list_add(&g->stop, &g->stops, &stop, sizeof stop))
        svg_refuse(r, "out of memory");
}

/* Where the root's space lies: its viewBox in the middle of width and height,
 * as large as it may be. */
static void begin_root(struct reader *r, struct element *e, const char **list)
{
    const char *view = svg_attribute(list, "viewBox");
    const char *keep = svg_attribute(list, "preserveAspectRatio");
    struct svg *const svg = r->svg;
    double v[4] = {0, 0, 0, 0};
    for (int i = 0; view && i < 4; i++)
        if (!svg_number(&view, &v[i]))
            svg_refuse(r, "viewBox: expected four numbers");
    svg->width = svg_length_of(r, list, "width", v[2] > 0 ? v[2] : 100);
    svg->height = svg_length_of(r, list, "height", v[3] > 0 ? v[3] : 100);
    svg->width = svg->width > 0 ? svg->width : v[2];
    svg->height = svg->height > 0 ? svg->height : v[3];
    if (!(svg->width > 0 && svg->height > 0)) {
        svg_refuse(r,
                   "has no size: expected a width and a height, or a viewBox");
        return;
    }
    if (!(v[2] > 0 && v[3] > 0)) {
        v[2] = svg->width;
        v[3] = svg->height;
    }
    const double x = svg->width / v[2], y = svg->height / v[3];
    const double k = fmin(x, y);
    if (fabs(x - y) > 0.001 * k && keep &&
        (!strstr(keep, "xMidYMid") || strstr(keep, "slice")))
        svg_refuse(r, "preserveAspectRatio is '%.60s': expected xMidYMid meet",
                   keep);
    svg->view = (struct svg_point){v[2], v[3]};
    e->matrix = (struct svg_matrix){k,
                                    0,
                                    0,
                                    k,
                                    (svg->width - k * v[2]) / 2 - k * v[0],
                                    (svg->height - k * v[3]) / 2 - k * v[1]};
}

/* What an element is: drawn, skipped, or refused. */
static bool is_one_of(const char *name, const char *words)
{
    const size_t n = strlen(name);
    for (const char *w = words; (w = strstr(w, name)); w += n)
        if (w[-1] == ' ' && w[n] == ' ')
            return true;
    return false;
}

static void enter(struct reader *r, const char *name, struct element *e,
                  const char **list)
{
    if (is_one_of(name, " linearGradient radialGradient "))
        add_gradient(r, list, *name == 'r');
    else if (strcmp(name, "stop") == 0)
        add_stop(r, list);
    else if (strcmp(name, "defs") == 0)
        e->in_defs = true;
    else if (is_one_of(name, " title desc metadata script symbol clipPath mask "
                             "pattern filter marker cursor font view "))
        r->skipped = 1;
    else if (strcmp(name, "style") == 0)
        e->is_css = true;
    else if (!is_one_of(name, " g a ") && !svg_add_shape(r, name, e, list) &&
             !e->in_defs)
        svg_refuse(
            r,
            "<%.40s>, which pel does not draw: expected paths, shapes and "
            "groups alone, or a PNG",
            name);
}

static void XMLCALL start(void *data, const char *name, const char **list)
{
    struct reader *const r = data;
    const size_t n = sizeof SVG_SPACE - 1;
    const bool is_svg = strncmp(name, SVG_SPACE, n) == 0;
    r->svg->line = (long)XML_GetCurrentLineNumber(r->parser);
    if (r->skipped > 0 || (r->depth > 0 && !is_svg)) {
        r->skipped++;
        return;
    }
    name += is_svg ? n : 0;
    const struct element root = {
        .style = {.fill = {SVG_COLOR, PEL_RGB(0, 0, 0), NULL},
                  .fill_opacity = 1,
                  .stroke_opacity = 1,
                  .opacity = 1,
                  .width = 1,
                  .miter_limit = 4,
                  .join = PEL_JOIN_MITER,
                  .rule = PEL_NON_ZERO}};
    struct element e = r->depth > 0 ? r->open[r->depth - 1] : root;
    e.own_opacity = 1;
    e.first = r->svg->shapes;
    if (r->depth == 0 && (!is_svg || strcmp(name, "svg") != 0))
        svg_refuse(r, "is no SVG: expected <svg xmlns=\""
                      "http://www.w3.org/2000/svg\">");
    else if (r->depth == 0)
        begin_root(r, &e, list);
    if (!r->bad && svg_each_property(r, list, &e, svg_set_property) &&
        r->skipped == 0) {
        e.style.opacity *= e.own_opacity;
        if (r->depth > 0)
            enter(r, name, &e, list);
    }
    if (r->skipped == 0 && !r->bad &&
        !list_add(&r->open, &r->depth, &e, sizeof e))
        svg_refuse(r, "out of memory");
}

static bool is_seen(const struct svg_paint *paint, double opacity)
{
    return paint->kind != SVG_NONE && opacity > 0;
}

/* Of two points nothing is filled. */
static bool has_fill(const struct svg_shape *shape)
{
    const struct svg_style *const s = &shape->style;
    return is_seen(&s->fill, s->fill_opacity) && shape->path.points > 2;
}

static bool has_stroke(const struct svg_style *s)
{
    return is_seen(&s->stroke, s->stroke_opacity) && s->width > 0;
}

/* In px, with half of the stroke's width around it. */
static void shape_box(const struct svg_shape *shape, double box[4])
{
    const struct svg_matrix *m = &shape->matrix;
    const double half = has_stroke(&shape->style) ? shape->style.width / 2 : 0;
    svg_path_box(&shape->path, m, box);
    box[0] -= half * hypot(m->a, m->c);
    box[2] += half * hypot(m->a, m->c);
    box[1] -= half * hypot(m->b, m->d);
    box[3] += half * hypot(m->b, m->d);
}

static bool boxes_meet(const double *a, const double *b)
{
    const double edge = 0.05; /* px: shapes that touch */
    return a[0] < b[2] - edge && b[0] < a[2] - edge && a[1] < b[3] - edge &&
           b[1] < a[3] - edge;
}

/* The opacity of a group is that of each of its shapes, unless they lie over
 * each other. */
static void check_opacity(struct reader *r, const struct element *e)
{
    const struct svg *const svg = r->svg;
    bool meet = false;
    if (e->own_opacity >= 1 || e->own_opacity <= 0)
        return;
    for (size_t i = e->first; i < svg->shapes && !meet; i++) {
        const struct svg_shape *const s = &svg->shape[i];
        double box[4], other[4];
        shape_box(s, box);
        meet = has_fill(s) && has_stroke(&s->style);
        for (size_t k = e->first; k < i && !meet; k++) {
            shape_box(&svg->shape[k], other);
            meet = boxes_meet(box, other);
        }
    }
    if (meet)
        svg_refuse(
            r, "opacity of what lies over each other, shapes or the fill and "
               "the stroke of one: expected fill-opacity and "
               "stroke-opacity, or a PNG");
}

static void XMLCALL end(void *data, const char *name)
{
    struct reader *const r = data;
    (void)name;
    if (r->skipped > 0) {
        r->skipped--;
        return;
    }
    if (r->depth > 0)
        check_opacity(r, &r->open[--r->depth]);
}

static void XMLCALL text(void *data, const char *bytes, int n)
{
    struct reader *const r = data;
    for (int i = 0; i < n && r->skipped == 0 && r->depth > 0; i++)
        if (r->open[r->depth - 1].is_css && !strchr(" \t\r\n", bytes[i])) {
            svg_refuse(r, "<style>, rules of CSS: expected style=\"...\" or "
                          "attributes");
            return;
        }
}

static bool parse(struct reader *r, FILE *file)
{
    char part[16384];
    size_t n = 1;
    enum XML_Status status = XML_STATUS_OK;
    while (n > 0 && status == XML_STATUS_OK) {
        n = fread(part, 1, sizeof part, file);
        status = XML_Parse(r->parser, part, (int)n, n == 0);
    }
    r->svg->line = (long)XML_GetCurrentLineNumber(r->parser);
    return !r->bad && (status == XML_STATUS_OK ||
                       ERROR_AT(r->svg, "%s: expected an SVG file",
                                XML_ErrorString(XML_GetErrorCode(r->parser))));
}

bool svg_read(struct svg *svg, const char *path)
{
    FILE *file = file_open(path);
    *svg = (struct svg){.path = path};
    if (!file)
        return false;
    struct reader r = {.svg = svg, .parser = XML_ParserCreateNS(NULL, ' ')};
    if (!r.parser)
        return message_error("out of memory");
    XML_SetUserData(r.parser, &r);
    XML_SetElementHandler(r.parser, start, end);
    XML_SetCharacterDataHandler(r.parser, text);
    const bool done = parse(&r, file);
    fclose(file);
    return done;
}

#else

bool svg_read(struct svg *svg, const char *path)
{
    (void)svg;
    return message_error_at(path, 0,
                            "this pel was built without expat, which reads "
                            "SVG: the package libexpat1-dev brings it");
}

#endif
