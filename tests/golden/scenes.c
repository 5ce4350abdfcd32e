/* A fixed set of small pictures, drawn in every format: prints a line
 * `SCENE FORMAT CRC32` for each, the CRC of the surface's memory. Needs printf
 * and core alone, so that the same file runs on every CPU and compiler; the
 * lines must be those of scenes.txt everywhere. */
#include "drivers/crc.h"
#include "tests/golden/size.h"

/* For boards of a few kilobytes. */
#ifdef NO_MESHES
#define MESH_SCENES
#define SMOOTH_SCENES
#else
#include "tests/golden/mesh.h"
#include "tests/golden/smooth.h"
#define SMOOTH_SCENES                                                \
    {SCENE(smooth_straight)}, {SCENE(smooth_round)}, {SCENE(paths)}, \
        {SCENE(smooth_paths)},
#define MESH_SCENES {SCENE(phong)}, {SCENE(depth)},
#endif

static uint32_t memory[WIDTH * LINES];
static uint64_t scratch[PEL_POLYGON_SCRATCH_SIZE(7) / 8 + 1];

static void draw_triangles(const struct pel_surface *s)
{
    for (int32_t i = 0; i < 12; i++) {
        const struct pel_flat flat =
            PEL_FLAT(PEL_RGB(20 * i, 255 - 17 * i, 85 * (i % 4)));
        const struct pel_point v[3] = {{12345, 9216},
                                       {i * 2333 - 1000, i * i * 151 + 77},
                                       {i * 2333 + 1333, i * i * 151 + 1401}};
        pel_triangle(s, v, &flat.paint);
    }
}

static void draw_gouraud(const struct pel_surface *s)
{
    const struct pel_point v[4] = {
        {300, 500}, {23900, 1100}, {22000, 17900}, {-900, 16000}};
    const pel_color c[4] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0),
                            PEL_RGB(0, 0, 255), PEL_RGB(255, 255, 255)};
    pel_triangle_gouraud(s, v, c);
    pel_triangle_gouraud(s, v + 1, c + 1);
}

static void draw_gouraud_alpha(const struct pel_surface *s)
{
    const struct pel_point v[4] = {
        {128, 128}, {24000, 640}, {600, 18000}, {24500, 18400}};
    const pel_color c[4] = {PEL_RGBA(255, 200, 0, 255), PEL_RGBA(0, 90, 255, 0),
                            PEL_RGBA(40, 0, 255, 128),
                            PEL_RGBA(255, 255, 255, 16)};
    draw_triangles(s);
    pel_triangle_gouraud(s, v, c);
    pel_triangle_gouraud(s, v + 1, c + 1);
}

static void draw_circles(const struct pel_surface *s)
{
    for (int32_t i = 0; i < 9; i++) {
        const struct pel_flat flat = PEL_FLAT(
            PEL_RGBA(255 - 28 * i, 29 * i, 140, i % 3 ? 60 + 20 * i : 255));
        const struct pel_point center = {3000 + i * 2500, 9100 + i % 2 * 777};
        pel_circle(s, center, 9500 - i * 1000 - i % 3, &flat.paint);
    }
}

static void draw_star(const struct pel_surface *s, enum pel_fill_rule rule)
{
    static const struct pel_point v[7] = {
        PEL_AT(48, 1), {19000, 17777}, {1111, 5003},  {24005, 4900},
        {5200, 17999}, {12200, -3000}, {12300, 21000}};
    const struct pel_polygon_shape outline = {v, 7, rule};
    const struct pel_flat flat = PEL_FLAT(PEL_RGBA(230, 180, 20, 200));
    if (pel_polygon(s, &outline, &flat.paint, scratch, sizeof scratch))
        printf("polygon: refused\n");
}

static void draw_even_odd(const struct pel_surface *s)
{
    draw_star(s, PEL_EVEN_ODD);
}

static void draw_non_zero(const struct pel_surface *s)
{
    draw_star(s, PEL_NON_ZERO);
}

static void draw_lines(const struct pel_surface *s)
{
    for (int32_t i = 0; i < 24; i++) {
        const struct pel_flat flat =
            PEL_FLAT(PEL_RGBA(10 * i, 255 - 10 * i, 200, 255 - 7 * i));
        const struct pel_point from = {12288, 9216};
        const struct pel_point to = {i < 12 ? i * 2304 - 512 : i * 700 - 3000,
                                     i < 12 ? 18700 - i * 90 : i * 512 - 7000};
        pel_line(s, from, to, &flat.paint);
        pel_rectangle(s, (struct pel_point){i * 1000, i * 300},
                      (struct pel_point){i * 1000 + 640, i * 300 + 384},
                      &flat.paint);
    }
}

/* Vertices at the ends of the range, slivers, and triangles without area. */
static void draw_far(const struct pel_surface *s)
{
    static const struct pel_point v[][3] = {
        {{PEL_COORDINATE_MIN, PEL_COORDINATE_MIN},
         {PEL_COORDINATE_MAX, 9000},
         {3000, PEL_COORDINATE_MAX}},
        {{PEL_COORDINATE_MIN, 4000},
         {PEL_COORDINATE_MAX, 4001},
         {PEL_COORDINATE_MAX, 5700}},
        {{-8000000, -5999900}, {8024000, 6018300}, {8024001, 6018500}},
        {{1000, PEL_COORDINATE_MIN}, {1300, 0}, {1290, PEL_COORDINATE_MAX}},
        {{0, 0}, {12000, 9000}, {24000, 18000}},
    };
    const pel_color c[3] = {PEL_RGB(255, 0, 128), PEL_RGB(0, 255, 40),
                            PEL_RGBA(30, 60, 255, 90)};
    for (size_t i = 0; i < sizeof v / sizeof v[0]; i++)
        pel_triangle_gouraud(s, v[i], c);
    const struct pel_flat flat = PEL_FLAT(PEL_RGBA(255, 255, 0, 128));
    const struct pel_point center = {-2000000, 1500000};
    pel_circle(s, center, 2503000, &flat.paint);
    pel_triangle_or_line(s, v[4], &flat.paint);
}

/* Every gradient, dithered on the left, and one that is transparent. */
static void draw_gradients(const struct pel_surface *s)
{
    static const pel_color stops[4] = {PEL_RGB(250, 240, 20),
                                       PEL_RGBA(200, 30, 90, 160), 0,
                                       PEL_RGBA(9, 60, 200, 220)};
    const struct pel_ramp mixed = {stops, 2, PEL_PAD};
    const struct pel_ramp many = {stops, 4, PEL_REFLECT};
    const struct pel_rings rings = {PEL_AT(61, 23.7), PEL_PX(14.3), 20000};
    const struct pel_rect left = {0, 0, WIDTH / 2, HEIGHT};
    struct pel_linear linear;
    struct pel_radial radial;
    struct pel_conic conic;
    struct pel_hue_wheel wheel;
    struct pel_surface half = *s;
    struct pel_dither dither;
    if (pel_linear_init(&linear, (struct pel_point)PEL_AT(90, 3.3),
                        (struct pel_point)PEL_AT(2.2, 60), &mixed) ||
        pel_radial_init(&radial, &rings, &many) ||
        pel_conic_init(&conic, rings.center, 777, &many) ||
        pel_hue_wheel_init(&wheel, (struct pel_point)PEL_AT(30, 50), 1, 220,
                           240) ||
        pel_dither_init(&dither, &linear.base.paint))
        printf("gradients: refused\n");
    pel_rectangle(s, (struct pel_point)PEL_AT(0, 0),
                  (struct pel_point)PEL_AT(WIDTH, HEIGHT), &linear.base.paint);
    pel_surface_clip(&half, &left);
    pel_rectangle(&half, (struct pel_point)PEL_AT(0, 0),
                  (struct pel_point)PEL_AT(WIDTH, HEIGHT), &dither.paint);
    pel_circle(s, rings.center, PEL_PX(30), &radial.base.paint);
    pel_circle(s, (struct pel_point)PEL_AT(75, 55), PEL_PX(16),
               &conic.base.paint);
    pel_circle(s, (struct pel_point)PEL_AT(30, 50), PEL_PX(18),
               &wheel.conic.base.paint);
}

/* Three rows of 16 words: a run, words as they are, a run. */
static void draw_runs_of(const struct pel_surface *s,
                         const struct pel_format *format, int32_t x)
{
    static const struct {
        uint8_t at, count;
    } counts[] = {{0, 2 * 21 + 1}, {2, 2 * 11}, {14, 2 * 40 + 1}};
    static const uint16_t rows[5] = {0, 16, 32, 16, 0};
    static uint32_t words[48];
    const uint32_t bytes = format->bits < 8 ? 1 : format->bits / 8u;
    uint8_t *const to = (uint8_t *)words;
    for (uint32_t i = 0; i < 48 * bytes; i++)
        to[i] = (uint8_t)((i + 3) * 2654435761u >> 23);
    for (uint32_t i = 0; i < 9; i++) {
        uint8_t *const word = to + (i / 3 * 16 + counts[i % 3].at) * bytes;
        memset(word, 0, bytes);
        word[0] = counts[i % 3].count;
    }
    const struct pel_runs_asset asset = {PEL_RUNS_MAGIC,
                                         PEL_RUNS_VERSION,
                                         format->id,
                                         60,
                                         5,
                                         48,
                                         words,
                                         rows,
                                         NULL};
    for (int32_t i = 0; i < 6; i++) {
        const struct pel_runs_part part = {&asset, format, x - 5 * i, 11 * i};
        pel_copy_runs(s, &part, i % 2 ? 255 : 150);
    }
}

static void draw_runs(const struct pel_surface *s)
{
    draw_runs_of(s, &pel_argb8888, 7);
    if (s->format != &pel_mono1_pages)
        draw_runs_of(s, s->format, 45);
}

static const struct scene {
    const char *name;
    void (*draw)(const struct pel_surface *);
} scenes[] = {
#define SCENE(name) #name, draw_##name
    {SCENE(triangles)},
    {SCENE(gouraud)},
    {SCENE(gouraud_alpha)},
    {SCENE(circles)},
    {SCENE(even_odd)},
    {SCENE(non_zero)},
    {SCENE(lines)},
    {SCENE(far)},
    MESH_SCENES SMOOTH_SCENES{SCENE(gradients)},
    {SCENE(runs)}};

static const struct {
    const char *name;
    const struct pel_format *format;
} formats[] = {
#define FORMAT(name) #name, &pel_##name
    {FORMAT(rgb565_le)},   {FORMAT(rgb565_be)}, {FORMAT(bgr565_le)},
    {FORMAT(xrgb1555_le)}, {FORMAT(rgb888)},    {FORMAT(bgr888)},
    {FORMAT(xrgb8888)},    {FORMAT(xbgr8888)},  {FORMAT(rgbx8888)},
    {FORMAT(bgrx8888)},    {FORMAT(rgb332)},    {FORMAT(gray8)},
    {FORMAT(gray4)},       {FORMAT(mono1)},     {FORMAT(mono1_pages)},
    {FORMAT(inks2)},       {FORMAT(gray2)}};

/* Draws the scene in bands: the bytes are those of the whole. */
static int print_crc(const struct scene *scene, const char *name,
                     const struct pel_format *format)
{
    const int32_t stride = pel_stride(format, WIDTH);
    const int32_t rows = format->id == PEL_FORMAT_MONO1_PAGES ? 1 : LINES;
    uint32_t crc = 0;
    for (int32_t y = 0; y < HEIGHT; y += LINES) {
        const struct pel_rect band = {0, y, WIDTH, y + LINES};
        struct pel_surface s;
        memset(memory, 0, sizeof memory);
        if (pel_surface_init_rect(&s, format, (uint8_t *)memory, stride,
                                  &band) != PEL_OK)
            return 1;
        pel_clear(&s, PEL_RGB(24, 40, 72));
        scene->draw(&s);
        crc = pel_crc(crc, (const uint8_t *)memory, (size_t)(rows * stride));
    }
    printf("%s %s %08" PRIx32 "\n", scene->name, name, crc);
    return 0;
}

int main(void)
{
    int failed = 0;
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++)
        for (size_t k = 0; k < sizeof formats / sizeof formats[0]; k++)
            failed |= print_crc(&scenes[i], formats[k].name, formats[k].format);
    return failed;
}
