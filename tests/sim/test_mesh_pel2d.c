/* pel2d files: what is written is read back the same; what is wrong is refused
 * with its line. */
#include "tests/support/cases.h"
#include "tests/support/check.h"

#include "files.h"
#include "sim/cli/list.h"
#include "sim/mesh/pel2d.h"

#define HEAD "pel2d 3 1\n"
#define A "0 0 1 2 3 0 0 0\n"
#define BC "8.5 -0.00390625 255 0 9 -1.5 0.25 1\n0 7 0 0 0 1e-3 1 0\n"

struct row {
    const char *text;
    const char *message; /* after "pel: FILE:" */
};

static const struct row wrong[] = {
    {"", "1: the file ends here: expected 'pel2d VERTICES TRIANGLES'"},
    {"\n", "1: 0 fields: expected 'pel2d VERTICES TRIANGLES'"},
    {"pel2d\n", "1: 1 fields"},
    {"pel2d 3\n", "1: 2 fields"},
    {"pel3d 3 1\n", "1: the file begins with 'pel3d'"},
    {"pel2d x 1\n", "1: VERTICES is 'x': expected a whole number"},
    {"pel2d -1 1\n", "1: VERTICES is '-1'"},
    {"pel2d 3 99999999999\n", "1: TRIANGLES is '99999999999'"},
    {"pel2d 3 1 1\n", "1: 4 fields"},
    {HEAD, "2: the file ends here: expected a vertex, 'x y r g b depth u v'"},
    {HEAD "0 0 1 2 3 0 0\n", "2: 7 fields"},
    {HEAD "0 0 1 2 3 0 0 0 0\n", "2: more than 8 fields"},
    {HEAD "0 0 1 2 3 0 0 0 0 0 0\n", "2: more than 8 fields"},
    {HEAD A "x 0 1 2 3 0 0 0\n", "3: x is 'x': expected decimal pixels"},
    {HEAD A "1e2 0 1 2 3 0 0 0\n", "3: x is '1e2'"},
    {HEAD A "0 0.1 1 2 3 0 0 0\n",
     "3: y is 0.1: expected a whole number of 1/256 px"},
    {HEAD A "0.00390625000001 0 1 2 3 0 0 0\n", "3: x is 0.00390625000001"},
    {HEAD A "32768 0 1 2 3 0 0 0\n",
     "3: x is 32768: expected -32768 to 32767.99609375"},
    {HEAD A "0 -32768.00390625 1 2 3 0 0 0\n",
     "3: y is -32768.00390625: expected -32"},
    {HEAD A "0 0 256 2 3 0 0 0\n",
     "3: r is '256': expected a whole number from 0 to 2"},
    {HEAD A "0 0 1 -2 3 0 0 0\n", "3: g is '-2'"},
    {HEAD A "0 0 1 2 3.0 0 0 0\n", "3: b is '3.0'"},
    {HEAD A "0 0 1 2 3 far 0 0\n", "3: depth is 'far'"},
    {HEAD A "0 0 1 2 3 0 nan 0\n", "3: u is 'nan'"},
    {HEAD A "0 0 1 2 3 0 0 1e7\n", "3: v is '1e7'"},
    {HEAD A BC, "5: the file ends here: expected a triangle, 'i j k'"},
    {HEAD A BC "0 1\n", "5: 2 fields: expected a triangle"},
    {HEAD A BC "0 1 3\n", "5: k is '3': expected a whole number from 0 to 2"},
    {HEAD A BC "-1 1 2\n", "5: i is '-1'"},
    {HEAD A BC "0 4294967296 2\n", "5: j is '4294967296'"},
    {HEAD A BC "0 1 2\n0 1 2\n", "6: text after the last triangle"},
    {HEAD A BC "0 1 2\n\n \nx", "8: text after the last triangle"},
    {"pel2d 0 1\n0 0 0\n", "2: a triangle in a file without vertices"},
};

static void refuse(size_t row, const char *text, size_t size,
                   const char *message)
{
    struct pel2d flat;
    struct messages m;
    char expected[4300];
    char *path = file_with(text, size);
    snprintf(expected, sizeof(expected), "pel: %s:%s", path, message);
    messages_begin(&m);
    bool taken = pel2d_load(&flat, path);
    messages_end(&m);
    unlink(path);
    free(path);
    if (taken)
        fail_msg("row %zu is taken", row);
    assert_null(flat.vertex);
    if (strncmp(m.text, expected, strlen(expected)) != 0)
        fail_msg("row %zu\nexpected %s\ngot      %s", row, expected, m.text);
}

TEST(wrong)
{
    for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); i++)
        refuse(i, wrong[i].text, strlen(wrong[i].text), wrong[i].message);
}

TEST(wrong_bytes)
{
    static const char nul[] = HEAD "0 0 1 2 3 0 \0 0\n";
    char line[2048] = "pel2d ";
    refuse(0, nul, sizeof(nul) - 1, "2: a NUL byte: expected a vertex");
    memset(line + 6, '1', sizeof(line) - 6);
    refuse(1, line, sizeof(line), "1: a line of over 1,023 bytes");
    /* A first line that lies about its file costs no memory. */
    refuse(2, "pel2d 268435456 268435456\n", 26, "2: the file ends here");
}

TEST(every_cut)
{
    static const char whole[] = HEAD A BC "0 1 2";
    for (size_t n = 0; n < sizeof(whole) - 2; n++)
        refuse(n, whole, n, "");
}

static void check_right(const char *text)
{
    struct pel2d flat;
    char *path = file_with(text, strlen(text));
    assert_true(pel2d_is_file(path));
    assert_true(pel2d_load(&flat, path));
    unlink(path);
    free(path);
    assert_int_equal(flat.vertices, 3);
    assert_int_equal(flat.triangles, 1);
    assert_int_equal(flat.vertex[1].at.x, 2176);
    assert_int_equal(flat.vertex[1].at.y, -1);
    assert_int_equal(flat.vertex[1].color, PEL_RGB(255, 0, 9));
    assert_true(flat.vertex[1].u >= 0.25 && flat.vertex[1].u <= 0.25);
    assert_int_equal(flat.vertex[2].depth.limb[1], 1000000000000000);
    assert_int_equal(flat.triangle[0][0], 2);
    assert_int_equal(flat.triangle[0][2], 1);
    pel2d_free(&flat);
}

/* With and without a byte order mark. */
TEST(right)
{
    static const char text[] =
        "\xEF\xBB\xBFpel2d\t3  1\r\n" A BC "2 0 1\n\n \t\n";
    check_right(text);
    check_right(text + 3);
}

static void add_random(struct pel2d *flat, struct random *r)
{
    struct pel2d_vertex v = {
        {(int32_t)(random_word(r) % 16777216) + PEL_COORDINATE_MIN,
         (int32_t)(random_word(r) % 16777216) + PEL_COORDINATE_MIN},
        PEL_RGB(random_word(r) % 256, random_word(r) % 256,
                random_word(r) % 256),
        {{0}},
        random_word(r) / 4e9,
        random_word(r) / -3e9};
    int64_t sign = random_word(r) % 2 ? 1 : -1;
    for (int i = 0; i < 3; i++)
        v.depth.limb[i] = sign * (int64_t)(random_word(r) % 1000000000) *
                          (int64_t)(random_word(r) % 1000000000);
    assert_true(list_add(&flat->vertex, &flat->vertices, &v, sizeof v));
}

static void assert_same(const struct pel2d *a, const struct pel2d *b)
{
    assert_int_equal(a->vertices, b->vertices);
    assert_int_equal(a->triangles, b->triangles);
    for (uint32_t i = 0; i < a->vertices; i++) {
        const struct pel2d_vertex *v = &a->vertex[i], *w = &b->vertex[i];
        assert_int_equal(v->at.x, w->at.x);
        assert_int_equal(v->at.y, w->at.y);
        assert_int_equal(v->color, w->color);
        assert_memory_equal(&v->depth, &w->depth, sizeof(v->depth));
        assert_memory_equal(&v->u, &w->u, sizeof(v->u));
        assert_memory_equal(&v->v, &w->v, sizeof(v->v));
    }
    assert_memory_equal(a->triangle, b->triangle,
                        a->triangles * sizeof(*a->triangle));
}

TEST(round_trip)
{
    struct pel2d flat = {0}, back;
    struct random r = {1};
    char *path = file_with("", 0);
    for (int i = 0; i < 3000; i++)
        add_random(&flat, &r);
    flat.vertex[0].at =
        (struct pel_point){PEL_COORDINATE_MIN, PEL_COORDINATE_MAX};
    for (int i = 0; i < 1000; i++) {
        const uint32_t index[3] = {(uint32_t)(random_word(&r) % 3000),
                                   (uint32_t)(random_word(&r) % 3000), 2999};
        assert_true(
            list_add(&flat.triangle, &flat.triangles, index, sizeof index));
    }
    assert_true(pel2d_save(&flat, path));
    assert_true(pel2d_load(&back, path));
    assert_same(&flat, &back);
    unlink(path);
    free(path);
    pel2d_free(&flat);
    pel2d_free(&back);
}
