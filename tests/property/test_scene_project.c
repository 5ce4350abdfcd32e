/* Places on screen against the projection in extended precision. */
#include "tests/support/any_scene.h"
#include "tests/support/check.h"
#include "tests/support/reference_scene.h"

/* Sub-pixels of a unit at distance 1, by the distances that the header names.
 */
static real allowed(const struct any_scene *s, const real place[3],
                    const real screen[3])
{
    const real z = screen[2];
    const struct pel_camera *c = &s->scene.camera;
    const struct pel_rect *v = &s->scene.viewport;
    real far = 0, near[3];
    for (int k = 0; k < 3; k++) {
        const real at = s->scene.pose ? (real)s->pose.at[k] / 65536 : 0;
        near[k] =
            real_abs(place[k] - at) + real_abs(at - (real)c->eye[k] / 65536);
        far += near[k];
    }
    real scale = 0;
    for (int k = 0; k < 2; k++) {
        const real px = k ? v->y1 - v->y0 : v->x1 - v->x0;
        real per_unit = px * 256 / c->sensor[k] * c->focal;
        if (c->projection == PEL_ORTHOGRAPHIC)
            per_unit = px * 256 * 65536 / c->sensor[k] * z;
        const real middle = k ? (v->y0 + v->y1) / 2.0L : (v->x0 + v->x1) / 2.0L;
        per_unit += real_abs(screen[k] - middle) * 256;
        scale = per_unit > scale ? per_unit : scale;
    }
    return scale * far / z / (1 << 28);
}

static uint64_t vertices, moved;
static real worst, tightest;

static void check_vertex(const struct any_scene *s,
                         const struct pel_projector *p, uint32_t i)
{
    struct pel_projected got;
    real place[3], want[3];
    pel_project(p, s->positions[i], &got);
    reference_place(&s->scene, i, place);
    reference_project(&s->scene, place, want);
    assert_true(got.x != PEL_NOT_ON_SCREEN);
    const struct pel_point nearest = reference_snap(want);
    const real dx = real_abs(got.x - want[0] * 256);
    const real dy = real_abs(got.y - want[1] * 256);
    const real error = (dx > dy ? dx : dy) - 0.5L;
    const real bound = allowed(s, place, want);
    vertices++;
    moved += got.x != nearest.x || got.y != nearest.y;
    worst = error > worst ? error : worst;
    tightest = error / bound > tightest ? error / bound : tightest;
    if (error > bound)
        fail_msg("vertex %u: %d, %d, not %.6f, %.6f sub-pixels, off by 0.5 + "
                 "%g, allowed %g; %s",
                 i, got.x, got.y, (double)want[0] * 256, (double)want[1] * 256,
                 (double)error, (double)bound, cases_replay());
}

/* `up` nearly along the view, and as long as its range. */
static void lean(struct random *r, struct pel_camera *c)
{
    int64_t direction[3], size = 1;
    for (int k = 0; k < 3; k++) {
        direction[k] = (int64_t)c->target[k] - c->eye[k];
        size = direction[k] > size    ? direction[k]
               : -direction[k] > size ? -direction[k]
                                      : size;
    }
    for (int k = 0; k < 3; k++)
        c->up[k] = (int32_t)(direction[k] * ((1 << 30) - 32) / size) +
                   random_between(r, -30, 30);
}

TEST(vertices_are_where_they_belong)
{
    static struct any_scene s;
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        struct pel_projector p;
        any_scene(&c.random, &s, 4096);
        if (random_word(&c.random) % 4 == 0)
            lean(&c.random, &s.scene.camera);
        if (pel_projector_init(&p, s.scene.mesh, any_scene_pose(&s),
                               &s.scene.camera, &s.scene.viewport) != PEL_OK)
            continue; /* `up` along the view */
        for (uint32_t i = 0; i < s.mesh.vertices; i++)
            check_vertex(&s, &p, i);
    }
    assert_true(cases_alone() || vertices > cases_scaled(5000) * 50);
    print_message("%llu vertices, %llu at a neighbour of the nearest "
                  "sub-pixel; error before rounding at most %.2g sub-pixels, "
                  "%.2g of the bound\n",
                  (unsigned long long)vertices, (unsigned long long)moved,
                  (double)worst, (double)tightest);
}

/* The eye close to a vertex, the farthest a thousand times as far away. */
static void move_to_a_vertex(struct random *r, struct any_scene *s)
{
    struct pel_camera *c = &s->scene.camera;
    const struct pel_pose *pose = s->scene.pose;
    const struct pel_quantization *q = &s->mesh.position;
    const uint32_t near = random_word(r) % s->mesh.vertices;
    int64_t v[3];
    for (int k = 0; k < 3; k++)
        v[k] = pel_quantization_value(q, k, s->positions[near][k]);
    if (pose)
        pel_matrix_apply(&pose->turn, v, 30, v);
    for (int k = 0; k < 3; k++) {
        const int64_t place =
            pel_scale_down(v[k], q->shift - 16) + (pose ? pose->at[k] : 0);
        const int64_t away = (int64_t)c->eye[k] - c->target[k];
        c->eye[k] = (pel_length)(place + away / 2000);
        c->target[k] = (pel_length)(c->eye[k] - away);
    }
    c->near_plane = 1;
    c->projection = PEL_PERSPECTIVE;
    c->focal = 30000;
    c->sensor[0] = c->sensor[1] = 36000;
}

TEST(far_a_thousand_times_near)
{
    static struct any_scene s;
    real ratio = 0;
    vertices = moved = 0;
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        struct pel_projector p;
        any_scene(&c.random, &s, 240);
        if (s.mesh.position.shift > 15) /* the world's steps are too coarse */
            continue;
        move_to_a_vertex(&c.random, &s);
        assert_int_equal(pel_projector_init(&p, s.scene.mesh,
                                            any_scene_pose(&s), &s.scene.camera,
                                            &s.scene.viewport),
                         PEL_OK);
        real nearest = 0, farthest = 0;
        for (uint32_t i = 0; i < s.mesh.vertices; i++) {
            struct pel_projected got;
            real place[3], want[3];
            pel_project(&p, s.positions[i], &got);
            reference_place(&s.scene, i, place);
            reference_project(&s.scene, place, want);
            if (got.x == PEL_NOT_ON_SCREEN || want[2] <= 0)
                continue;
            check_vertex(&s, &p, i);
            nearest = nearest == 0 || want[2] < nearest ? want[2] : nearest;
            farthest = want[2] > farthest ? want[2] : farthest;
        }
        if (nearest > 0 && farthest / nearest > ratio)
            ratio = farthest / nearest;
    }
    print_message("far / near up to %.0f: %llu vertices, %llu at a "
                  "neighbour\n",
                  (double)ratio, (unsigned long long)vertices,
                  (unsigned long long)moved);
}
