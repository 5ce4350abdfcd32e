/* Path data, and the shapes of SVG as paths. */
#include <math.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/icon/svg.h"

static const double pi = 3.14159265358979323846;

/* The part of a quarter's control points from its ends: the curve is at most
 * 1/3,676 of the radius off. */
static const double quarter = 0.5522847498307936;

void svg_path_add(struct svg_path *path, enum pel_verb verb,
                  const struct svg_point *point)
{
    static const int points[] = {1, 1, 2, 3, 0};
    const uint8_t byte = (uint8_t)verb;
    path->failed =
        path->failed || !list_add(&path->verb, &path->verbs, &byte, 1);
    for (int i = 0; i < points[verb]; i++)
        path->failed = path->failed || !list_add(&path->point, &path->points,
                                                 &point[i], sizeof *point);
}

/* Path data on its way: the last point, where the part began, and the control
 * point that S and T mirror. */
struct data {
    struct svg_path *path;
    struct svg_point at, start, control;
    char mirrored; /* C, Q or another letter */
};

static void line_to(struct data *d, struct svg_point to)
{
    svg_path_add(d->path, PEL_LINE, &to);
    d->at = to;
}

/* A part of what becomes of the unit circle, between two angles. */
static void add_arc(struct data *d, const struct svg_matrix *circle,
                    double from, double by)
{
    const int n = (int)fmax(ceil(fabs(by) / (pi / 2) - 1e-9), 1);
    const double step = by / n, k = 4.0 / 3 * tan(step / 4);
    for (int i = 0; i < n; i++) {
        const double a = from + i * step, b = a + step;
        const struct svg_point v[3] = {
            svg_at(circle, cos(a) - k * sin(a), sin(a) + k * cos(a)),
            svg_at(circle, cos(b) + k * sin(b), sin(b) - k * cos(b)),
            svg_at(circle, cos(b), sin(b))};
        svg_path_add(d->path, PEL_CUBIC, v);
    }
}

/* The arc of SVG's appendix B.2.4: radii, the turn of the axis, the flags and
 * the end. */
static void arc_to(struct data *d, const double v[5], struct svg_point to)
{
    double rx = fabs(v[0]), ry = fabs(v[1]);
    const double turn = v[2] * pi / 180, c = cos(turn), s = sin(turn);
    const double dx = (d->at.x - to.x) / 2, dy = (d->at.y - to.y) / 2;
    if (rx == 0 || ry == 0 || (dx == 0 && dy == 0)) {
        line_to(d, to);
        return;
    }
    double x = (c * dx + s * dy) / rx, y = (c * dy - s * dx) / ry;
    const double size = hypot(x, y), grow = fmax(size, 1);
    rx *= grow;
    ry *= grow;
    x /= grow;
    y /= grow;
    const double square = x * x + y * y;
    const double k =
        sqrt(fmax(1 / square - 1, 0)) * ((v[3] != 0) == (v[4] != 0) ? -1 : 1);
    const double cx = k * y, cy = -k * x; /* on the unit circle */
    const double from = atan2(y - cy, x - cx);
    double by = atan2(-y - cy, -x - cx) - from;
    if (v[4] != 0 && by < 0)
        by += 2 * pi;
    if (v[4] == 0 && by > 0)
        by -= 2 * pi;
    if (!(fabs(by) <= 2 * pi)) { /* radii of almost 0 */
        line_to(d, to);
        return;
    }
    struct svg_matrix circle = {c * rx, s * rx, -s * ry, c * ry, 0, 0};
    const struct svg_point middle = svg_at(&circle, cx, cy);
    circle.e = middle.x + (d->at.x + to.x) / 2;
    circle.f = middle.y + (d->at.y + to.y) / 2;
    add_arc(d, &circle, from, by);
    d->at = to;
    if (!d->path->failed)
        d->path->point[d->path->points - 1] = to;
}

/* A flag is one digit, and needs no blank behind it. */
static bool flag(const char **text, double *value)
{
    *text += strspn(*text, " \t\r\n\f");
    *text += **text == ',';
    *text += strspn(*text, " \t\r\n\f");
    *value = **text == '1';
    return strchr("01", **text) && *(*text)++;
}

static struct svg_point mirror(const struct data *d, char letter)
{
    const bool same = d->mirrored == letter;
    return (struct svg_point){same ? 2 * d->at.x - d->control.x : d->at.x,
                              same ? 2 * d->at.y - d->control.y : d->at.y};
}

/* Numbers of a command, moved to where they are on the page. */
static bool take_points(struct data *d, const char **text, bool relative,
                        struct svg_point *v, int n)
{
    const struct svg_point from = relative ? d->at : (struct svg_point){0, 0};
    for (int i = 0; i < n; i++) {
        if (!svg_number(text, &v[i].x) || !svg_number(text, &v[i].y))
            return false;
        v[i].x += from.x;
        v[i].y += from.y;
    }
    return true;
}

static bool take_curve(struct data *d, const char **text, char letter,
                       bool relative)
{
    const bool cubic = strchr("CS", letter) != NULL;
    const bool smooth = strchr("ST", letter) != NULL;
    const int n = cubic ? 3 : 2;
    struct svg_point v[3];
    if (!take_points(d, text, relative, v + smooth, n - smooth))
        return false;
    if (smooth)
        v[0] = mirror(d, cubic ? 'C' : 'Q');
    svg_path_add(d->path, cubic ? PEL_CUBIC : PEL_QUAD, v);
    d->control = v[n - 2];
    d->at = v[n - 1];
    d->mirrored = cubic ? 'C' : 'Q';
    return true;
}

static bool take_arc(struct data *d, const char **text, bool relative)
{
    double v[5];
    struct svg_point to;
    if (!svg_number(text, &v[0]) || !svg_number(text, &v[1]) ||
        !svg_number(text, &v[2]) || !flag(text, &v[3]) || !flag(text, &v[4]) ||
        !take_points(d, text, relative, &to, 1))
        return false;
    arc_to(d, v, to);
    return true;
}

/* One of M, L, H and V. */
static bool take_line(struct data *d, const char **text, char letter,
                      bool relative)
{
    struct svg_point to = d->at;
    double *const axis = letter == 'H' ? &to.x : &to.y;
    if (strchr("HV", letter)) {
        const double from = relative ? *axis : 0;
        if (!svg_number(text, axis))
            return false;
        *axis += from;
    } else if (!take_points(d, text, relative, &to, 1))
        return false;
    if (letter == 'M') {
        svg_path_add(d->path, PEL_MOVE, &to);
        d->at = d->start = to;
    } else
        line_to(d, to);
    return true;
}

static bool take_command(struct data *d, const char **text, char letter,
                         bool relative)
{
    if (strchr("CSQT", letter))
        return take_curve(d, text, letter, relative);
    d->mirrored = letter;
    if (letter == 'Z') {
        svg_path_add(d->path, PEL_CLOSE, NULL);
        d->at = d->start;
        return true;
    }
    return letter == 'A' ? take_arc(d, text, relative)
                         : take_line(d, text, letter, relative);
}

/* More of a command's numbers repeat it; those of M go on as lines. */
bool svg_path_data(struct svg_path *path, const char **text)
{
    struct data d = {.path = path};
    char letter = 'M';
    bool relative = false, begun = false;
    while (*(*text += strspn(*text, " \t\r\n\f,"))) {
        const char c = **text;
        const bool is_letter = c > 0 && strchr("MLHVCSQTAZmlhvcsqtaz", c);
        if (is_letter) {
            relative = c >= 'a';
            letter = (char)(c & ~32);
            ++*text;
        } else if (!begun || letter == 'Z')
            return false;
        if (!begun && letter != 'M')
            return false;
        begun = true;
        if (!take_command(&d, text, letter, relative))
            return false;
        if (letter == 'M')
            letter = 'L';
    }
    return true;
}

void svg_path_rect(struct svg_path *path, const double box[4], double rx,
                   double ry)
{
    /* Where corner i lies, and how its curve goes on from there. */
    const double x[4] = {box[2], box[2], box[0], box[0]};
    const double y[4] = {box[1], box[3], box[3], box[1]};
    static const int sx[4] = {-1, 0, 1, 0}, sy[4] = {0, -1, 0, 1};
    const struct svg_point start = {box[0] + rx, box[1]};
    svg_path_add(path, PEL_MOVE, &start);
    for (int i = 0; i < 4; i++) {
        const int next = (i + 1) % 4;
        const struct svg_point from = {x[i] + sx[i] * rx, y[i] + sy[i] * ry};
        const struct svg_point to = {x[i] - sx[next] * rx,
                                     y[i] - sy[next] * ry};
        const struct svg_point v[3] = {
            {from.x - sx[i] * rx * quarter, from.y - sy[i] * ry * quarter},
            {to.x + sx[next] * rx * quarter, to.y + sy[next] * ry * quarter},
            to};
        const struct svg_point *const last = &path->point[path->points - 1];
        if (!path->failed && (last->x != from.x || last->y != from.y))
            svg_path_add(path, PEL_LINE, &from);
        if (rx > 0 && ry > 0)
            svg_path_add(path, PEL_CUBIC, v);
    }
    svg_path_add(path, PEL_CLOSE, NULL);
}

static void grow(double box[4], struct svg_point p)
{
    box[0] = fmin(box[0], p.x);
    box[1] = fmin(box[1], p.y);
    box[2] = fmax(box[2], p.x);
    box[3] = fmax(box[3], p.y);
}

static struct svg_point curve_at(const struct svg_point *v, int n, double t)
{
    const double s = 1 - t;
    const double w[2][4] = {
        {s * s, 2 * s * t, t * t, 0},
        {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t}};
    struct svg_point p = {0, 0};
    for (int i = 0; i <= n; i++) {
        p.x += w[n - 2][i] * v[i].x;
        p.y += w[n - 2][i] * v[i].y;
    }
    return p;
}

/* Curves by 64 of their points: below 1 / 8,000 of their size. */
void svg_path_box(const struct svg_path *path, const struct svg_matrix *matrix,
                  double box[4])
{
    static const int points[] = {1, 1, 2, 3, 0};
    struct svg_point v[4] = {{0, 0}};
    const struct svg_point *next = path->point;
    box[0] = box[1] = HUGE_VAL;
    box[2] = box[3] = -HUGE_VAL;
    for (size_t i = 0; i < path->verbs; i++) {
        const int n = points[path->verb[i]];
        for (int k = 1; k <= n; k++, next++)
            v[k] = svg_at(matrix, next->x, next->y);
        for (int t = 1; n > 1 && t < 64; t++)
            grow(box, curve_at(v, n, t / 64.0));
        if (n > 0) {
            grow(box, v[n]);
            v[0] = v[n];
        }
    }
}
