#include "touch_matrix.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct pel_touch_place pel_touch_matrix_place(const struct pel_touch_matrix *m,
                                              struct pel_touch_place p)
{
    return (struct pel_touch_place){m->a * p.x + m->b * p.y + m->c,
                                    m->d * p.x + m->e * p.y + m->f};
}

/* What `first` does, and then `then`. */
static struct pel_touch_matrix combined(const struct pel_touch_matrix *then,
                                        const struct pel_touch_matrix *first)
{
    return (struct pel_touch_matrix){
        then->a * first->a + then->b * first->d,
        then->a * first->b + then->b * first->e,
        then->a * first->c + then->b * first->f + then->c,
        then->d * first->a + then->e * first->d,
        then->d * first->b + then->e * first->e,
        then->d * first->c + then->e * first->f + then->f};
}

/* Six numbers, in quotes or not, and nothing but a remark behind them. */
static bool read_numbers(struct pel_touch_matrix *m, const char *text)
{
    double *const value[6] = {&m->a, &m->b, &m->c, &m->d, &m->e, &m->f};
    text += strspn(text, "\" \t");
    for (int i = 0; i < 6; i++) {
        char *end;
        *value[i] = strtod(text, &end);
        if (end == text || !(*value[i] > -1000 && *value[i] < 1000))
            return false;
        text = end;
    }
    text += strspn(text, "\" \t\r\n");
    return *text == 0 || *text == '#';
}

/* Also behind something, as `NAME="1 0 0 0 1 0"`. */
static bool read_line(struct pel_touch_matrix *m, const char *line)
{
    line += strspn(line, " \t");
    if (*line == '#')
        return false;
    while (!read_numbers(m, line)) {
        line = strchr(line, '=');
        if (!line)
            return false;
        line++;
    }
    return true;
}

static int read_file(struct pel_touch_matrix *matrix, const char *path,
                     struct pel_message *message)
{
    char *line = NULL;
    size_t size = 0;
    bool found = false;
    FILE *file = fopen(path, "re");
    if (!file)
        return pel_message_errno(message, path);
    while (getline(&line, &size, file) > 0) {
        struct pel_touch_matrix m;
        if (read_line(&m, line)) {
            *matrix = m;
            found = true;
        }
    }
    free(line);
    fclose(file);
    return found ? 0
                 : pel_message_set(message, EINVAL,
                                   "%s has no line with six numbers; pel input "
                                   "--calibrate writes one",
                                   path);
}

static bool read_range(struct pel_touch_matrix *m, const char *text)
{
    double from_x, to_x, from_y, to_y;
    char more;
    if (sscanf(text, "%lf:%lf:%lf:%lf%c", &from_x, &to_x, &from_y, &to_y,
               &more) != 4 ||
        !(to_x - from_x > .01) || !(to_y - from_y > .01) || !(from_x > -100) ||
        !(from_y > -100) || !(to_x < 100) || !(to_y < 100))
        return false;
    *m = (struct pel_touch_matrix){
        1 / (to_x - from_x),       0,
        -from_x / (to_x - from_x), 0,
        1 / (to_y - from_y),       -from_y / (to_y - from_y)};
    return true;
}

/* A picture that is turned clockwise shows (u, v) of the screen at (v, 1 - u).
 */
static const struct {
    const char *name;
    struct pel_touch_matrix matrix;
} words[] = {
    {"swap", {0, 1, 0, 1, 0, 0}},       {"invert-x", {-1, 0, 1, 0, 1, 0}},
    {"invert-y", {1, 0, 0, 0, -1, 1}},  {"rotate=0", PEL_TOUCH_SAME},
    {"rotate=90", {0, 1, 0, -1, 0, 1}}, {"rotate=180", {-1, 0, 1, 0, -1, 1}},
    {"rotate=270", {0, -1, 1, 1, 0, 0}}};

static int parse_word(struct pel_touch_matrix *matrix, const char *word,
                      struct pel_message *message)
{
    if (word[0] == '/' || word[0] == '.')
        return read_file(matrix, word, message);
    if (strncmp(word, "range=", 6) == 0 && read_range(matrix, word + 6))
        return 0;
    for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++)
        if (strcmp(word, words[i].name) == 0) {
            *matrix = words[i].matrix;
            return 0;
        }
    return pel_message_set(message, EINVAL,
                           "touch: '%.100s': expected swap, invert-x, "
                           "invert-y, rotate=90 (180, 270), "
                           "range=0.05:0.95:0.1:0.9 or a file, /etc/touch",
                           word);
}

int pel_touch_matrix_parse(struct pel_touch_matrix *matrix, const char *text,
                           struct pel_message *message)
{
    char word[300];
    *matrix = (struct pel_touch_matrix)PEL_TOUCH_SAME;
    for (size_t n; *text; text += n + (text[n] == ',')) {
        struct pel_touch_matrix next = PEL_TOUCH_SAME;
        n = strcspn(text, ",");
        if (n >= sizeof(word))
            return pel_message_set(message, EINVAL, "touch: too long a word");
        memcpy(word, text, n);
        word[n] = 0;
        const int error = parse_word(&next, word, message);
        if (error)
            return error;
        *matrix = combined(&next, matrix);
    }
    return 0;
}

/* Twice the area, with the sign of the direction of turn. */
static double area(const struct pel_touch_place p[3])
{
    return (p[1].x - p[0].x) * (p[2].y - p[0].y) -
           (p[2].x - p[0].x) * (p[1].y - p[0].y);
}

static double square(const struct pel_touch_place *p,
                     const struct pel_touch_place *q)
{
    const double x = p->x - q->x, y = p->y - q->y;
    return x * x + y * y;
}

bool pel_touch_matrix_solve(struct pel_touch_matrix *m,
                            const struct pel_touch_place told[3],
                            const struct pel_touch_place shown[3])
{
    const double whole = area(told);
    for (int i = 0; i < 3; i++) {
        const int k = (i + 1) % 3;
        const double distance = square(&told[i], &told[k]);
        const double asked = square(&shown[i], &shown[k]);
        if (!(distance > asked / 25 && distance < asked * 25))
            return false;
    }
    if (!(whole > 0 ? whole > .005 : whole < -.005))
        return false;
    const double x1 = told[1].x - told[0].x, y1 = told[1].y - told[0].y;
    const double x2 = told[2].x - told[0].x, y2 = told[2].y - told[0].y;
    const double p1 = shown[1].x - shown[0].x, p2 = shown[2].x - shown[0].x;
    const double q1 = shown[1].y - shown[0].y, q2 = shown[2].y - shown[0].y;
    m->a = (p1 * y2 - p2 * y1) / whole;
    m->b = (p2 * x1 - p1 * x2) / whole;
    m->c = shown[0].x - m->a * told[0].x - m->b * told[0].y;
    m->d = (q1 * y2 - q2 * y1) / whole;
    m->e = (q2 * x1 - q1 * x2) / whole;
    m->f = shown[0].y - m->d * told[0].x - m->e * told[0].y;
    return true;
}
