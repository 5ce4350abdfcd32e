#include "scenes.h"

#include <math.h>

#include "../method.h"

/* Right, down, away; the eye is 0. */
struct position {
    double x, y, z;
};

const struct pel_quantization scene_unit = {.step = 1, .shift = 12};
const struct pel_rect scene_screen = {0, 0, SCENE_SIDE, SCENE_SIDE};
const struct pel_camera scene_camera = {.target = {0, 0, -PEL_UNITS(1)},
                                        .up = {0, 1, 0},
                                        .focal = 1,
                                        .sensor = {1, 1},
                                        .near_plane = PEL_UNITS(SCENE_NEAR)};

static void add(struct scene *s, struct position a, struct position b,
                struct position c)
{
    const struct position at[3] = {a, b, c};
    const double unit = 1 << scene_unit.shift;
    struct scene_triangle *t = &s->triangle[s->n];
    for (int i = 0; i < 3; i++) {
        int16_t *p = s->position[s->n][i];
        struct pel_projected seen;
        p[0] = (int16_t)lround(unit * at[i].x);
        p[1] = (int16_t)lround(-unit * at[i].y);
        p[2] = (int16_t)lround(-unit * at[i].z);
        pel_project(&s->projector, p, &seen);
        t->v[i] = (struct pel_point){seen.x, seen.y};
        t->z[i] = -p[2] / unit;
    }
    s->n += pel_triangle_area(t->v) != 0;
}

static void add_quad(struct scene *s, const struct position p[4])
{
    add(s, p[0], p[1], p[2]);
    add(s, p[0], p[2], p[3]);
}

/* The radius of a turned body where `t` of its height, 0..1, is above. */
typedef double profile(double t);

struct body {
    struct position center;
    double height;
    profile *radius;
};

/* The ring of a body's points, a little tilted towards the eye. */
static struct position on_body(const struct body *b, double t, double turn)
{
    const double r = b->radius(t), x = r * cos(turn), z = r * sin(turn);
    const double y = b->height * (t - .5), c = cos(.4), sine = sin(.4);
    const struct position p = {b->center.x + x, b->center.y + c * y + sine * z,
                               b->center.z + c * z - sine * y};
    return p;
}

static void add_body(struct scene *s, const struct body *b)
{
    enum { AROUND = 32, DOWN = 16 };
    const double step = 6.283185307179586 / AROUND;
    for (int i = 0; i < DOWN; i++)
        for (int k = 0; k < AROUND; k++) {
            const double t0 = i / (double)DOWN, t1 = (i + 1) / (double)DOWN;
            const struct position quad[4] = {
                on_body(b, t0, k * step), on_body(b, t0, (k + 1) * step),
                on_body(b, t1, (k + 1) * step), on_body(b, t1, k * step)};
            add_quad(s, quad);
        }
}

static double ball(double t)
{
    return sqrt(fmax(0, .25 - (t - .5) * (t - .5)));
}

static double waist(double t)
{
    return .3 + .15 * sin(9 * t + 1);
}

static void spheres(struct scene *s, struct random *r)
{
    const struct body a = {{-.2, 0, 2}, 1, ball}, b = {{.2, .1, 2.1}, 1, ball};
    (void)r;
    add_body(s, &a);
    add_body(s, &b);
}

static void floor_and_objects(struct scene *s, struct random *r)
{
    const struct position ground[4] = {
        {-2, .5, 1.2}, {2, .5, 1.2}, {2, .5, 5}, {-2, .5, 5}};
    const struct body a = {{-.6, .1, 2.5}, .9, ball};
    const struct body b = {{.4, .2, 2}, .6, waist};
    (void)r;
    add_quad(s, ground);
    add_body(s, &a);
    add_body(s, &b);
}

/* Each of three bars lies over the next. */
static void cycle(struct scene *s, struct random *r)
{
    (void)r;
    for (int i = 0; i < 3; i++) {
        const double turn = i * 2.0943951023931953;
        const double c = cos(turn), n = sin(turn);
        struct position bar[4];
        for (int k = 0; k < 4; k++) {
            const double x = k == 0 || k == 3 ? -.8 : .8;
            const double y = k < 2 ? .2 : .35;
            bar[k].x = c * x - n * y;
            bar[k].y = n * x + c * y;
            bar[k].z = 2 + .2 * x;
        }
        add_quad(s, bar);
    }
}

static double any(struct random *r, double low, double high)
{
    return low + (high - low) * random_between(r, 0, 1 << 20) / (1 << 20);
}

static void soup(struct scene *s, struct random *r)
{
    for (int i = 0; i < 60; i++) {
        struct position p[3];
        for (int k = 0; k < 3; k++) {
            p[k].z = any(r, 1, 4);
            p[k].x = any(r, -.6, .6) * p[k].z;
            p[k].y = any(r, -.6, .6) * p[k].z;
        }
        add(s, p[0], p[1], p[2]);
    }
}

static void vase(struct scene *s, struct random *r)
{
    const struct body b = {{0, 0, 2}, 1.4, waist};
    (void)r;
    add_body(s, &b);
}

const struct scene_maker scene_makers[] = {
    {"crossing spheres", spheres, 1},
    {"floor and objects", floor_and_objects, 1},
    {"3-cycle", cycle, 1},
    {"soup", soup, 40},
    {"vase", vase, 1},
    {NULL, NULL, 0},
};

void scene_make(struct scene *s, const struct scene_maker *maker,
                struct random *r)
{
    const struct pel_mesh mesh = {.position = scene_unit};
    if (pel_projector_init(&s->projector, &mesh, &pel_pose_none, &scene_camera,
                           &scene_screen))
        method_fail("a camera is refused", "point it at something");
    s->n = 0;
    maker->make(s, r);
}
