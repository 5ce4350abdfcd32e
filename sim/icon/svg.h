/* SVG as Pel draws it: shapes in the order of the file, each with its outline,
 * transform and style. For the child process that reads one file
 * (sim/cli/child.h): what it allocates ends with it. Only for sim/icon. */
#ifndef SIM_ICON_SVG_H
#define SIM_ICON_SVG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/asset/icon_asset.h"
#include "core/path/path.h"

/* x' = a x + c y + e, y' = b x + d y + f. */
struct svg_matrix {
    double a, b, c, d, e, f;
};

struct svg_point {
    double x, y;
};

/* Verbs and points, enum pel_verb. */
struct svg_path {
    uint8_t *verb;
    struct svg_point *point;
    size_t verbs, points;
    bool failed; /* memory was short */
};

struct svg_paint {
    enum { SVG_NONE, SVG_COLOR, SVG_CURRENT, SVG_GRADIENT } kind;
    pel_color color; /* opaque */
    char *id;        /* of a gradient */
};

/* What children inherit. */
struct svg_style {
    struct svg_paint fill, stroke;
    double fill_opacity, stroke_opacity, opacity; /* that of all around it */
    double width, miter_limit;
    int cap, join, rule; /* of core */
    int hidden;          /* 0: visible */
    bool dashed;
};

/* A length or, of `percent`, a hundredth of what it is measured by. */
struct svg_length {
    double value;
    bool percent, given;
};

struct svg_stop {
    double at;
    pel_color color;
};

enum {
    SVG_X1,
    SVG_Y1,
    SVG_X2,
    SVG_Y2, /* of linear ones */
    SVG_CX,
    SVG_CY,
    SVG_R,
    SVG_FX,
    SVG_FY, /* of radial ones */
    SVG_LENGTHS
};

/* What is not given is that of the gradient `href`, or of the standard. */
struct svg_gradient {
    char *id, *href;
    bool radial;
    struct svg_length length[SVG_LENGTHS];
    int spread, user_space; /* -1: not given */
    bool has_matrix;
    struct svg_matrix matrix;
    struct svg_stop *stop;
    size_t stops;
    long line;
};

struct svg_shape {
    struct svg_path path;     /* in its own space */
    struct svg_matrix matrix; /* to px */
    struct svg_style style;
    long line;
};

struct svg {
    const char *path; /* of the file, and the line, for ERROR_AT */
    long line;
    double width, height;     /* px */
    struct svg_matrix matrix; /* from the root's space to px */
    struct svg_point view;    /* what percents of lengths are measured by */
    struct svg_shape *shape;
    size_t shapes;
    struct svg_gradient *gradient;
    size_t gradients;
};

/* Reads a file. False, with a message that names the line. */
bool svg_read(struct svg *svg, const char *path);

/* Makes the parts of an asset of it, all lists malloc'ed. False, with a
 * message. */
bool svg_to_asset(const struct svg *svg, struct pel_icon_asset *asset);

/* The paint of a part: a gradient, its frame in px and its stops malloc'ed; or,
 * without stops, a colour, whose alpha is 0 where nothing is seen. */
struct svg_frame {
    struct svg_point v[3];
    double focus;
    int radial, spread;
    struct svg_stop *stop;
    size_t stops;
    pel_color color;
};
bool svg_resolve(const struct svg *svg, const struct svg_shape *shape,
                 bool stroke, struct svg_frame *frame);

/* At *text, which is moved behind: a number, with blanks and one comma before
 * it. */
bool svg_number(const char **text, double *value);

/* All of a text. False when it is none. */
bool svg_length(const char *text, struct svg_length *to);
bool svg_color(const char *text, pel_color *color);
bool svg_transform(const char *text, struct svg_matrix *matrix);

struct svg_matrix svg_times(const struct svg_matrix *a,
                            const struct svg_matrix *b);
static inline struct svg_point svg_at(const struct svg_matrix *m, double x,
                                      double y)
{
    return (struct svg_point){m->a * x + m->c * y + m->e,
                              m->b * x + m->d * y + m->f};
}

/* The box of a path's curves, without its stroke: x0, y0, x1, y1. */
void svg_path_box(const struct svg_path *path, const struct svg_matrix *matrix,
                  double box[4]);

/* Path data behind what is there; false: wrong at *text. */
bool svg_path_data(struct svg_path *path, const char **text);
void svg_path_add(struct svg_path *path, enum pel_verb verb,
                  const struct svg_point *point);

/* A rectangle whose corners are quarters of an ellipse; one that has no sides
 * is an ellipse. */
void svg_path_rect(struct svg_path *path, const double box[4], double rx,
                   double ry);

#endif
