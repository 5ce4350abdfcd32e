/* The sheet of pel view: what is picked is what is seen, and a picture of which
 * only the changed areas were drawn is the one that is drawn whole. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/format/formats.h"
#include "core/image/copy.h"
#include "sim/script/commands.h"
#include "sim/view/sheet.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

static int random_below(int n)
{
    static struct random r = {1};
    return random_between(&r, 0, n - 1);
}

enum { SIZE = 40, SHAPES = 12 };

static void put_shape(FILE *out)
{
    static const char *const forms[] = {
        "triangle pppppp",
        "polygon evenodd pppppppp",
        "polygon nonzero pppppp",
        "circle ppl",
        "rect ppll",
        "line pppp",
        "ring pplr",
        "sector ppltu",
        "arc pplrtu",
        "ellipse ppll",
        "roundrect pplll",
        "thickline ppppl",
        "stroke line lpppppp",
        "stroke loop lpppppp",
        "path evenodd pppppppp",
        "outline triangle pppppp",
        "outline circle ppl",
        "outline rect ppll",
        "outline ellipse ppll",
    };
    const char *form = forms[random_below(sizeof forms / sizeof forms[0])];
    const char *kind = strrchr(form, ' ') + 1;
    fprintf(out, "%.*s", (int)(kind - form - 1), form);
    for (double low = 0; *kind; kind++) {
        const double part = random_below(2560) / 256.0;
        if (*kind == 'p')
            fprintf(out, " %.8f", part * (SIZE + 16) / 10 - 8);
        else if (*kind == 'l' || *kind == 'r')
            fprintf(out, " %.8f", low = part + (*kind == 'r' ? low : 0));
        else
            fprintf(out, " %.5f", part / 20 + (*kind == 'u' ? 0.5 : 0));
    }
    fputc('\n', out);
}

/* Shape i has the color i + 1. */
static void read_scene(struct script *script)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    fprintf(file, "canvas %d %d xrgb8888\n", SIZE, SIZE);
    for (int i = 0; i < SHAPES; i++) {
        if (random_below(6) == 0)
            fprintf(file, "clip %d %d %d %d\n", random_below(16),
                    random_below(16), random_below(SIZE), random_below(SIZE));
        fprintf(file, "paint flat #%06x\n", (unsigned)i + 1);
        put_shape(file);
    }
    fputs("paint flat #ffffff00\n", file); /* nothing of it is seen */
    put_shape(file);
    fclose(file);
    file = fmemopen(text, size, "r");
    assert_true(script_read(script, file, "random scene", NULL));
    fclose(file);
    free(text);
}

TEST(the_shape_that_is_seen_is_picked)
{
    for (int scene = 0; scene < 100; scene++) {
        struct script script;
        struct canvas canvas;
        struct picture picture;
        read_scene(&script);
        assert_true(canvas_init(&canvas, script.format, SIZE, SIZE));
        assert_true(script_draw(&script, &canvas, -1));
        assert_true(canvas_picture(&canvas, &picture));
        for (int i = 0; i < SIZE * SIZE; i++) {
            const int x = i % SIZE, y = i / SIZE;
            const long item = script_pick(&script, x, y);
            const int seen = (int)(picture_row(&picture, y)[x] & 0xFFFFFF);
            int picked = 0;
            for (long k = 0; k <= item; k++)
                picked += script_is_painted(&script.items[k]);
            if (picked != seen)
                fail_msg("scene %d, pixel %d %d: shape %d is seen, %d picked",
                         scene, x, y, seen, picked);
        }
        picture_free(&picture);
        canvas_free(&canvas);
        script_free(&script);
    }
}

/* Its color depends on what is below. */
TEST(what_is_blended_is_picked)
{
    static char text[] = "canvas 4 4 xrgb8888\nclear #102030\n"
                         "option blend multiply\nrect 0 0 2 4\n";
    struct script script;
    FILE *file = fmemopen(text, sizeof text - 1, "r");
    assert_true(script_read(&script, file, "blended", NULL));
    fclose(file);
    assert_int_equal(script_pick(&script, 1, 1), 3);
    assert_int_equal(script_pick(&script, 2, 1), -1);
    script_free(&script);
}

static void press(struct sheet *sheet, int key)
{
    const struct pel_input in = {
        .kind = PEL_INPUT_KEY, .state = PEL_INPUT_DOWN, .code = (uint16_t)key};
    sheet->show.input(&sheet->show, &in);
}

/* How many pixels of a sheet's picture are not those of a script. */
static int count_others(struct sheet *sheet, const struct script *script)
{
    struct canvas canvas[2];
    int others = 0;
    assert_true(sheet_compose(sheet));
    for (int i = 0; i < 2; i++) {
        assert_true(canvas_init(&canvas[i], script->format, script->width,
                                script->height));
        assert_true(script_draw(i ? &sheet->script : script, &canvas[i], -1));
    }
    const uint32_t *a = canvas[0].memory, *b = canvas[1].memory;
    for (int i = 0; i < script->width * script->height; i++)
        others += a[i] != b[i];
    for (int i = 0; i < 2; i++)
        canvas_free(&canvas[i]);
    return others;
}

/* Shapes behind it find the paint and the options that the file has. */
TEST(a_style_is_for_its_shape_alone)
{
    static const char text[] =
        "canvas 40 10 xrgb8888\nrect 0 0 10 10\n"
        "option spread reflect\noption phase 0.3\noption cells 64\n"
        "paint radial 0 0 9 0 #ff0000 1 #00ff0080\nrect 10 0 10 10\n"
        "circle 25 5 5\npaint vertex #ff0000 #ffff00 #0000ff\n"
        "triangle 30 0 40 0 35 10\n";
    char path[] = "/tmp/pel_sheet_XXXXXX";
    struct sheet sheet;
    struct script script;
    const int fd = mkstemp(path);
    assert_true(write(fd, text, sizeof text - 1) == sizeof text - 1);
    close(fd);
    assert_true(sheet_init(&sheet, path) && script_load(&script, path, NULL));
    unlink(path);
    for (int k = 0; k < sheet.shapes; k++) {
        sheet.picked = k;
        sheet.stale = true;
        assert_int_equal(count_others(&sheet, &script), 0);
        for (int fill = '1'; fill <= '4'; fill++) {
            press(&sheet, fill);
            const int others = count_others(&sheet, &script);
            if (others == 0 || others > 100)
                fail_msg("key %c, shape %d: %d pixels change", fill, k, others);
        }
        press(&sheet, '0');
    }
    assert_int_equal(count_others(&sheet, &script), 0);
    script_free(&script);
    sheet_free(&sheet);
}

/* Something that a user may do. */
static struct pel_input any_input(void)
{
    static const char keys[] = "12340+- 1234+-+-\t\t\t\r xxmbdois";
    const int k = random_below((int)sizeof keys - 1);
    struct pel_input in = {.kind = PEL_INPUT_KEY,
                           .state = PEL_INPUT_DOWN,
                           .code = (uint16_t)keys[k]};
    if (random_below(3) == 0)
        in = (struct pel_input){.kind = PEL_INPUT_POINT,
                                .x = (int16_t)random_below(100),
                                .y = (int16_t)random_below(70)};
    else if (random_below(3) == 0)
        in = (struct pel_input){
            .kind = PEL_INPUT_BUTTON, .state = PEL_INPUT_DOWN, .code = 1};
    else if (random_below(60) == 0)
        in.code = (uint16_t)(PEL_KEY_F1 + 1 + random_below(2));
    return in;
}

/* Sends what has changed from one canvas to another of its size. */
static void send(const struct pel_dirty_areas *changed, const struct canvas *to,
                 const struct canvas *from)
{
    struct pel_surface screen = to->surface;
    const struct pel_copy_part all = {&from->surface, screen.bounds, 0, 0};
    for (int k = 0; k < changed->count; k++) {
        screen.clip = changed->area[k];
        pel_copy(&screen, &all);
    }
}

/* Frame by frame beside a sheet that draws every picture whole; and what is
 * sent of the frames is enough for a screen. */
static void draw_frames(const struct pel_format *format, int frames)
{
    struct sheet part, whole;
    struct canvas canvas[2], screen;
    long sent = 0, all = 0;
    assert_true(sheet_init(&part, NULL) && sheet_init(&whole, NULL));
    part.show.resize(&part.show, 97, 65);
    whole.show.resize(&whole.show, 97, 65);
    assert_true(canvas_init(&screen, format, 113, 67));
    const size_t size = (size_t)screen.surface.stride * 67;
    for (int i = 0; i < 2; i++) {
        assert_true(canvas_init(&canvas[i], format, 113, 67));
        canvas[i].surface.clip = (struct pel_rect){8, 1, 105, 66};
    }
    for (int frame = 0; frame < frames; frame++) {
        const struct pel_input in = any_input();
        part.show.input(&part.show, &in);
        whole.show.input(&whole.show, &in);
        if (random_below(4) == 0) {
            part.show.advance(&part.show, 0);
            whole.show.advance(&whole.show, 0);
        }
        whole.stale = whole.whole = true;
        part.show.changed = (struct pel_dirty_areas){
            .count = 1, .area = {canvas[0].surface.clip}};
        assert_true(part.show.draw(&part.show, &canvas[0].surface));
        assert_true(whole.show.draw(&whole.show, &canvas[1].surface));
        const int bytes = part.script.format->bits;
        for (int k = 0; k < part.areas.count; k++) {
            const struct pel_rect *a = &part.areas.area[k];
            sent += (a->x1 - a->x0) * (a->y1 - a->y0) * (long)bytes / 8;
        }
        all += (long)part.script.width * part.script.height * bytes / 8;
        send(&part.show.changed, &screen, &canvas[0]);
        if (memcmp(canvas[0].memory, screen.memory, size) != 0)
            fail_msg("frame %d is not all sent", frame);
        if (!part.inspect.areas && !part.inspect.numbers &&
            memcmp(canvas[0].memory, canvas[1].memory, size) != 0)
            fail_msg("frame %d is another one", frame);
    }
    assert_true(sent < all);
    for (int i = 0; i < 2; i++)
        canvas_free(&canvas[i]);
    canvas_free(&screen);
    sheet_free(&part);
    sheet_free(&whole);
}

TEST(changed_areas_are_enough)
{
    draw_frames(&pel_xrgb8888, 10000);
    draw_frames(&pel_rgb565_le, 300);
    draw_frames(&pel_rgb332, 300);
    draw_frames(&pel_gray8, 300);
    draw_frames(&pel_mono1, 300);
}
