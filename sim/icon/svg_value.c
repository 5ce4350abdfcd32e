/* Numbers, lengths, colours and transforms. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "sim/icon/svg.h"

static const char blanks[] = " \t\r\n\f";

/* Digits, at least one, with one point in or around them. */
static size_t digits_of(const char *text)
{
    const size_t whole = strspn(text, "0123456789");
    const size_t rest =
        text[whole] == '.' ? strspn(text + whole + 1, "0123456789") : 0;
    return whole + rest == 0 ? 0 : whole + (text[whole] == '.') + rest;
}

bool svg_number(const char **text, double *value)
{
    const char *at = *text + strspn(*text, blanks);
    char copy[64];
    if (*at == ',')
        at += 1 + strspn(at + 1, blanks);
    const size_t sign = *at == '+' || *at == '-';
    size_t n = digits_of(at + sign);
    if (n == 0)
        return false;
    n += sign;
    if (at[n] == 'e' || at[n] == 'E') {
        const size_t more = at[n + 1] == '+' || at[n + 1] == '-';
        const size_t exponent = strspn(at + n + 1 + more, "0123456789");
        n += exponent ? 1 + more + exponent : 0;
    }
    *text = at + n;
    snprintf(copy, sizeof copy, "%.*s", (int)(n < 63 ? n : 63), at);
    *value = strtod(copy, NULL);
    return fabs(*value) <= 1e7;
}

bool svg_length(const char *text, struct svg_length *to)
{
    static const struct {
        const char *name;
        double px;
    } units[] = {{"", 1},    {"px", 1},  {"%", 0.01},       {"pt", 4.0 / 3},
                 {"pc", 16}, {"in", 96}, {"cm", 96 / 2.54}, {"mm", 9.6 / 2.54}};
    *to = (struct svg_length){.given = true};
    if (!svg_number(&text, &to->value))
        return false;
    const size_t n = strcspn(text, blanks);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strlen(units[i].name) == n &&
            strncasecmp(text, units[i].name, n) == 0) {
            to->value *= units[i].px;
            to->percent = *text == '%';
            return text[n + strspn(text + n, blanks)] == '\0';
        }
    return false;
}

static bool named_color(const char *text, size_t n, pel_color *color)
{
    static const struct {
        const char *name;
        pel_color color;
    } names[] = {
        {"black", 0x000000},   {"silver", 0xC0C0C0}, {"gray", 0x808080},
        {"grey", 0x808080},    {"white", 0xFFFFFF},  {"maroon", 0x800000},
        {"red", 0xFF0000},     {"purple", 0x800080}, {"fuchsia", 0xFF00FF},
        {"magenta", 0xFF00FF}, {"green", 0x008000},  {"lime", 0x00FF00},
        {"olive", 0x808000},   {"yellow", 0xFFFF00}, {"navy", 0x000080},
        {"blue", 0x0000FF},    {"teal", 0x008080},   {"aqua", 0x00FFFF},
        {"cyan", 0x00FFFF},    {"orange", 0xFFA500}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strlen(names[i].name) == n &&
            strncasecmp(text, names[i].name, n) == 0) {
            *color = names[i].color | PEL_RGB(0, 0, 0);
            return true;
        }
    return false;
}

/* #rgb or #rrggbb, of n digits. */
static bool hex_color(const char *digits, size_t n, pel_color *color)
{
    if (strspn(digits, "0123456789abcdefABCDEF") != n || (n != 3 && n != 6))
        return false;
    const pel_color v = (pel_color)strtoul(digits, NULL, 16);
    *color =
        n == 6 ? PEL_RGB(v >> 16, v >> 8, v)
               : PEL_RGB((v >> 8 & 15) * 17, (v >> 4 & 15) * 17, (v & 15) * 17);
    return true;
}

/* rgb(1, 2, 3), or of percents, behind its bracket. */
static bool function_color(const char *text, pel_color *color)
{
    unsigned v[3];
    for (int i = 0; i < 3; i++) {
        double n;
        if (!svg_number(&text, &n))
            return false;
        n *= *text == '%' ? 2.55 : 1;
        text += *text == '%';
        v[i] = (unsigned)lround(fmin(fmax(n, 0), 255));
    }
    text += strspn(text, blanks);
    *color = PEL_RGB(v[0], v[1], v[2]);
    return *text == ')';
}

/* What stands behind it, as icc-color(...), is left out. */
bool svg_color(const char *text, pel_color *color)
{
    text += strspn(text, blanks);
    const size_t n = strcspn(text, blanks);
    if (*text == '#')
        return hex_color(text + 1, n - 1, color);
    if (strncasecmp(text, "rgb(", 4) == 0)
        return function_color(text + 4, color);
    return named_color(text, n, color);
}

struct svg_matrix svg_times(const struct svg_matrix *a,
                            const struct svg_matrix *b)
{
    return (struct svg_matrix){
        a->a * b->a + a->c * b->b,        a->b * b->a + a->d * b->b,
        a->a * b->c + a->c * b->d,        a->b * b->c + a->d * b->d,
        a->a * b->e + a->c * b->f + a->e, a->b * b->e + a->d * b->f + a->f};
}

/* One function of n numbers. */
static bool function_matrix(const char *name, size_t length, const double *v,
                            int n, struct svg_matrix *m)
{
    const double turn = v[0] * 3.14159265358979323846 / 180;
    const double c = cos(turn), s = sin(turn);
#define IS(word) (length == sizeof word - 1 && strncmp(name, word, length) == 0)
    if (IS("matrix") && n == 6)
        *m = (struct svg_matrix){v[0], v[1], v[2], v[3], v[4], v[5]};
    else if (IS("translate") && (n == 1 || n == 2))
        *m = (struct svg_matrix){1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
    else if (IS("scale") && (n == 1 || n == 2))
        *m = (struct svg_matrix){v[0], 0, 0, v[n - 1], 0, 0};
    else if (IS("rotate") && (n == 1 || n == 3))
        *m = (struct svg_matrix){c,
                                 s,
                                 -s,
                                 c,
                                 v[1] - c * v[1] + s * v[2],
                                 v[2] - s * v[1] - c * v[2]};
    else if (IS("skewX") && n == 1)
        *m = (struct svg_matrix){1, 0, tan(turn), 1, 0, 0};
    else if (IS("skewY") && n == 1)
        *m = (struct svg_matrix){1, tan(turn), 0, 1, 0, 0};
    else
        return false;
    return true;
#undef IS
}

/* Multiplies the matrix by a list of functions. */
bool svg_transform(const char *text, struct svg_matrix *matrix)
{
    while (*(text += strspn(text, " \t\r\n\f,"))) {
        const char *const name = text;
        const size_t length = strcspn(text, " \t\r\n\f(");
        double v[7] = {0};
        struct svg_matrix m;
        int n = 0;
        text += length;
        text += strspn(text, blanks);
        if (*text++ != '(')
            return false;
        while (n < 7 && svg_number(&text, &v[n]))
            n++;
        text += strspn(text, blanks);
        if (*text++ != ')' || !function_matrix(name, length, v, n, &m))
            return false;
        *matrix = svg_times(matrix, &m);
    }
    return true;
}
