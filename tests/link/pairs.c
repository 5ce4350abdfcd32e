/* The stack of every shape with every paint: prints `SHAPE PAINT BYTES`, the
 * frames of draw_SHAPE and below. */
#include "draws.h"
#include "makes.h"
#include "port/cortex_m/semihost.h"
#include "port/cortex_m/stack_probe.h"

#define NAMED(kind, name)    \
    {                        \
#name, kind##_##name \
    }

static const struct {
    const char *name;
    draw_function *draw;
} shapes[] = {
    NAMED(draw, triangle),
    NAMED(draw, triangle_or_line),
    NAMED(draw, polygon),
    NAMED(draw, rectangle),
    NAMED(draw, line),
    NAMED(draw, thick_line),
    NAMED(draw, circle),
    NAMED(draw, ring),
    NAMED(draw, sector),
    NAMED(draw, arc),
    NAMED(draw, ellipse),
    NAMED(draw, rounded_rectangle),
    NAMED(draw, triangle_outline),
    NAMED(draw, rectangle_outline),
    NAMED(draw, rounded_rectangle_outline),
    NAMED(draw, circle_outline),
    NAMED(draw, ellipse_outline),
    NAMED(draw, arc_outline),
    NAMED(draw, polygon_outline),
    NAMED(draw, text),
};

static const struct {
    const char *name;
    make_function *make;
} paints[] = {
    NAMED(make, flat),     NAMED(make, flat_alpha),
    NAMED(make, gouraud),  NAMED(make, linear),
    NAMED(make, radial),   NAMED(make, conic),
    NAMED(make, hue),      NAMED(make, fan),
    NAMED(make, nearest),  NAMED(make, nearest_colors),
    NAMED(make, bilinear), NAMED(make, dither),
    NAMED(make, user),
};

struct pair {
    draw_function *draw;
    const struct pel_paint *paint;
};

static void draw(const void *argument)
{
    const struct pair *pair = argument;
    pair->draw(pair->paint);
}

/* What `draw` and its callee's frame take. */
static void draw_nothing(const struct pel_paint *paint)
{
    (void)paint;
}

static void print_pair(const char *shape, const char *paint, uint32_t bytes)
{
    semihost_write(shape);
    semihost_write(" ");
    semihost_write(paint);
    semihost_write(" ");
    semihost_write_number(bytes);
    semihost_write("\n");
}

int main(void)
{
    const struct pair nothing = {draw_nothing, NULL};
    const uint32_t own = stack_used(draw, &nothing);
    for (unsigned i = 0; i < sizeof paints / sizeof *paints; i++) {
        const struct pel_paint *paint = paints[i].make();
        for (unsigned k = 0; k < sizeof shapes / sizeof *shapes; k++) {
            const struct pair pair = {shapes[k].draw, paint};
            print_pair(shapes[k].name, paints[i].name,
                       stack_used(draw, &pair) - own);
        }
    }
    return 0;
}
