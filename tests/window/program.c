/* program FOLDER [touch] : a program as for a board, in a window: draws frames
 * in bands until q is pressed or the window is closed, and prints what the user
 * does. Before it, FOLDER gets what is to be seen: picture.ppm, heat.ppm. */
#include <stdio.h>
#include <string.h>

#include "port/sdl/display_sdl.h"
#include "port/sdl/inspect.h"

enum { WIDTH = 60, HEIGHT = 40, ROWS = 8 };

static void draw(const struct pel_surface *screen)
{
    static const pel_color colors[2] = {PEL_RGB(255, 120, 0),
                                        PEL_RGB(0, 40, 160)};
    static const struct pel_ramp ramp = {colors, 2, PEL_PAD};
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(90, 200, 255, 130));
    static const struct pel_point roof[3] = {PEL_AT(4, 36), PEL_AT(30, 3.5),
                                             PEL_AT(57, 33)};
    struct pel_linear slope;
    struct pel_dither dither;
    pel_clear(screen, PEL_RGB(20, 24, 40));
    pel_linear_init(&slope, pel_at(0, 0), pel_at(WIDTH, HEIGHT), &ramp);
    pel_dither_init(&dither, &slope.base.paint);
    pel_triangle(screen, roof, &dither.paint);
    pel_circle(screen, pel_at(20, 20), PEL_PX(12), &glass.paint);
    pel_smooth_circle(screen, pel_at(40, 22), PEL_PX(9.5), &glass.paint);
}

static void write_ppm(const struct pel_surface *s, const char *folder,
                      const char *name)
{
    char path[400];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    if (!file)
        return;
    fprintf(file, "P6\n%d %d 255\n", WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        pel_color c;
        s->format->load(s, i % WIDTH, i / WIDTH, 1, &c);
        fprintf(file, "%c%c%c", (int)pel_red(c), (int)pel_green(c),
                (int)pel_blue(c));
    }
    fclose(file);
}

static void write_expected(const char *folder)
{
    static uint32_t memory[WIDTH * HEIGHT];
    static const struct pel_rect all = {0, 0, WIDTH, HEIGHT};
    struct pel_surface s;
    pel_surface_init(&s, &pel_rgb565_be, memory, sizeof memory, &all);
    draw(&s);
    write_ppm(&s, folder, "picture.ppm");
    memset(memory, 0, sizeof memory);
    pel_surface_init(&s, &pel_heat, memory, sizeof memory, &all);
    draw(&s);
    write_ppm(&s, folder, "heat.ppm");
}

/* As on a board. */
static enum pel_status draw_frame(const struct pel_display *display)
{
    static uint16_t band[WIDTH * ROWS];
    enum pel_status status = PEL_OK;
    for (int y = 0; y < HEIGHT && status == PEL_OK; y += ROWS) {
        const struct pel_rect rows = {0, y, WIDTH, y + ROWS};
        struct pel_surface screen;
        pel_surface_init(&screen, display->format, band, sizeof band, &rows);
        status = pel_display_begin(display, &rows, &screen);
        draw(&screen);
        if (status == PEL_OK)
            status = pel_display_flush(display, &screen);
    }
    return status == PEL_OK ? pel_display_flip(display) : status;
}

int main(int argc, char **argv)
{
    static struct pel_display_sdl window;
    const struct pel_display_sdl_options panel = {.title = "window test",
                                                  .width = WIDTH,
                                                  .height = HEIGHT,
                                                  .format = &pel_rgb565_be,
                                                  .period = 10,
                                                  .touch = argc > 2};
    struct pel_display display;
    struct pel_input e = {.code = 0};
    write_expected(argc > 1 ? argv[1] : ".");
    enum pel_status status = pel_display_sdl_open(&display, &window, &panel);
    if (window.message)
        printf("%s\n", window.message);
    while (status == PEL_OK && e.code != 'q') {
        status = draw_frame(&display);
        while (pel_display_sdl_next(&window, &e)) {
            printf("%d %d %d %d %d\n", e.kind, e.state, e.code, e.x, e.y);
            fflush(stdout);
        }
    }
    printf("ended %d\n", status);
    while (pel_display_sdl_wait(&window, status == PEL_OK ? 0 : -1, &e))
        continue;
    pel_display_sdl_close(&window);
    return status != PEL_OK;
}
