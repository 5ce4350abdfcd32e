/* A scene: a model, seen by a camera, lit, drawn by core/scene. Settings are
 * in numbers for people; what core gets of them are integers.
 *
 *     struct scene_settings settings = scene_default;
 *     struct scene scene;
 *     model_load(&model, &source) && scene_init(&scene, &model) &&
 *         scene_prepare(&scene, &settings) && scene_draw(&scene, &surface)
 *
 * Prepare again for other settings, draw as often as there are bands; free at
 * the end. */
#ifndef SIM_RENDER_SCENE_H
#define SIM_RENDER_SCENE_H

#include <stdio.h>

#include "core/base/surface.h"
#include "core/scene/camera.h"
#include "core/scene/certificate.h"
#include "sim/mesh/model.h"
#include "sim/render/scene_methods.h"

/* Names of these settings for commands and scripts, in the order of their
 * numbers. */
#define CAMERA_PROJECTIONS "perspective|orthographic"
#define SCENE_SHADES "flat|gouraud|phong"
#define SCENE_TEXTURES "none|nearest|bilinear"
#define SCENE_MAPPINGS "vertices|affine|subdivided|perspective"
#define SCENE_SPANS "2|4|8|16|32|64"
#define SCENE_WRAPS "clamp|repeat|mirror|own"
#define SCENE_NORMALS "file|smooth"
#define SCENE_SIDES "front|both"
#define SCENE_INTERPOLATIONS "screen|world"
#define SCENE_ORDERS "auto|painter|zbuffer16|zbuffer32|zbuffer"
#define SCENE_CULLS "none|back|front"
#define SCENE_TERMS "ambient|diffuse|specular"
#define SCENE_HIGHLIGHTS "coloured|plain"

/* What the user asked for, as the flags say, and what is chosen for the rest.
 */
struct camera {
    double eye[3], target[3], up[3]; /* world units */
    enum pel_projection projection;
    double focal;      /* mm, > 0; perspective */
    double sensor[2];  /* width and height, > 0: mm, or of what is seen in world
                          units when orthographic */
    double near_plane; /* world units, > 0: nothing nearer is seen */
    int width, height; /* px of the picture, 1..32,767 */
    pel_color background;
    bool has_eye, has_target, has_sensor, has_near;
};

enum scene_shade { SCENE_FLAT, SCENE_GOURAUD, SCENE_PHONG };

/* AUTO: there is light when a light or a number of it was set, for Phong, and
 * for a model whose colors show no shape and that has no texture. */
enum scene_lit { SCENE_LIT_AUTO, SCENE_LIT, SCENE_UNLIT };

enum scene_texture {
    SCENE_TEXTURE_NONE,
    SCENE_TEXTURE_NEAREST,
    SCENE_TEXTURE_BILINEAR
};

enum scene_mapping {
    SCENE_MAP_VERTICES,   /* a texel for every vertex */
    SCENE_MAP_AFFINE,     /* u, v linear on screen */
    SCENE_MAP_SUBDIVIDED, /* in perspective every `span` pixels */
    SCENE_MAP_PERSPECTIVE /* in every pixel */
};

/* OWN: that of the material. */
enum scene_wrap { SCENE_WRAP_OWN = PEL_WRAP_MIRROR + 1 };

/* SCENE_ZBUFFER is drawn as SCENE_ZBUFFER32, and so is SCENE_AUTO, which finds
 * out where the painter's order does the same in less time. */
enum scene_order {
    SCENE_AUTO,
    SCENE_PAINTER,
    SCENE_ZBUFFER16,
    SCENE_ZBUFFER32,
    SCENE_ZBUFFER
};

enum scene_term {
    SCENE_AMBIENT = 1,
    SCENE_DIFFUSE = 2,
    SCENE_SPECULAR = 4,
    SCENE_ALL_TERMS = 7
};

enum { SCENE_LIGHTS_MAX = 32 };

/* struct pel_light: `at` in world units, or the direction to a directional one.
 */
struct scene_light {
    double at[3];
    double color[3]; /* red, green, blue; 1 is full, less than 16 */
    bool directional;
};

struct scene_settings {
    struct camera camera; /* with the size of the picture, its background */
    int left, top;        /* px: where that lies on the surface */
    uint16_t turn[3];     /* of the model around the middle of its box, in
                             1/65,536 turns: around x, then y, then z */

    struct scene_light light[SCENE_LIGHTS_MAX];
    int lights; /* 0, and lit: a white one from above, left of the viewer */
    double ambient_color[3];
    double ambient, diffuse, specular; /* ka, kd, ks: 0 to less than 16 */
    int shininess;                     /* 1..256 */
    unsigned terms;                    /* of enum scene_term; others are 0 */
    bool plain_highlights, no_back_highlights, both_sides; /* pel_lighting */
    enum scene_lit lit;
    bool has_light; /* a light or a number of it was set */

    enum scene_shade shade;
    bool in_world; /* colors, normals, positions: linear there, not on screen */
    enum scene_texture texture;
    enum scene_mapping mapping;
    enum scene_wrap wrap;
    int span; /* subdivided: the index of one of SCENE_SPANS */

    enum scene_order order;
    enum pel_cull cull;
    bool has_color; /* instead of the colors of the vertices: */
    pel_color color;
    int transparency; /* 0: opaque; 255: nothing is drawn */

    double tolerance, texel_tolerance; /* steps of 255 and texels: methods are
                                          chosen instead of Phong shading, and
                                          of textures in perspective */
    bool stats;                        /* count them, in one thread at a time */
    bool show_methods; /* in their colors instead of the picture's: grey, blue,
                          green, red */
};

/* Defaults: up is +y, perspective, 50 mm on a sensor 36 mm wide,
 * 1200x1200, white, and the rest of the camera left to camera_frame; Gouraud,
 * the model's own textures bilinear and in perspective, wrapped as they say,
 * the right order, both sides, ka 0.3, kd 0.7, ks 0.3, shininess 20. */
extern const struct scene_settings scene_default;

/* Fills in what was left open, from the model: the target is the middle of its
 * box; the eye stands in front, a little to the right and above, as near as
 * shows every vertex with a margin of 1/20; pixels are square; the near plane
 * is close before the model however it is turned around its middle, but at
 * 1/1000 of the distance from eye to target at least. False, with a message on
 * standard error, when eye and target are the same or `up` points along the
 * view. The flags stay: set them to keep what was found. */
bool camera_frame(struct camera *camera, const struct model *model);

/* The scene of core and its parts. It must not be moved: it points into
 * itself. */
struct scene {
    const struct model *model; /* the caller's, like its texture */
    struct pel_scene core;
    struct pel_mesh mesh; /* the model's, in the world's scale */
    struct pel_pose pose;
    struct pel_lighting lighting;
    struct pel_light light[SCENE_LIGHTS_MAX];
    struct pel_mesh_texture *texture; /* malloc'ed, like the next two */
    struct pel_mesh_part *part;       /* the model's, in the settings' color */
    struct scene_methods methods;
    struct pel_frame frame;
    void *scratch;
    size_t scratch_size;
    int depth_bits; /* 16, 32; 0: the painter's order */
    bool is_proven; /* that order is right outside of doubt.bounds */
    struct pel_doubt doubt;
    double units; /* of core in a unit of the model: a power of two */
};

/* Takes the memory. False, with a message on standard error, when it is short;
 * the scene may then be freed all the same. */
bool scene_init(struct scene *scene, const struct model *model);

/* Sets a picture up, completing the camera with camera_frame. Places go to core
 * as they are while all are within +-16,384 units, the eye is 1/16 unit or more
 * from the target, and the mesh not too small for its asset, so that firmware
 * draws the same picture of the same mesh; otherwise all are multiplied by a
 * power of two. A light more than 1,024 times farther away than all else is
 * directional. False, with a message, for settings that cannot be drawn;
 * scene_draw must not be called then. */
bool scene_prepare(struct scene *scene, const struct scene_settings *settings);

/* Draws the model onto the surface, inside its clip, and nothing else: not the
 * background. Several threads may draw parts at a time. False, with a message,
 * when there is no memory for a depth buffer. */
bool scene_draw(const struct scene *scene, const struct pel_surface *surface);

void scene_free(struct scene *scene);

/* Prints how triangles are ordered, and for SCENE_PAINTER how many pixels may
 * be wrong. */
void scene_print_order(FILE *out, const struct scene *scene);

/* Writes an initialiser of struct pel_camera, with a comment before it, of a
 * prepared scene: with it core draws what the scene shows. */
void scene_print_camera(FILE *out, const struct scene *scene);

/* Parts of scene_prepare, in files of their own. */

/* The mapping of a texture whose texels the colours of vertices multiply, light
 * by light, before it is lit. That of vertices is right as it is. */
const struct pel_mapping *scene_colored(const struct pel_mapping *plain);

/* Places, in the scale that fits, lights and material: units, mesh, pose,
 * core.camera, core.viewport, lighting. The camera is complete. */
void scene_place(struct scene *scene, const struct scene_settings *settings);

/* Sets depth_bits, and the sort where it is needed for the order; before a
 * frame of the scene is prepared. SCENE_AUTO sorts where a proof of the
 * painter's order is likely to take less time than a depth buffer; it takes one
 * otherwise. */
void scene_set_order(struct scene *scene, const struct scene_settings *s);

/* Tries the proof, in as much time as the depths would take at most. Where it
 * fails for a part of the picture, depths are kept for that part, or for all
 * of it. */
void scene_prove_order(struct scene *scene);

#endif
