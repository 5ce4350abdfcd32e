/* The window of pel view. */
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/view/viewer.h"

#ifdef HAVE_SDL2
#include <SDL.h>

#include "sim/image/canvas.h"
#include "core/format/formats.h"

enum { TEXTURE_SIZE_MAX = 16384, POLL_MS = 2 };

/* The picture is drawn into a canvas and carried to the window as a texture. */
struct window {
    SDL_Window *window;
    SDL_Renderer *renderer;
    SDL_Texture *texture; /* of the canvas' size */
    struct canvas canvas;
    struct viewer *viewer;
    char title[VIEWER_TITLE_SIZE];
    int most; /* px that a texture has each way; larger windows show one
                 stretched */
};

static bool fails(const char *what)
{
    return message_error("%s (%s): expected a screen, or --device auto", what,
                         SDL_GetError());
}

/* Canvas and texture of the window's size, whenever that is a new one. */
static bool fit(struct window *w)
{
    const struct pel_rect *had = &w->canvas.surface.bounds;
    int width, height;
    if (SDL_GetRendererOutputSize(w->renderer, &width, &height) != 0)
        return fails("the window's size is not known");
    width = pel_max(pel_min(width, w->most), 1);
    height = pel_max(pel_min(height, w->most), 1);
    if (w->canvas.memory && had->x1 == width && had->y1 == height)
        return true;
    canvas_free(&w->canvas);
    SDL_DestroyTexture(w->texture);
    w->texture = SDL_CreateTexture(w->renderer, SDL_PIXELFORMAT_BGRA32,
                                   SDL_TEXTUREACCESS_STREAMING, width, height);
    if (!w->texture)
        return fails("no texture of the window's size");
    SDL_SetTextureBlendMode(w->texture, SDL_BLENDMODE_NONE);
    return canvas_init(&w->canvas, &pel_xrgb8888, width, height) &&
           viewer_resize(w->viewer, width, height);
}

static bool draw(struct window *w)
{
    const struct pel_surface *surface = &w->canvas.surface;
    if (!fit(w) || !viewer_draw(w->viewer, surface))
        return false;
    if (SDL_UpdateTexture(w->texture, NULL, surface->pixels, surface->stride) !=
            0 ||
        SDL_RenderCopy(w->renderer, w->texture, NULL, NULL) != 0)
        return fails("the picture cannot be shown");
    SDL_RenderPresent(w->renderer);
    return true;
}

static int key_of(SDL_Keycode code)
{
    static const int keys[][2] = {
        {SDLK_LEFT, PEL_KEY_LEFT},      {SDLK_RIGHT, PEL_KEY_RIGHT},
        {SDLK_UP, PEL_KEY_UP},          {SDLK_DOWN, PEL_KEY_DOWN},
        {SDLK_KP_ENTER, PEL_KEY_ENTER}, {SDLK_KP_PLUS, '+'},
        {SDLK_KP_MINUS, '-'},           {SDLK_F2, PEL_KEY_F1 + 1},
        {SDLK_F3, PEL_KEY_F1 + 2},
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i][0] == code)
            return keys[i][1];
    return code > 0 && code < 128 ? code : PEL_KEY_OTHER;
}

/* The event as one of drivers/input.h. False for one that has none. */
static bool input_of(const SDL_Event *event, struct pel_input *e)
{
    *e = (struct pel_input){.time = event->common.timestamp};
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        e->kind = PEL_INPUT_KEY;
        e->state = event->key.repeat ? PEL_INPUT_AGAIN : event->key.state;
        e->code = (uint16_t)key_of(event->key.keysym.sym);
        return true;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        e->kind = PEL_INPUT_BUTTON;
        e->state = event->button.state;
        e->code = event->button.button;
        return true;
    case SDL_MOUSEMOTION:
        e->kind = PEL_INPUT_POINT;
        e->x = (int16_t)event->motion.x;
        e->y = (int16_t)event->motion.y;
        return true;
    case SDL_MOUSEWHEEL:
        e->kind = PEL_INPUT_WHEEL;
        e->x = (int16_t)event->wheel.x;
        e->y = (int16_t)event->wheel.y;
        return true;
    default:
        return false;
    }
}

/* With all that was done before. */
static bool save_new(struct window *w)
{
    return (!w->viewer->stale || draw(w)) &&
           viewer_save(w->viewer, &w->canvas.surface, false);
}

static bool handle(struct window *w, const SDL_Event *event)
{
    struct pel_input input;
    if (event->type == SDL_QUIT)
        w->viewer->over = true;
    else if (event->type == SDL_WINDOWEVENT)
        w->viewer->stale = true;
    if (!input_of(event, &input))
        return true;
    return !viewer_input(w->viewer, &input) || save_new(w);
}

/* Waits at most so many ms for an event. SDL_WaitEventTimeout would, but its
 * X11 driver then wakes the window from a second connection: a server that
 * reads that one last finds no window, and the error ends the program with
 * status 1.
 */
static bool wait_event(SDL_Event *event, int ms)
{
    for (int waited = 0; !SDL_PollEvent(event); waited += POLL_MS) {
        if (waited >= ms)
            return false;
        SDL_Delay(POLL_MS);
    }
    return true;
}

/* Handles the events that have come; waits a moment for one when there is
 * nothing to draw. */
static bool handle_all(struct window *w)
{
    SDL_Event event;
    bool more = wait_event(&event, viewer_idle(w->viewer));
    for (; more; more = SDL_PollEvent(&event))
        if (!handle(w, &event))
            return false;
    return !viewer_inputs(w->viewer) || save_new(w);
}

static void set_title(struct window *w)
{
    char title[VIEWER_TITLE_SIZE];
    viewer_title(w->viewer, title);
    if (strcmp(title, w->title) == 0)
        return;
    strcpy(w->title, title);
    SDL_SetWindowTitle(w->window, title);
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
    return good && viewer_save(viewer, &w->canvas.surface, true);
}

/* Frames wait for the screen's refresh, unless --frames wants them as fast as
 * it goes or the show has a period of its own. */
static bool open_window(struct window *w)
{
    const struct show *show = w->viewer->show;
    const struct viewer_options *o = w->viewer->options;
    const bool timed = o->frames > 0 || show->period > 0;
    SDL_RendererInfo info = {0};
    w->window = SDL_CreateWindow(
        "pel view", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
        o->width ? o->width : show->width, o->height ? o->height : show->height,
        SDL_WINDOW_RESIZABLE | SDL_WINDOW_HIDDEN);
    if (!w->window)
        return fails("no window");
    w->renderer = SDL_CreateRenderer(w->window, -1,
                                     timed ? 0 : SDL_RENDERER_PRESENTVSYNC);
    if (!w->renderer)
        return fails("nothing can be drawn into the window");
    SDL_GetRendererInfo(w->renderer, &info);
    w->most = pel_min(info.max_texture_width, info.max_texture_height);
    if (w->most <= 0 || w->most > TEXTURE_SIZE_MAX) /* 0: no limit of SDL's */
        w->most = TEXTURE_SIZE_MAX;
    SDL_ShowWindow(w->window); /* a renderer may put another in its place */
    return true;
}

/* Without a screen SDL takes a driver that shows nothing, which nobody wants
 * who has not asked for it. */
static bool is_seen(void)
{
    const char *driver = SDL_GetCurrentVideoDriver();
    return getenv("SDL_VIDEODRIVER") || !driver ||
           (strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0) ||
           message_error("no screen for a window: DISPLAY and WAYLAND_DISPLAY "
                         "name none: expected --device auto, or pel render");
}

bool view_window(struct show *show, const struct viewer_options *options)
{
    struct viewer viewer;
    struct window w = {.viewer = &viewer};
    /* all but the buttons comes with the window */
    const struct pel_input_linux_options buttons = {.buttons = options->buttons,
                                                    .no_devices = true};
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
        return fails("no screen for a window");
    viewer_init(&viewer, show, options);
    const bool done =
        is_seen() &&
        (!buttons.buttons || viewer_open_input(&viewer, &buttons)) &&
        open_window(&w) && run(&w);
    if (done && options->frames > 0)
        viewer_report(&viewer);
    viewer_free(&viewer);
    canvas_free(&w.canvas);
    SDL_DestroyTexture(w.texture);
    SDL_DestroyRenderer(w.renderer);
    SDL_DestroyWindow(w.window);
    SDL_Quit();
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
