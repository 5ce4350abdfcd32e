/* pel view on a framebuffer or DRM device. */
#include <stdio.h>

#include "core/raster/rectangle.h"
#include "sim/view/viewer.h"

struct screen {
    struct pel_display_linux linux;
    struct pel_rect area; /* where the picture is */
    struct viewer viewer;
    struct pel_rect cross; /* around the pointer; empty: none is shown */
    bool whole;            /* the next frame is sent whole */
};

/* A cross at the pointer, white with a black edge. */
static void draw_pointer(struct screen *s, const struct pel_surface *surface)
{
    enum { ARM = 7 };
    static const struct pel_flat inks[2] = {PEL_FLAT(PEL_RGB(255, 255, 255)),
                                            PEL_FLAT(PEL_RGB(0, 0, 0))};
    const int32_t x = s->area.x0 + s->viewer.pointer[0];
    const int32_t y = s->area.y0 + s->viewer.pointer[1];
    for (int32_t edge = 1; edge >= 0; edge--) {
        const int32_t arm = ARM + edge;
        const struct pel_rect bars[2] = {
            {x - arm, y - edge, x + arm + 1, y + edge + 1},
            {x - edge, y - arm, x + edge + 1, y + arm + 1}};
        for (int k = 0; k < 2; k++)
            pel_box(surface, &bars[k], &inks[edge].paint);
    }
    s->cross =
        (struct pel_rect){x - ARM - 1, y - ARM - 1, x + ARM + 2, y + ARM + 2};
    s->cross = pel_rect_intersect(&s->cross, &surface->clip);
}

static bool draw_view(struct pel_surface *surface,
                      struct pel_dirty_areas *changed, void *context)
{
    struct screen *s = context;
    struct viewer *viewer = &s->viewer;
    if (s->whole)
        pel_dirty_areas_add(changed, &surface->clip);
    pel_surface_clip(surface, &s->area);
    const bool done = viewer_draw(viewer, surface);
    pel_dirty_areas_add(changed, &s->cross);
    if (viewer->has_pointer)
        draw_pointer(s, surface);
    pel_dirty_areas_add(changed, &s->cross);
    for (int i = 0; i < viewer->show->changed.count; i++)
        pel_dirty_areas_add(changed, &viewer->show->changed.area[i]);
    s->whole = viewer->pointed = false;
    return done;
}

/* Draws the picture once more, into a canvas: what was handed to the display
 * may have changed since. */
static bool save(struct screen *s, bool last)
{
    struct canvas canvas;
    if (last && !s->viewer.options->output)
        return true;
    if (!canvas_init(&canvas, s->linux.display.format, s->area.x1 - s->area.x0,
                     s->area.y1 - s->area.y0))
        return false;
    struct show *show = s->viewer.show;
    const bool done = show->draw(show, &canvas.surface) &&
                      viewer_save(&s->viewer, &canvas.surface, last);
    canvas_free(&canvas);
    s->whole = true; /* what has changed since the last frame is not known */
    return done;
}

/* The key of a sequence of `used` bytes with this last one: an arrow, or F1 to
 * F5, whose sequences begin with SS3, or with CSI [ on a virtual terminal. */
static int sequence_key(size_t used, bool ss3, char end)
{
    static const int arrows[4] = {PEL_KEY_UP, PEL_KEY_DOWN, PEL_KEY_RIGHT,
                                  PEL_KEY_LEFT};
    if (used == 3 && end >= 'A' && end <= 'D')
        return arrows[end - 'A'];
    if (used == 3 && ss3 && end >= 'P' && end <= 'S')
        return PEL_KEY_F1 + end - 'P';
    return used == 4 && !ss3 && end >= 'A' && end <= 'E'
               ? PEL_KEY_F1 + end - 'A'
               : PEL_KEY_OTHER;
}

int view_terminal_key(const char *bytes, size_t count, size_t *used)
{
    *used = 1;
    if (bytes[0] != PEL_KEY_ESCAPE || count < 2 ||
        (bytes[1] != '[' && bytes[1] != 'O'))
        return bytes[0] == '\n' ? PEL_KEY_ENTER : (unsigned char)bytes[0];
    *used = 2;
    /* Parameters and intermediate bytes, then a final one. */
    while (*used < count && bytes[*used] >= 0x20 && bytes[*used] < 0x40)
        ++*used;
    char end = *used < count ? bytes[(*used)++] : '\0';
    if (*used == 3 && end == '[' && *used < count)
        end = bytes[(*used)++];
    return sequence_key(*used, bytes[1] == 'O', end);
}

/* Handles the keys of the terminal that have come; waits a moment for one, or
 * for other input, when there is nothing to draw. A terminal that has ended
 * ends the view, but not when frames are counted. */
static bool handle_keys(struct screen *s)
{
    struct viewer *viewer = &s->viewer;
    struct pel_input key = {.kind = PEL_INPUT_KEY, .state = PEL_INPUT_DOWN};
    char bytes[64];
    size_t count, used;
    const enum pel_console_event event = pel_console_read(
        viewer_idle(viewer), viewer->input.poll, bytes, sizeof(bytes), &count);
    if (event == PEL_CONSOLE_REDRAW)
        viewer->stale = s->whole = true;
    if (event != PEL_CONSOLE_KEY)
        return true;
    viewer->over = count == 0 && viewer->options->frames == 0;
    for (size_t i = 0; i < count; i += used) {
        key.code = (uint16_t)view_terminal_key(bytes + i, count - i, &used);
        if (viewer_input(viewer, &key) && !save(s, false))
            return false;
    }
    return true;
}

static bool run(struct screen *s)
{
    while (!viewer_is_over(&s->viewer)) {
        if (!handle_keys(s) || (viewer_inputs(&s->viewer) && !save(s, false)))
            return false;
        if (s->viewer.over)
            break;
        viewer_advance(&s->viewer);
        s->viewer.stale = s->viewer.stale || s->viewer.pointed;
        if (s->viewer.stale && !device_frame(&s->linux, draw_view, s))
            return false;
    }
    return save(s, true);
}

/* The picture in the middle; all of the screen where its size does not matter.
 */
static void place(struct screen *s, const struct viewer_options *o)
{
    const struct pel_rect *screen = &s->linux.area;
    const int width = o->width ? o->width : screen->x1;
    const int height = o->height ? o->height : screen->y1;
    s->area.x0 = pel_max(screen->x1 - width, 0) / 2;
    s->area.y0 = pel_max(screen->y1 - height, 0) / 2;
    s->area.x1 = pel_min(s->area.x0 + width, screen->x1);
    s->area.y1 = pel_min(s->area.y0 + height, screen->y1);
}

/* Prints after the console is back, where it can be read. */
bool view_device(struct show *show, const struct viewer_options *options)
{
    struct screen s = {.whole = true};
    char title[VIEWER_TITLE_SIZE];
    if (!device_open(&s.linux, options->device, PEL_FB_ANY))
        return false;
    place(&s, options);
    const int width = s.area.x1 - s.area.x0, height = s.area.y1 - s.area.y0;
    /* A virtual terminal has the keys of all keyboards, in their layouts; from
     * elsewhere the keyboards are read. */
    const struct pel_input_linux_options input = {
        .buttons = options->buttons,
        .no_keys = s.linux.has_console && !s.linux.console.text[0],
        .width = width,
        .height = height};
    viewer_init(&s.viewer, show, options);
    const bool done = viewer_open_input(&s.viewer, &input) &&
                      viewer_resize(&s.viewer, width, height) && run(&s);
    viewer_free(&s.viewer);
    pel_display_linux_close(&s.linux);
    if (done) {
        viewer_title(&s.viewer, title);
        fprintf(stderr, "%s\n", title);
        viewer_report(&s.viewer);
    }
    return done;
}
