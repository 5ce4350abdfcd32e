#include "api.h"

/* Legal as often as not; the array is as long as what is legal says. */
static struct pel_ramp ramp_of(struct api *a)
{
    const uint32_t kind = input_byte(&a->in);
    struct pel_ramp ramp = {a->ramp, 1 + (int32_t)(kind % 64),
                            (enum pel_spread)(kind / 64 % 3)};
    if (kind == 255)
        ramp.n = input_number(&a->in) | (INT32_MIN / 2);
    if (kind == 254)
        ramp.colors = NULL;
    return ramp;
}

static void fill_ramp(struct api *a)
{
    struct pel_stop stop[4];
    for (int i = 0; i < 4; i++) {
        stop[i].at = input_number(&a->in);
        stop[i].color = input_word(&a->in);
    }
    pel_ramp_fill(a->ramp, 1 + (int32_t)input_below(&a->in, 64), stop,
                  (int32_t)input_below(&a->in, 5));
}

static void fan(struct api *a, struct pel_fan *paint, int slot)
{
    struct pel_point perimeter[API_TRIANGLES];
    pel_color colors[API_TRIANGLES];
    struct pel_fan_points points = {.perimeter = perimeter, .colors = colors};
    points.n = 1 + (int32_t)input_below(&a->in, API_TRIANGLES);
    points.hub = api_point(a);
    points.hub_color = input_word(&a->in);
    for (int i = 0; i < API_TRIANGLES; i++) {
        perimeter[i] = points.hub;
        colors[i] = points.hub_color * (uint32_t)i;
    }
    if (input_byte(&a->in) & 1)
        for (int i = 0; i < points.n; i++)
            perimeter[i] = api_point(a);
    else
        pel_fan_perimeter(perimeter, points.n, points.hub, input_number(&a->in),
                          (uint16_t)input_word(&a->in));
    if (input_byte(&a->in) & 1)
        pel_fan_set_hub(&points);
    pel_fan_init(paint, &points, a->triangle[slot]);
}

static void plane(struct api *a, struct pel_plane *p)
{
    const int shift = (int)input_below(&a->in, 64);
    p->at = input_long(&a->in) >> shift;
    p->dx = input_long(&a->in) >> shift;
    p->dy = input_long(&a->in) >> shift;
}

static void texture(struct api *a, struct pel_texture *paint)
{
    const uint32_t kind = input_byte(&a->in);
    struct pel_texels texels = {NULL, a->ramp, 8, 8, kind & 1};
    struct pel_texture_map map = PEL_TEXTURE_AT(3, 5);
    if (kind & 2)
        texels.surface = &a->surface[API_SURFACES];
    if (kind & 4) {
        texels.width = 1 + (int32_t)input_below(&a->in, 64);
        texels.height = 64 / texels.width;
    }
    if ((kind & 24) == 8) {
        plane(a, &map.u);
        plane(a, &map.v);
    } else if (kind & 16) {
        struct pel_point v[3];
        struct pel_texel_point t[3];
        for (int i = 0; i < 3; i++) {
            v[i] = api_point(a);
            t[i].u = input_number(&a->in);
            t[i].v = input_number(&a->in);
        }
        pel_texture_map_triangle(&map, v, t);
    }
    if (kind & 32)
        pel_texture_init_bilinear(paint, &texels, &map);
    else
        pel_texture_init_nearest(paint, &texels, &map);
    paint->wrap_u = (uint8_t)(kind / 64 % 3);
    paint->wrap_v = (uint8_t)input_below(&a->in, 3);
}

static void stripes(const struct pel_color_paint *paint, int32_t x, int32_t y,
                    int32_t n, pel_color *colors)
{
    (void)paint;
    for (int32_t i = 0; i < n; i++)
        colors[i] = (uint32_t)(x + i + y) * UINT32_C(0x10204081);
}

static void pattern(struct api *a, union any_paint *p)
{
    const struct pel_rect r = api_rect(a), box = api_rect(a);
    const pel_color on = input_word(&a->in), off = input_word(&a->in);
    const struct pel_checker_fields fields = {r.x0, r.y0, r.x1, r.y1};
    const struct pel_hatch_lines lines = {r.x0, r.y0, r.x1, r.y1, box.x0};
    switch (input_below(&a->in, 3)) {
    case 0:
        pel_checker_init(&p->checker, &fields, on, off);
        break;
    case 1:
        pel_hatch_init(&p->hatch, &lines, on, off);
        break;
    default:
        pel_nine_slice_init(&p->slices, &a->surface[API_SURFACES], &r, &box);
        p->slices.tiled = on & 1;
    }
}

/* Blends and dithers have sources in lower slots, so that none is its own by
 * way of others. */
static void blend(struct api *a, struct pel_blend *paint, int slot)
{
    const struct pel_paint *const source =
        slot > 0 ? &a->paint[input_below(&a->in, (uint32_t)slot)].paint : NULL;
    pel_blend_init(paint, source, (enum pel_blend_mode)input_below(&a->in, 4));
}

void api_paint(struct api *a)
{
    static const struct pel_color_paint striped =
        PEL_COLOR_PAINT(stripes, false);
    const uint32_t kind = input_byte(&a->in);
    const int slot = (int)(kind / 16 % API_PAINTS);
    union any_paint *p = &a->paint[slot];
    const struct pel_flat flat = PEL_FLAT(input_word(&a->in));
    const struct pel_ramp ramp = ramp_of(a);
    const struct pel_point at = api_point(a);
    struct pel_rings rings = {at, input_number(&a->in), flat.color & 0xFFFF};
    switch (kind % 14) {
    case 0:
        pel_linear_init(&p->linear, at, api_point(a), &ramp);
        break;
    case 1:
        pel_radial_init(&p->radial, &rings, &ramp);
        break;
    case 2:
        pel_conic_init(&p->conic, at, rings.phase, &ramp);
        break;
    case 3:
        pel_hue_wheel_init(&p->wheel, at, rings.phase, input_byte(&a->in),
                           input_byte(&a->in));
        break;
    case 4:
        fan(a, &p->fan, slot);
        break;
    case 5:
    case 6:
    case 7:
        texture(a, &p->texture);
        break;
    case 8:
        pel_dither_init(
            &p->dither,
            &a->paint[input_below(&a->in, (uint32_t)slot + 1)].paint);
        break;
    case 9:
        pattern(a, p);
        break;
    case 10:
        blend(a, &p->blend, slot);
        break;
    case 11:
        p->colors = striped;
        break;
    case 12:
        fill_ramp(a);
        break;
    default:
        p->flat = flat;
        break;
    }
}
