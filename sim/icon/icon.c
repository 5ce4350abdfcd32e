#include "sim/icon/icon.h"

#include <math.h>
#include <stdlib.h>

#include "core/pel.h"
#include "sim/cli/child.h"
#include "sim/cli/message.h"
#include "sim/icon/svg.h"
#include "sim/image/canvas.h"

static bool put_icon(const void *what, FILE *out)
{
    struct svg svg;
    struct pel_icon_asset icon;
    if (!svg_read(&svg, what) || !svg_to_asset(&svg, &icon))
        return false;
    fwrite(&icon, sizeof icon, 1, out);
    child_put(out, icon.part, icon.parts * sizeof *icon.part);
    child_put(out, icon.gradient, icon.gradients * sizeof *icon.gradient);
    child_put(out, icon.stop, icon.stops * sizeof *icon.stop);
    child_put(out, icon.verb, icon.verbs);
    child_put(out, icon.point, icon.points * 2 * sizeof *icon.point);
    return true;
}

bool icon_load(struct pel_icon_asset *icon, const char *path)
{
    size_t size;
    FILE *in = child_run(path, put_icon, path);
    bool done = in && fread(icon, sizeof *icon, 1, in) == 1;
    if (!done)
        *icon = (struct pel_icon_asset){.magic = 0};
    icon->part = done ? child_get(in, &size, &done) : NULL;
    icon->gradient = done ? child_get(in, &size, &done) : NULL;
    icon->stop = done ? child_get(in, &size, &done) : NULL;
    icon->verb = done ? child_get(in, &size, &done) : NULL;
    icon->point = done ? child_get(in, &size, &done) : NULL;
    icon->painter = icon->gradients ? &pel_icon_gradients : NULL;
    if (in)
        fclose(in);
    if (done && pel_icon_asset_check(icon) != PEL_OK)
        done = message_error_at(path, 0, "is no icon");
    if (!done)
        icon_free(icon);
    return done;
}

void icon_free(struct pel_icon_asset *icon)
{
    free((void *)(uintptr_t)icon->part);
    free((void *)(uintptr_t)icon->gradient);
    free((void *)(uintptr_t)icon->stop);
    free((void *)(uintptr_t)icon->verb);
    free((void *)(uintptr_t)icon->point);
    *icon = (struct pel_icon_asset){.magic = 0};
}

const struct pel_icon_kind *icon_kind(const struct pel_icon_asset *icon,
                                      bool smooth)
{
    if (icon->strokes)
        return smooth ? &pel_icon_smooth_strokes : &pel_icon_aliased_strokes;
    return smooth ? &pel_icon_smooth : &pel_icon_aliased;
}

/* Sides that come to be in a row at one place: `sides`, or more. A column of
 * the icon has all that are in its rows. From angle to angle the corners move
 * by 2 px or so, and half a pixel down or up. */
static bool count_sides(const struct pel_surface *column,
                        struct pel_icon_shape *shape, int32_t size,
                        int32_t *sides)
{
    const int32_t half = column->bounds.y1 * 128, turns = pel_max(2 * size, 32);
    const size_t most = PEL_ICON_SCRATCH_SIZE(65536, 1);
    void *scratch = malloc(most);
    for (int32_t i = 0; i < turns; i++)
        while (scratch && *sides < 65536 &&
               pel_icon_place(shape, PEL_PX(size), i * 65536 / turns,
                              (struct pel_point){128, half + i % 2 * 128}) ==
                   PEL_OK &&
               pel_icon(column, shape, scratch,
                        PEL_ICON_SCRATCH_SIZE(*sides, 1)) == PEL_ERROR_SCRATCH)
            *sides += 1 + *sides / 16;
    free(scratch);
    return scratch || message_error("out of memory");
}

bool icon_need(struct icon_need *need, const struct pel_icon_asset *icon)
{
    const int32_t side = pel_max(icon->width, icon->height);
    const double across =
        hypot(icon->right - icon->left, icon->bottom - icon->top);
    struct pel_icon_shape shape = {.icon = icon, .kind = icon_kind(icon, true)};
    struct canvas canvas;
    bool done = canvas_init(&canvas, &pel_gray8, 1, 3 * ICON_SCRATCH_SIZE_MAX);
    need->sides = 1;
    need->width = (int32_t)ceil(across * 1024 / side);
    for (int32_t size = ICON_SCRATCH_SIZE_MAX;
         done && size >= ICON_SCRATCH_SIZE_MIN; size = size * 2 / 3)
        done = count_sides(&canvas.surface, &shape, size, &need->sides);
    need->sides += need->sides / 4 + 4;
    canvas_free(&canvas);
    return done;
}

/* Over black and over white: what is between the two is not covered. */
static pel_color uncover(pel_color black, pel_color white)
{
    const uint32_t dark[3] = {pel_red(black), pel_green(black),
                              pel_blue(black)};
    const uint32_t light[3] = {pel_red(white), pel_green(white),
                               pel_blue(white)};
    uint32_t clear = 0, v[3];
    for (int i = 0; i < 3; i++)
        clear += light[i] - dark[i];
    const uint32_t alpha = 255 - (clear + 1) / 3;
    if (alpha == 0 || alpha > 255)
        return 0;
    for (int i = 0; i < 3; i++)
        v[i] = (uint32_t)pel_min((int32_t)((dark[i] * 255 + alpha / 2) / alpha),
                                 255);
    return PEL_RGBA(v[0], v[1], v[2], alpha);
}

/* On a background of one colour. */
static bool draw(struct picture *picture, const struct pel_icon_shape *shape,
                 const int size[2], pel_color background)
{
    struct canvas canvas;
    if (!canvas_init(&canvas, &pel_xrgb8888, size[0], size[1]))
        return false;
    const size_t bytes = PEL_ICON_SCRATCH_SIZE(65536, size[0]);
    void *scratch = malloc(bytes);
    pel_clear(&canvas.surface, background);
    const bool done =
        scratch && pel_icon(&canvas.surface, shape, scratch, bytes) == PEL_OK
            ? canvas_picture(&canvas, picture)
            : message_error("the icon cannot be drawn");
    free(scratch);
    canvas_free(&canvas);
    return done;
}

bool icon_picture(struct picture *picture, const struct pel_icon_asset *icon,
                  int side)
{
    const int units = pel_max(icon->width, icon->height);
    const int size[2] = {pel_max((icon->width * side + units / 2) / units, 1),
                         pel_max((icon->height * side + units / 2) / units, 1)};
    struct picture white = {0, 0, NULL};
    struct pel_icon_shape shape = {
        .icon = icon, .kind = icon_kind(icon, true), .color = PEL_RGB(0, 0, 0)};
    pel_icon_place(&shape, PEL_PX(side), 0,
                   (struct pel_point){size[0] * 128, size[1] * 128});
    *picture = white;
    const bool done = draw(picture, &shape, size, PEL_RGB(0, 0, 0)) &&
                      draw(&white, &shape, size, PEL_RGB(255, 255, 255));
    for (int i = 0; done && i < size[0] * size[1]; i++)
        picture->pixels[i] = uncover(picture->pixels[i], white.pixels[i]);
    picture_free(&white);
    if (!done)
        picture_free(picture);
    return done;
}
