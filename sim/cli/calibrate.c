/* pel input --calibrate: crosses to touch, and the matrix that follows. */
#include "sim/cli/calibrate.h"

#include <math.h>

#include "core/raster/line.h"
#include "core/raster/rectangle.h"
#include "port/linux/input.h"
#include "sim/cli/message.h"
#include "sim/cli/output.h"

enum {
    CROSSES = 4, /* the last one checks the three before */
    ARM = 12,    /* px */
    FINE = 32767 /* places are told in parts of this */
};

struct calibration {
    struct pel_display_linux screen;
    struct pel_input_linux input;
    int32_t shown; /* the cross */
    struct pel_touch_place told[CROSSES];
};

static struct pel_point cross_at(const struct calibration *c, int32_t i)
{
    static const double at[CROSSES][2] = {
        {.12, .12}, {.88, .5}, {.5, .88}, {.75, .2}};
    return (struct pel_point){(int32_t)(at[i][0] * c->screen.display.width),
                              (int32_t)(at[i][1] * c->screen.display.height)};
}

/* Its middle, as parts of the screen. */
static struct pel_touch_place place_of(const struct calibration *c, int32_t i)
{
    const struct pel_point p = cross_at(c, i);
    return (struct pel_touch_place){(p.x + .5) / c->screen.display.width,
                                    (p.y + .5) / c->screen.display.height};
}

static bool draw_cross(struct pel_surface *surface,
                       struct pel_dirty_areas *changed, void *context)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct calibration *const c = context;
    const struct pel_point p = cross_at(c, c->shown);
    const struct pel_rect across = {p.x - ARM, p.y, p.x + ARM + 1, p.y + 1};
    const struct pel_rect down = {p.x, p.y - ARM, p.x + 1, p.y + ARM + 1};
    pel_box(surface, &across, &white.paint);
    pel_box(surface, &down, &white.paint);
    pel_dirty_areas_add(changed, &surface->clip);
    return true;
}

static bool show_cross(struct calibration *c, int32_t i)
{
    c->shown = i;
    return device_frame(&c->screen, draw_cross, c);
}

/* Where the finger was when it was lifted. False: a key ended it, or a message
 * says why. */
static bool wait_touch(struct calibration *c, struct pel_touch_place *place)
{
    for (;;) {
        struct pel_input e;
        const enum pel_console_event event =
            pel_display_linux_wait(&c->screen, 0);
        if (event == PEL_CONSOLE_KEY)
            return message_error("calibration: ended by a key");
        if (event == PEL_CONSOLE_REDRAW && !show_cross(c, c->shown))
            return false;
        if (!pel_input_linux_wait(&c->input, 100, &e) ||
            e.kind != PEL_INPUT_TOUCH || e.code != 0)
            continue;
        *place = (struct pel_touch_place){(e.x + .5) / FINE, (e.y + .5) / FINE};
        if (e.state == PEL_INPUT_UP)
            return true;
    }
}

/* How far the matrix is off where the last cross was touched, in px. */
static double miss(const struct calibration *c,
                   const struct pel_touch_matrix *matrix)
{
    const struct pel_touch_place at =
        pel_touch_matrix_place(matrix, c->told[CROSSES - 1]);
    const struct pel_touch_place shown = place_of(c, CROSSES - 1);
    return hypot((at.x - shown.x) * c->screen.display.width,
                 (at.y - shown.y) * c->screen.display.height);
}

static bool save(const struct pel_touch_matrix *m, const char *path)
{
    struct output output;
    if (!output_open(&output, path))
        return false;
    fprintf(output.stream,
            "# For PEL_TOUCH=FILE, or a rule of udev for libinput.\n"
            "LIBINPUT_CALIBRATION_MATRIX=\"%.6f %.6f %.6f %.6f %.6f %.6f\"\n",
            m->a, m->b, m->c, m->d, m->e, m->f);
    return output_commit(&output);
}

static bool touch_all(struct calibration *c, const char *path)
{
    struct pel_touch_place shown[CROSSES];
    struct pel_touch_matrix matrix;
    for (int32_t i = 0; i < CROSSES; i++) {
        shown[i] = place_of(c, i);
        if (!show_cross(c, i) || !wait_touch(c, &c->told[i]))
            return false;
    }
    if (!pel_touch_matrix_solve(&matrix, c->told, shown))
        return message_error("calibration: the crosses were not touched where "
                             "they are; begin again");
    const double off = miss(c, &matrix);
    const double most =
        .03 * fmax(c->screen.display.width, c->screen.display.height);
    if (!(off <= most))
        return message_error("calibration: the last cross was missed by %.0f "
                             "px; begin again",
                             off);
    message_error("%s: the last cross was met within %.1f px", path, off);
    return save(&matrix, path);
}

bool calibrate(const struct device_options *device, const char *path)
{
    static struct calibration c;
    const struct pel_input_linux_options options = {
        .no_keys = true, .width = FINE, .height = FINE, .touch = "rotate=0"};
    if (!device_open(&c.screen, device, PEL_FB_STILL))
        return false;
    bool done = pel_input_linux_open(&c.input, &options) == 0 ||
                message_error("%s", c.input.message.text);
    done = done && touch_all(&c, path);
    pel_input_linux_close(&c.input);
    pel_display_linux_close(&c.screen);
    return done;
}
