#include "select_light.h"

#include "../base/sqrt.h"
#include "work.h"

/* 2^-n is the unit of |R - V|: 31 of them reach where w^p is below 2^-40 or so,
 * for a shininess p of 16 on, or 2. */
static int unit_bits(const struct pel_lighting *lighting)
{
    return 2 + (pel_bits_of((uint64_t)lighting->shininess) - 1) / 2;
}

enum { UNITS = 31 };

/* At least the root of v, by less than 2^-20 of it and two more: a guess that
 * is less than 2^10 2^-shift off. */
static uint32_t root_above(uint64_t v)
{
    struct pel_root root;
    pel_root_guess(v, &root);
    return root.root + (UINT32_C(1024) >> root.shift) + 2;
}

/* sqrt(a / b) in 2^-16, rounded up by up to three of them. a < 4 b, b > 0, both
 * below 2^62. */
static uint32_t ratio(uint64_t a, uint64_t b)
{
    int shift;
    const uint32_t inverse = pel_inverse_root(b, &shift);
    return (uint32_t)(pel_multiply(root_above(a), inverse) >> (46 - shift)) + 2;
}

pel_color pel_light_note(const struct pel_frame *frame, uint32_t vertex,
                         pel_color surface)
{
    const struct pel_mesh_lights *lights = &frame->lights;
    struct pel_light_sum sum;
    int32_t value[PEL_VALUES];
    pel_cosine towards[3][3], along = PEL_COSINE_ONE, near = 0;
    pel_frame_values(frame, vertex, value);
    pel_color_values(surface, value);
    if (pel_light_start(lights, value, towards, &sum)) {
        for (int32_t i = 0; i < lights->count; i++) {
            const struct pel_mesh_light *light = &lights->light[i];
            pel_light_towards(light, value + PEL_AT_POSITION, towards);
            pel_light_add(lights, light, towards, &sum);
            const pel_cosine nl = pel_weighted(towards[0], towards[2]);
            along = pel_min(along, pel_magnitude(nl));
            near = pel_max(near, pel_light_reflected(towards, nl));
        }
    }
    /* |R - V|^2 = 2 - 2 w; near = 0 is any w below. */
    struct pel_root chord;
    pel_square_root((uint64_t)(PEL_COSINE_ONE - near) << 3, &chord);
    const uint32_t units = chord.root >> (16 - unit_bits(lights->lighting));
    const int h = pel_max(pel_bits_of((uint64_t)along) - 23, 0);
    return pel_light_color(&sum, value) |
           (uint32_t)pel_min((int32_t)units, UNITS) << 24 |
           (uint32_t)pel_min(h, 7) << 29;
}

/* At least v / 6, v below 2^62, and 7/36 v, v below 2^56: without a division.
 */
static uint64_t sixth_of(uint64_t v)
{
    return (v >> 10) * 171 + 171;
}

static uint64_t curve_of(uint64_t v)
{
    return (v * 50 >> 8) + 1;
}

/* Of the triangle's vertices. */
struct corners {
    int32_t normal[3][3];
    int32_t position[3][3]; /* lighting units */
};

static void set_corners(const struct pel_frame *frame, struct corners *corners)
{
    const struct pel_mesh_lights *lights = &frame->lights;
    for (int i = 0; i < 3; i++) {
        const uint32_t vertex = frame->work->triangle.vertex[i];
        pel_mesh_normal(lights->mesh, vertex, corners->normal[i]);
        pel_mesh_lights_position(lights, lights->mesh->positions[vertex],
                                 corners->position[i]);
    }
}

/* Of three vectors: the squares of the shortest and the longest, and of the
 * longest edge between two. */
struct squares {
    uint64_t least, most, edge;
};

static struct squares squares_of(int32_t v[3][3])
{
    struct squares s = {UINT64_MAX, 0, 0};
    for (int i = 0; i < 3; i++) {
        const int j = i == 2 ? 0 : i + 1;
        int32_t way[3];
        for (int k = 0; k < 3; k++)
            way[k] = v[j][k] - v[i][k];
        const uint64_t square = (uint64_t)pel_dot(v[i], v[i]);
        const uint64_t edge = (uint64_t)pel_dot(way, way);
        s.least = square < s.least ? square : s.least;
        s.most = square > s.most ? square : s.most;
        s.edge = edge > s.edge ? edge : s.edge;
    }
    return s;
}

/* False where normals turn too far. */
static bool turn_of_normals(struct corners *corners,
                            struct pel_light_bounds *bounds)
{
    const struct squares s = squares_of(corners->normal);
    if (s.edge >= s.least)
        return false;
    bounds->normal = ratio(s.edge, s.least - 2 * sixth_of(s.edge));
    return true;
}

/* The turn of the direction to a place from the vertices. The square of the
 * distance is less than that of the nearest vertex by edge / 3 at most, and 1/4
 * edge around by half the difference of the vertices' more. False where the
 * direction turns by 1/2 or more. */
static bool turn_to(const int32_t place[3], const struct corners *corners,
                    uint32_t *turn)
{
    int32_t way[3][3];
    for (int i = 0; i < 9; i++)
        way[i / 3][i % 3] = place[i % 3] - corners->position[i / 3][i % 3];
    const struct squares s = squares_of(way);
    const uint64_t less = (s.most - s.least) / 2 + 2 * sixth_of(s.edge);
    if (s.least < UINT64_C(1) << 24 || less >= s.least ||
        s.edge >= (s.least - less) / 4)
        return false;
    *turn = (uint32_t)pel_max((int32_t)*turn,
                              (int32_t)ratio(s.edge, s.least - less));
    return true;
}

static bool turns_of(const struct pel_mesh_lights *lights,
                     struct corners *corners, struct pel_light_bounds *bounds)
{
    if (!turn_of_normals(corners, bounds) ||
        !turn_to(lights->eye, corners, &bounds->eye))
        return false;
    for (int32_t i = 0; i < lights->count; i++)
        if (!lights->light[i].directional &&
            !turn_to(lights->light[i].at, corners, &bounds->light))
            return false;
    return true;
}

/* With light on both sides: false where some normals may point at the eye and
 * some away from it, in the triangle or 1/4 around. */
static bool is_one_side(const struct pel_mesh_lights *lights,
                        const struct pel_light_bounds *bounds,
                        struct corners *corners)
{
    int32_t normal[3], eye[3];
    for (int k = 0; k < 3; k++)
        eye[k] = lights->eye[k] - corners->position[0][k];
    pel_normalize_fast(eye, eye);
    pel_normalize_fast(corners->normal[0], normal);
    const int32_t along = pel_weighted(normal, eye);
    return pel_magnitude(along) >> 14 >
           (int32_t)(bounds->normal + bounds->eye) * 21 / 16 + 1;
}

/* The largest factor of a channel, summed over lights: at most 2^29. */
static uint32_t strength(const struct pel_mesh_lights *lights, bool specular)
{
    uint32_t sum = 0;
    for (int32_t i = 0; i < lights->count; i++) {
        const pel_factor *f =
            specular ? lights->light[i].specular : lights->light[i].diffuse;
        sum += (uint32_t)pel_max(pel_max(f[0], f[1]), f[2]);
    }
    return sum;
}

/* The largest R.V inside, q being its turn. */
static pel_cosine nearest(const struct pel_frame *frame, const uint8_t note[3],
                          uint32_t q)
{
    const int bits = 16 - unit_bits(frame->lights.lighting);
    int32_t low = UNITS, high = 0;
    for (int i = 0; i < 3; i++) {
        low = pel_min(low, note[i] & UNITS);
        high = pel_max(high, note[i] & UNITS);
    }
    /* All of a triangle is within an edge of each vertex, and within an edge
     * times 1 / sqrt(3) < 19/32 of some vertex; spans reach 1/4 edge out,
     * where it turns by 5/16. */
    const int32_t chord =
        pel_max((int32_t)((uint32_t)high << bits) - (int32_t)(q + q * 5 / 16),
                (int32_t)((uint32_t)low << bits) - (int32_t)(q * 29 / 32 + 1));
    const uint64_t square =
        pel_multiply((uint32_t)pel_max(chord, 0), (uint32_t)pel_max(chord, 0));
    return pel_max(PEL_COSINE_ONE - (int32_t)(square >> 3), 0);
}

/* K(w), 2^-16: above, below 2^25. */
static uint32_t curvature(int32_t p, pel_cosine w)
{
    const int64_t square = pel_product(w, w) >> 30;
    const int64_t sixth = w / 6;
    if (p * square - w - sixth > (int64_t)(p - 2) * PEL_COSINE_ONE || p < 2)
        return (uint32_t)p * 88146;
    const uint64_t slope =
        (uint64_t)((p - 1) * (PEL_COSINE_ONE - square) + w + sixth) >> 14;
    const uint64_t power = ((uint32_t)pel_cosine_power(w, p - 2) >> 14) + 1;
    return (uint32_t)(((slope + 1) * power >> 16) + 1) * (uint32_t)p;
}

struct pel_color_ranges pel_color_ranges_of(const pel_color color[3])
{
    struct pel_color_ranges c = {color[0] & UINT32_C(0xFF000000), 0, 0, false};
    PEL_UNROLL
    for (int k = 0; k < 24; k += 8) {
        const int32_t v[3] = {(int32_t)(color[0] >> k & 255),
                              (int32_t)(color[1] >> k & 255),
                              (int32_t)(color[2] >> k & 255)};
        const int32_t low = pel_min(pel_min(v[0], v[1]), v[2]);
        const int32_t high = pel_max(pel_max(v[0], v[1]), v[2]);
        c.middle |= (uint32_t)(low + high + 1) / 2 << k;
        c.range = pel_max(c.range, high - low);
        c.most = pel_max(c.most, high);
        c.cut |= high == 255 && low < 255;
    }
    return c;
}

/* Adds highlights of strength s and returns what they change at most by. */
static uint64_t add_highlights(const struct pel_frame *frame,
                               const uint8_t note[3], uint64_t s, bool tears,
                               struct pel_light_bounds *b)
{
    const int32_t p = frame->lights.lighting->shininess;
    const uint64_t q = 2 * b->normal + b->light + b->eye;
    const pel_cosine w = nearest(frame, note, (uint32_t)q);
    b->curve += sixth_of((s * curvature(p, w) >> 16) * (q * q >> 16)) >> 16;
    b->curve += (s * (uint32_t)p >> 17) + 1; /* roots and powers */
    if (p == 1)
        b->kink += s * q >> 18;
    if (tears)
        b->tear =
            (s * (((uint32_t)pel_cosine_power(w, p) >> 14) + 1) >> 16) + 2;
    return s * q * root_above((uint32_t)p) >> 16;
}

/* Turns are at most 2^18 and factors 2^29, so a product of three is below 2^63
 * after a shift by 16 of the second. */
bool pel_light_bound(struct pel_frame *frame, const uint8_t note[3],
                     const pel_color color[3], struct pel_light_bounds *bounds)
{
    const struct pel_lighting *lighting = frame->lights.lighting;
    struct pel_light_bounds *b = bounds;
    struct corners corners;
    *b = (struct pel_light_bounds){.normal = 0};
    set_corners(frame, &corners);
    if (!turns_of(&frame->lights, &corners, b) ||
        (lighting->both_sides && !is_one_side(&frame->lights, b, &corners)))
        return false;
    const uint64_t d = strength(&frame->lights, false);
    const uint64_t s = strength(&frame->lights, true);
    const uint64_t nl = b->normal + b->light;
    const int h = pel_max(pel_max(note[0] >> 5, note[1] >> 5), note[2] >> 5);
    const bool crosses = h == 0 || nl * 21 / 16 > UINT32_C(1) << (8 + h);
    uint64_t change = d * nl >> 16;
    b->curve = curve_of(d * (nl * nl >> 16) >> 16);
    b->kink = crosses ? d * nl >> 18 : 0;
    if (s)
        change += add_highlights(frame, note, s,
                                 crosses && lighting->no_back_highlights, b);
    const struct pel_color_ranges own = pel_color_ranges_of(color);
    b->plane = b->curve + b->kink + b->tear;
    if (!lighting->plain_highlights)
        b->plane = b->plane * ((uint32_t)own.most + 1) >> 8;
    b->plane += ((change + 1) * (uint32_t)own.range * 86 >> 16) + 2;
    return true;
}
