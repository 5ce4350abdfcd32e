/* Vertex normals from faces, and the light of a place, in extended precision.
 */
#include "core/pel.h"
#include "tests/support/any_scene.h"
#include "tests/support/check.h"
#include "tests/support/reference_scene.h"

enum { VERTICES = 12, TRIANGLES = 30 };

struct lump {
    struct pel_mesh mesh;
    int16_t positions[VERTICES][3];
    uint8_t indices[TRIANGLES][3];
};

static void any_lump(struct random *r, struct lump *m)
{
    const int32_t size = random_between(r, 0, 3) ? 32767 : 3;
    for (int i = 0; i < VERTICES; i++)
        for (int k = 0; k < 3; k++)
            m->positions[i][k] = (int16_t)random_between(r, -size, size);
    for (int i = 0; i < TRIANGLES; i++)
        for (int k = 0; k < 3; k++)
            m->indices[i][k] = (uint8_t)(random_word(r) % VERTICES);
    m->mesh = (struct pel_mesh){.vertices = VERTICES,
                                .triangles =
                                    (uint32_t)random_between(r, 1, TRIANGLES),
                                .position = {{0, 0, 0}, 1, 8},
                                .positions = (void *)m->positions,
                                .indices8 = (void *)m->indices};
}

static void add_face(const struct lump *m, uint32_t t, uint32_t vertex,
                     real sum[3])
{
    real p[3][3];
    uint32_t times = 0;
    for (int i = 0; i < 3; i++) {
        times += m->indices[t][i] == vertex;
        for (int k = 0; k < 3; k++)
            p[i][k] = m->positions[m->indices[t][i]][k];
    }
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        sum[k] += times * ((p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) -
                           (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]));
    }
}

TEST(normals_are_means_of_faces)
{
    static struct lump m;
    uint64_t scratch[VERTICES * 3], zeros = 0;
    int16_t got[VERTICES][3];
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        any_lump(&c.random, &m);
        assert_int_equal(
            pel_mesh_normals(&m.mesh, got, scratch, sizeof scratch), PEL_OK);
        for (uint32_t v = 0; v < VERTICES; v++) {
            real sum[3] = {0, 0, 0};
            for (uint32_t t = 0; t < m.mesh.triangles; t++)
                add_face(&m, t, v, sum);
            const real length =
                real_root(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
            zeros += length == 0;
            for (int k = 0; k < 3; k++) {
                const real want = length > 0 ? sum[k] / length * 32767 : 0;
                const real off = got[v][k] - want;
                if (off > 0.6L || off < -0.6L)
                    fail_msg("vertex %u, axis %d: %d, not %.3f; %s", v, k,
                             got[v][k], (double)want, cases_replay());
            }
        }
    }
    assert_true(cases_alone() || zeros > 0);
    assert_int_equal(
        pel_mesh_normals(&m.mesh, got, scratch, sizeof scratch - 1),
        PEL_ERROR_SCRATCH);
}

static void light_of(const struct pel_mesh_lights *lights,
                     const int32_t value[PEL_LIGHT_VALUES],
                     struct pel_light_sum *sum)
{
    pel_cosine towards[3][3];
    const bool lit = pel_light_start(lights, value, towards, sum);
    for (int32_t i = 0; lit && i < lights->count; i++) {
        pel_light_towards(&lights->light[i], value + PEL_AT_POSITION, towards);
        pel_light_add(lights, &lights->light[i], towards, sum);
    }
}

/* Highlights with an exponent of 256 at full strength, where an error of the
 * reflected direction counts 256 times; and a zero normal. */
TEST(light_of_a_place)
{
    static struct any_scene s;
    real worst = 0;
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        struct pel_mesh_lights lights;
        struct pel_mesh_light light[ANY_LIGHTS];
        any_scene(&c.random, &s, 64);
        any_scene_light(&c.random, &s);
        s.lighting.shininess = random_between(&c.random, 1, 256);
        s.lighting.specular = 65536;
        s.normals[0][0] = s.normals[0][1] = s.normals[0][2] = 0;
        lights.light = light;
        assert_int_equal(pel_mesh_lights_init(&lights, &s.lighting, &s.mesh,
                                              any_scene_pose(&s),
                                              s.scene.camera.eye),
                         PEL_OK);
        for (uint32_t i = 0; i < s.mesh.vertices; i++) {
            const real white[3] = {255, 255, 255};
            real place[3], normal[3], want[3];
            int32_t value[PEL_LIGHT_VALUES];
            struct pel_light_sum sum;
            pel_mesh_lights_position(&lights, s.positions[i],
                                     value + PEL_AT_POSITION);
            pel_mesh_normal(&s.mesh, i, value + PEL_AT_NORMAL);
            light_of(&lights, value, &sum);
            reference_place(&s.scene, i, place);
            reference_normal(&s.scene, i, normal);
            reference_light(&s.scene, place, normal, white, want);
            for (int k = 0; k < 3; k++) {
                real off = (real)(sum.surface[k] + sum.plain[k]) * 255 / 65536;
                off = off > 255 ? 255 - want[k] : off - want[k];
                off = off < 0 ? -off : off;
                worst = off > worst ? off : worst;
                if (off > 0.25L)
                    fail_msg("vertex %u, channel %d: off by %.3f of 255; %s", i,
                             k, (double)off, cases_replay());
            }
        }
    }
    print_message("light of a place is off by %.4f of 255 at most\n",
                  (double)worst);
}
