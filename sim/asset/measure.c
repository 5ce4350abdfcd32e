#include "sim/asset/measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/format/formats.h"
#include "core/raster/rectangle.h"
#include "core/scene/pipeline.h"
#include "sim/cli/arguments.h"
#include "sim/cli/message.h"
#include "sim/cli/number.h"
#include "sim/cli/text_line.h"
#include "sim/image/canvas.h"

enum { VIEWS_MAX = 10000 };

static const struct {
    enum scene_shade shade;
    bool in_world;
    const char *name[2]; /* without light, and with */
} shadings[MEASURE_SHADINGS] = {
    {SCENE_FLAT, false, {"pel_shade_flat", "pel_shade_lit_flat"}},
    {SCENE_GOURAUD, false, {"pel_shade_gouraud", "pel_shade_lit_gouraud"}},
    {SCENE_GOURAUD,
     true,
     {"pel_perspective_gouraud", "pel_perspective_lit_gouraud"}},
    {SCENE_PHONG, false, {NULL, "pel_shade_phong"}},
    {SCENE_PHONG, true, {NULL, "pel_perspective_phong"}},
};

static const struct {
    enum scene_mapping mapping;
    int span; /* the index of one of SCENE_SPANS */
    const struct pel_mapping *core;
    const char *name;
} mappings[MEASURE_MAPPINGS] = {
    {SCENE_MAP_VERTICES, 0, &pel_map_vertices, "pel_map_vertices"},
    {SCENE_MAP_AFFINE, 0, &pel_map_affine, "pel_map_affine"},
    {SCENE_MAP_SUBDIVIDED, 5, &pel_map_perspective, "pel_map_perspective"},
    {SCENE_MAP_SUBDIVIDED, 4, &pel_map_perspective, "pel_map_perspective"},
    {SCENE_MAP_SUBDIVIDED, 3, &pel_map_perspective, "pel_map_perspective"},
    {SCENE_MAP_SUBDIVIDED, 2, &pel_map_perspective, "pel_map_perspective"},
    {SCENE_MAP_SUBDIVIDED, 1, &pel_map_perspective, "pel_map_perspective"},
    {SCENE_MAP_SUBDIVIDED, 0, &pel_map_perspective, "pel_map_perspective"},
    {SCENE_MAP_PERSPECTIVE, 0, &pel_map_perspective, "pel_map_perspective"},
};

const char *measure_shading_name(const struct measure *measure, int shading)
{
    return shadings[shading].name[measure->lit];
}

bool measure_in_world(int shading)
{
    return shadings[shading].in_world;
}

const char *measure_mapping_name(int mapping)
{
    return mappings[mapping].name;
}

int measure_mapping_span(int mapping)
{
    return mappings[mapping].mapping == SCENE_MAP_SUBDIVIDED
               ? 2 << mappings[mapping].span
               : 1;
}

static int last_shading(const struct measure *m)
{
    return m->lit ? MEASURE_SHADINGS - 1 : 2;
}

/* Three pictures of one view: the exact one, another way, and the number of the
 * part that each pixel shows, from 1 on. */
struct drawing {
    struct measure *measure;
    const struct model *model;
    struct scene scene;
    struct canvas exact, other, number;
};

static const struct pel_paint *paint_number(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    (void)surface;
    (void)color;
    return pel_frame_flat_paint(frame, NULL,
                                (frame->part + 1) | UINT32_C(0xFF000000));
}

static const struct pel_shading shade_number = {NULL, NULL, paint_number, 0};

/* Prepares the scene anew, with a shading of ours in place of its own where it
 * is not NULL, and with the mappings that are taken already. */
static bool prepare_taken(struct drawing *d, const struct pel_shading *shading)
{
    struct scene *scene = &d->scene;
    if (shading)
        scene->core.shading = shading;
    for (size_t i = 0; !shading && i < d->measure->textures; i++) {
        const int mapping = d->measure->mapping[i];
        scene->texture[i].mapping = mappings[mapping].core;
        scene->texture[i].span = measure_mapping_span(mapping);
    }
    const enum pel_status status = pel_scene_prepare(
        &scene->frame, &scene->core, scene->scratch, scene->scratch_size);
    return status == PEL_OK || message_error("a view cannot be drawn (%s)",
                                             pel_status_name(status));
}

/* Draws the view as the settings say; or, `taken`, with the mappings that are
 * taken already. */
static bool draw(struct drawing *d, struct canvas *canvas,
                 const struct scene_settings *settings, bool taken)
{
    const bool number = canvas == &d->number;
    if (!scene_prepare(&d->scene, settings) ||
        ((number || taken) && !prepare_taken(d, number ? &shade_number : NULL)))
        return false;
    pel_clear(&canvas->surface, 0);
    return scene_draw(&d->scene, &canvas->surface);
}

static bool draw_exact(struct drawing *d, const struct scene_settings *view)
{
    struct scene_settings s = *view;
    s.shade = shadings[last_shading(d->measure)].shade;
    s.in_world = true;
    s.mapping = SCENE_MAP_PERSPECTIVE;
    return draw(d, &d->exact, &s, false) && draw(d, &d->number, &s, false);
}

static int difference(pel_color a, pel_color b)
{
    int most = 0;
    for (int k = 0; k < 24; k += 8)
        most = pel_max(most, abs((int)(a >> k & 255) - (int)(b >> k & 255)));
    return most;
}

/* The largest error of each part, or of the texture that it has, in the column
 * of the way that `other` was drawn in. */
static void compare(const struct drawing *d, bool of_texture, int way)
{
    const struct measure *m = d->measure;
    const size_t n = (size_t)m->width * (size_t)m->height;
    const uint32_t *exact = d->exact.memory, *other = d->other.memory,
                   *number = d->number.memory;
    for (size_t i = 0; i < n; i++) {
        const uint32_t part = (number[i] & 0xFFFFFFu) - 1;
        if (part >= m->parts)
            continue;
        const uint32_t texture = d->model->mesh.part[part].texture;
        if (of_texture && (texture == 0 || texture > m->textures))
            continue;
        int *error = of_texture ? &m->mapping_error[texture - 1][way]
                                : &m->shading_error[part][way];
        *error = pel_max(*error, difference(exact[i], other[i]));
    }
}

static bool try_mappings(struct drawing *d, const struct scene_settings *view)
{
    struct scene_settings s = *view;
    s.shade = shadings[last_shading(d->measure)].shade;
    s.in_world = true;
    for (int i = 0; i < MEASURE_MAPPINGS; i++) {
        s.mapping = mappings[i].mapping;
        s.span = mappings[i].span;
        if (!draw(d, &d->other, &s, false))
            return false;
        compare(d, true, i);
    }
    return true;
}

static bool try_shadings(struct drawing *d, const struct scene_settings *view)
{
    struct scene_settings s = *view;
    s.mapping = SCENE_MAP_PERSPECTIVE;
    for (int i = 0; i <= last_shading(d->measure); i++) {
        s.shade = shadings[i].shade;
        s.in_world = shadings[i].in_world;
        if (!draw(d, &d->other, &s, true))
            return false;
        compare(d, false, i);
    }
    return true;
}

/* The first that is within the tolerance; of what no view shows, the last. */
static uint8_t cheapest(const int *error, int last, double tolerance)
{
    int i = error[0] < 0 ? last : 0;
    while (i < last && error[i] > tolerance)
        i++;
    return (uint8_t)i;
}

static void take_mappings(struct measure *m)
{
    for (size_t i = 0; i < m->textures; i++)
        m->mapping[i] =
            cheapest(m->mapping_error[i], MEASURE_MAPPINGS - 1, m->tolerance);
}

static void take_shadings(struct measure *m)
{
    for (size_t i = 0; i < m->parts; i++)
        m->shading[i] =
            cheapest(m->shading_error[i], last_shading(m), m->tolerance);
}

static uint16_t turn_of(double turns)
{
    return (uint16_t)lround((turns - floor(turns)) * 65536);
}

/* View i of n, from all sides: the heights of the ends of the axis x over the
 * screen are evenly spread, and the mesh turns around it by the golden angle.
 */
static void set_pose(struct scene_settings *s, int i, int n)
{
    const double height = (2 * i + 1.0) / n - 1;
    s->turn[0] = turn_of(i * (3 - sqrt(5)) / 2);
    s->turn[1] = turn_of(asin(height) / (2 * M_PI));
    s->turn[2] = 0;
}

/* A line of the file of views; an empty one is none. */
static bool read_view(struct scene_settings *s, const char *line)
{
    static const struct option_row numbers = {
        .n = 3, .separator = ',', .low = -MESH_LIMIT, .high = MESH_LIMIT};
    char text[3][128];
    double turn[3];
    const int n = sscanf(line, "%127s %127s %127s", text[0], text[1], text[2]);
    if (!option_numbers(text[0], &numbers, turn))
        return false;
    for (int k = 0; k < 3; k++)
        s->turn[k] = turn_of(turn[k]);
    s->camera.has_eye |= n > 1;
    s->camera.has_target |= n > 2;
    return (n < 2 || option_numbers(text[1], &numbers, s->camera.eye)) &&
           (n < 3 || option_numbers(text[2], &numbers, s->camera.target));
}

/* Calls `work` for every view. */
static bool each_view(struct drawing *d, const struct scene_settings *settings,
                      const struct text_lines *file,
                      bool (*work)(struct drawing *,
                                   const struct scene_settings *))
{
    struct measure *m = d->measure;
    const int lines = file ? (int)file->count : m->count;
    int count = 0;
    for (int i = 0; i < lines; i++) {
        struct scene_settings view = *settings;
        if (file) {
            char *line = file->text[i];
            line[strcspn(line, "#")] = '\0';
            if (line[strspn(line, " \t\r")] == '\0')
                continue;
            if (!read_view(&view, line))
                return message_error_at(
                    m->views, i + 1,
                    "no view: expected X,Y,Z of the turn, and if they move, "
                    "of the eye and of the target, such as 0,0.25,0 0,1,4");
        } else {
            set_pose(&view, i, lines);
        }
        count++;
        if (!draw_exact(d, &view) || !work(d, &view))
            return false;
    }
    m->count = count;
    return count > 0 || message_error_at(m->views, 0, "has no view");
}

static bool measure_views(struct drawing *d, const struct scene_settings *s,
                          const struct text_lines *file)
{
    struct measure *m = d->measure;
    if (m->textures > 0 && !each_view(d, s, file, try_mappings))
        return false;
    take_mappings(m);
    if (!each_view(d, s, file, try_shadings))
        return false;
    take_shadings(m);
    return true;
}

static bool take_memory(struct drawing *d, const struct scene_settings *s)
{
    struct measure *m = d->measure;
    m->shading = calloc(m->parts + 1, sizeof *m->shading);
    m->mapping = calloc(m->textures + 1, sizeof *m->mapping);
    m->shading_error = calloc(m->parts + 1, sizeof *m->shading_error);
    m->mapping_error = calloc(m->textures + 1, sizeof *m->mapping_error);
    if (!m->shading || !m->mapping || !m->shading_error || !m->mapping_error)
        return message_error("out of memory");
    memset(m->shading_error, -1, m->parts * sizeof *m->shading_error);
    memset(m->mapping_error, -1, m->textures * sizeof *m->mapping_error);
    const int width = s->camera.width, height = s->camera.height;
    return canvas_init(&d->exact, &pel_xrgb8888, width, height) &&
           canvas_init(&d->other, &pel_xrgb8888, width, height) &&
           canvas_init(&d->number, &pel_xrgb8888, width, height) &&
           scene_init(&d->scene, d->model);
}

/* Light as scene_prepare decides it. */
static bool find_light(struct drawing *d, const struct scene_settings *s)
{
    if (!scene_prepare(&d->scene, s))
        return false;
    d->measure->lit = d->scene.core.shading == &pel_shade_lit_gouraud;
    return true;
}

/* All that `views` says, or false. */
static bool measure_drawing(struct drawing *d,
                            const struct scene_settings *settings)
{
    struct measure *m = d->measure;
    struct scene_settings s = *settings;
    struct text_lines file;
    int64_t number = 0;
    s.shade = SCENE_GOURAUD;
    s.in_world = false;
    s.tolerance = 0;
    m->width = s.camera.width;
    m->height = s.camera.height;
    m->parts = d->model->mesh.parts;
    m->textures = s.texture == SCENE_TEXTURE_NONE ? 0 : d->model->textures;
    if (!take_memory(d, &s) || !find_light(d, &s))
        return false;
    const enum number_status status =
        number_integer(m->views, 1, VIEWS_MAX, &number);
    m->count = (int)number;
    if (status == NUMBER_RANGE)
        return message_error("--view is '%s': expected a number from 1 to %d, "
                             "or a file",
                             m->views, VIEWS_MAX);
    if (status == NUMBER_OK)
        return measure_views(d, &s, NULL);
    const bool done =
        text_lines_read(&file, m->views) && measure_views(d, &s, &file);
    text_lines_free(&file);
    return done;
}

bool measure_model(struct measure *measure, const struct model *model,
                   const struct scene_settings *settings)
{
    struct drawing d = {.measure = measure, .model = model};
    const bool done = measure_drawing(&d, settings);
    scene_free(&d.scene);
    canvas_free(&d.exact);
    canvas_free(&d.other);
    canvas_free(&d.number);
    return done;
}

void measure_free(struct measure *measure)
{
    free(measure->shading);
    free(measure->mapping);
    free(measure->shading_error);
    free(measure->mapping_error);
}
