/* Shapes as paths. */
#include <math.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/icon/svg_reader.h"

double svg_length_of(struct reader *r, const char **list, const char *name,
                     double whole)
{
    const char *text = svg_attribute(list, name);
    struct svg_length length = {.value = 0};
    if (text && !svg_length(text, &length))
        svg_refuse(r,
                   "%s is '%.60s': expected a length in px, pt, mm or percent",
                   name, text);
    return length.value * (length.percent ? whole : 1);
}

static void add_rect(struct reader *r, struct svg_path *path, const char **list)
{
    const struct svg_point v = r->svg->view;
    const double w = svg_length_of(r, list, "width", v.x);
    const double h = svg_length_of(r, list, "height", v.y);
    double rx = svg_length_of(r, list, "rx", v.x);
    double ry = svg_length_of(r, list, "ry", v.y);
    double box[4] = {svg_length_of(r, list, "x", v.x),
                     svg_length_of(r, list, "y", v.y), 0, 0};
    rx = svg_attribute(list, "rx") ? rx : ry;
    ry = svg_attribute(list, "ry") ? ry : rx;
    box[2] = box[0] + w;
    box[3] = box[1] + h;
    if (w > 0 && h > 0)
        svg_path_rect(path, box, fmin(fmax(rx, 0), w / 2),
                      fmin(fmax(ry, 0), h / 2));
}

static void add_ellipse(struct reader *r, struct svg_path *path,
                        const char **list, bool circle)
{
    const struct svg_point v = r->svg->view;
    const double x = svg_length_of(r, list, "cx", v.x);
    const double y = svg_length_of(r, list, "cy", v.y);
    const double rx =
        svg_length_of(r, list, circle ? "r" : "rx", hypot(v.x, v.y) / sqrt(2));
    const double ry = circle ? rx : svg_length_of(r, list, "ry", v.y);
    const double box[4] = {x - rx, y - ry, x + rx, y + ry};
    if (rx > 0 && ry > 0)
        svg_path_rect(path, box, rx, ry);
}

static void add_line(struct reader *r, struct svg_path *path, const char **list)
{
    const struct svg_point v = r->svg->view;
    const struct svg_point from = {svg_length_of(r, list, "x1", v.x),
                                   svg_length_of(r, list, "y1", v.y)};
    const struct svg_point to = {svg_length_of(r, list, "x2", v.x),
                                 svg_length_of(r, list, "y2", v.y)};
    svg_path_add(path, PEL_MOVE, &from);
    svg_path_add(path, PEL_LINE, &to);
}

static void add_points(struct reader *r, struct svg_path *path,
                       const char **list, bool closed)
{
    const char *text = svg_attribute(list, "points");
    struct svg_point p;
    while (text && svg_number(&text, &p.x)) {
        if (!svg_number(&text, &p.y))
            break;
        svg_path_add(path, path->verbs ? PEL_LINE : PEL_MOVE, &p);
    }
    if (text && text[strspn(text, " \t\r\n,")])
        svg_refuse(r, "points: '%.60s': expected x,y x,y ...", text);
    if (closed && path->verbs)
        svg_path_add(path, PEL_CLOSE, NULL);
}

static void add_data(struct reader *r, struct svg_path *path, const char **list)
{
    const char *text = svg_attribute(list, "d");
    if (text && strncmp(text, "none", 4) != 0 && !svg_path_data(path, &text))
        svg_refuse(r, "path data is wrong at '%.60s'", text);
}

bool svg_add_shape(struct reader *r, const char *name, const struct element *e,
                   const char **list)
{
    struct svg_shape shape = {
        .matrix = e->matrix, .style = e->style, .line = r->svg->line};
    if (strcmp(name, "path") == 0)
        add_data(r, &shape.path, list);
    else if (strcmp(name, "rect") == 0)
        add_rect(r, &shape.path, list);
    else if (strcmp(name, "circle") == 0 || strcmp(name, "ellipse") == 0)
        add_ellipse(r, &shape.path, list, *name == 'c');
    else if (strcmp(name, "line") == 0)
        add_line(r, &shape.path, list);
    else if (strcmp(name, "polygon") == 0 || strcmp(name, "polyline") == 0)
        add_points(r, &shape.path, list, name[5] == 'o');
    else
        return false;
    if (shape.path.failed)
        svg_refuse(r, "out of memory");
    if (shape.path.verbs > 0 && !e->style.hidden && !e->in_defs && !r->bad &&
        !list_add(&r->svg->shape, &r->svg->shapes, &shape, sizeof shape))
        svg_refuse(r, "out of memory");
    return true;
}
