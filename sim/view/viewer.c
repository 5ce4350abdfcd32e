#include "sim/view/viewer.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/raster/rectangle.h"
#include "sim/cli/device.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"

static const double turns_per_ms = 1.0 / 10000;

bool viewer_init(struct viewer *viewer, const struct view_job *job,
                 const struct scene_settings *settings)
{
    const int jobs = job->device->jobs;
    memset(viewer, 0, sizeof(*viewer));
    pel_pool_start(&viewer->pool, jobs > 0 ? jobs : pel_pool_processors());
    viewer->model = job->model;
    viewer->options = job->options;
    if (!view_init(&viewer->view, settings, job->model))
        return false;
    viewer->view.turning = !job->options->still;
    viewer->stale = true;
    return scene_init(&viewer->scene, job->model);
}

void viewer_free(struct viewer *viewer)
{
    pel_pool_end(&viewer->pool);
    pel_input_linux_close(&viewer->input);
    scene_free(&viewer->scene);
}

bool viewer_is_over(const struct viewer *viewer)
{
    const int frames = viewer->options->frames;
    return viewer->over || (frames > 0 && viewer->drawn >= frames);
}

/* Measures once a second. True when it did. */
static bool measure(struct viewer *viewer, double now)
{
    const double passed = now - viewer->rate.since;
    const int drawn = viewer->drawn - viewer->rate.drawn;
    if (passed < 1000)
        return false;
    viewer->rate.fps = drawn * 1000 / passed;
    viewer->rate.milliseconds =
        drawn ? (viewer->drawing - viewer->rate.drawing) / drawn : 0;
    viewer->rate.since = now;
    viewer->rate.drawn = viewer->drawn;
    viewer->rate.drawing = viewer->drawing;
    return true;
}

bool viewer_advance(struct viewer *viewer)
{
    const double now = milliseconds();
    const struct viewer_options *options = viewer->options;
    if (viewer->begun == 0 && options->frames == 0)
        fputs(VIEW_KEYS_HELP, stderr);
    if (viewer->drawn == 0) {
        viewer->begun = viewer->last = viewer->rate.since = now;
        return false;
    }
    if (viewer->view.turning) {
        view_orbit(&viewer->view,
                   options->has_step ? options->step
                                     : (now - viewer->last) * turns_per_ms,
                   0);
        viewer->stale = true;
    }
    viewer->stale = viewer->stale || options->frames > 0;
    viewer->last = now;
    return measure(viewer, now);
}

static bool draw_band(struct canvas *band, const void *context)
{
    const struct viewer *viewer = context;
    pel_clear(&band->surface, viewer->view.settings.camera.background);
    return scene_draw(&viewer->scene, &band->surface);
}

static bool has_light(const struct scene *scene)
{
    const struct pel_shading *shading = scene->core.shading;
    return shading != &pel_shade_flat && shading != &pel_shade_gouraud;
}

bool viewer_draw(struct viewer *viewer, const struct pel_surface *surface)
{
    const double start = milliseconds();
    const struct pel_rect *clip = &surface->clip;
    struct scene_settings settings;
    view_settings(&viewer->view, clip->x1 - clip->x0, clip->y1 - clip->y0,
                  &settings);
    settings.left = clip->x0;
    settings.top = clip->y0;
    if (!scene_prepare(&viewer->scene, &settings))
        return false;
    viewer->view.lit = has_light(&viewer->scene);
    struct canvas canvas = {.surface = *surface};
    const bool done =
        device_draw_bands(&viewer->pool, &canvas, draw_band, viewer);
    viewer->width = clip->x1 - clip->x0;
    viewer->height = clip->y1 - clip->y0;
    viewer->drawing += milliseconds() - start;
    return done;
}

void viewer_shown(struct viewer *viewer)
{
    viewer->drawn++;
    viewer->stale = false;
}

static bool save(const struct pel_surface *surface, const char *path)
{
    const struct canvas canvas = {.surface = *surface};
    struct picture picture;
    const bool done =
        canvas_picture(&canvas, &picture) && picture_save(&picture, path);
    picture_free(&picture);
    return done;
}

bool viewer_save_last(const struct viewer *viewer,
                      const struct pel_surface *surface)
{
    return !viewer->options->output || save(surface, viewer->options->output);
}

bool viewer_save_new(const struct pel_surface *surface)
{
    char path[32];
    for (int i = 1; i < 1000; i++) {
        snprintf(path, sizeof(path), "view-%03d%s", i, picture_best_ending());
        if (access(path, F_OK) != 0)
            return save(surface, path) &&
                   fprintf(stderr, "written: %s\n", path) > 0;
    }
    return message_error("view-001 to view-999 are there already: expected a "
                         "free name");
}

static void put_speed(const struct viewer *viewer, char text[48])
{
    text[0] = '\0';
    if (viewer->view.turning && viewer->rate.fps > 0)
        snprintf(text, 48, "%.1f fps (drawing %.1f ms), ", viewer->rate.fps,
                 viewer->rate.milliseconds);
}

void viewer_title(const struct viewer *viewer, char title[VIEWER_TITLE_SIZE])
{
    static const char *const shades[] = {"flat", "Gouraud", "Phong"};
    static const char *const textures[] = {"no texture", "nearest", "bilinear"};
    static const char *const orders[] = {"painter", "z-buffer 16",
                                         "z-buffer 32", "z-buffer 32"};
    const struct scene_settings *s = &viewer->view.settings;
    const bool has_texture = viewer->model->texture.width > 0;
    char speed[48];
    put_speed(viewer, speed);
    snprintf(title, VIEWER_TITLE_SIZE,
             "pel view: %s%u triangles, %s, %s, %s, %s", speed,
             (unsigned)viewer->model->mesh.triangles, shades[s->shade],
             viewer->view.lit ? "lit" : "no light",
             textures[has_texture ? s->texture : SCENE_TEXTURE_NONE],
             orders[s->order]);
}

void viewer_report(const struct viewer *viewer)
{
    const double passed = milliseconds() - viewer->begun;
    if (viewer->drawn > 0)
        fprintf(stderr, "%d frames, %.1f fps, drawing %.3f ms a frame\n",
                viewer->drawn, viewer->drawn * 1000 / passed,
                viewer->drawing / viewer->drawn);
}
