/* The window of pel view. */
#include <string.h>

#include "sim/cli/message.h"
#include "sim/view/viewer.h"

#ifdef HAVE_SDL2
#include "port/sdl/window_sdl.h"

struct window {
    struct pel_window_sdl sdl;
    struct viewer *viewer;
    char title[VIEWER_TITLE_SIZE];
};

static bool fails(const struct window *w)
{
    return message_error("%s: expected a screen, or --device auto, or pel "
                         "render",
                         w->sdl.message);
}

static bool draw(struct window *w)
{
    const struct pel_surface *surface = &w->sdl.surface;
    bool anew;
    if (!pel_window_sdl_fit(&w->sdl, &anew))
        return fails(w);
    if ((anew &&
         !viewer_resize(w->viewer, surface->bounds.x1, surface->bounds.y1)) ||
        !viewer_draw(w->viewer, surface))
        return false;
    return pel_window_sdl_show(&w->sdl) || fails(w);
}

/* With all that was done before. */
static bool save_new(struct window *w)
{
    return (!w->viewer->stale || draw(w)) &&
           viewer_save(w->viewer, &w->sdl.surface, false);
}

/* Handles the events that have come; waits a moment for one when there is
 * nothing to draw. */
static bool handle_all(struct window *w)
{
    struct pel_input input;
    int ms = viewer_idle(w->viewer);
    enum pel_window_event event;
    while ((event = pel_window_sdl_event(&input, ms)) != PEL_WINDOW_NOTHING) {
        w->viewer->over = w->viewer->over || event == PEL_WINDOW_CLOSE;
        w->viewer->stale = w->viewer->stale || event == PEL_WINDOW_REDRAW;
        if (event == PEL_WINDOW_INPUT && viewer_input(w->viewer, &input) &&
            !save_new(w))
            return false;
        ms = 0;
    }
    return !viewer_inputs(w->viewer) || save_new(w);
}

static void set_title(struct window *w)
{
    char title[VIEWER_TITLE_SIZE];
    viewer_title(w->viewer, title);
    if (strcmp(title, w->title) == 0)
        return;
    strcpy(w->title, title);
    pel_window_sdl_title(&w->sdl, title);
}

/* The first picture is there before the first key. */
static bool run(struct window *w)
{
    struct viewer *viewer = w->viewer;
    bool good = true;
    while (good && !viewer_is_over(viewer)) {
        viewer_advance(viewer);
        good = !viewer->stale || draw(w);
        set_title(w);
        good = good && handle_all(w);
    }
    return good && viewer_save(viewer, &w->sdl.surface, true);
}

/* Frames wait for the screen's refresh, unless --frames wants them as fast as
 * it goes or the show has a period of its own. */
static bool open_window(struct window *w)
{
    const struct show *show = w->viewer->show;
    const struct viewer_options *o = w->viewer->options;
    const struct pel_window_sdl_options options = {
        .title = "pel view",
        .width = o->width ? o->width : show->width,
        .height = o->height ? o->height : show->height,
        .refresh = o->frames == 0 && show->period <= 0};
    return pel_window_sdl_open(&w->sdl, &options) || fails(w);
}

bool view_window(struct show *show, const struct viewer_options *options)
{
    struct viewer viewer;
    struct window w = {.viewer = &viewer};
    /* all but the buttons comes with the window */
    const struct pel_input_linux_options buttons = {.buttons = options->buttons,
                                                    .no_devices = true};
    viewer_init(&viewer, show, options);
    const bool done =
        open_window(&w) &&
        (!buttons.buttons || viewer_open_input(&viewer, &buttons)) && run(&w);
    if (done && options->frames > 0)
        viewer_report(&viewer);
    viewer_free(&viewer);
    pel_window_sdl_close(&w.sdl);
    return done;
}

#else

bool view_window(struct show *show, const struct viewer_options *options)
{
    (void)show;
    (void)options;
    return message_error("built without SDL2, which opens windows: install "
                         "libsdl2-dev and make again, or use --device auto");
}

#endif
