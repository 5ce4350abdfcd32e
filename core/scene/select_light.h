/* How far light over a triangle is from a plane: the bound behind
 * pel_shade_chosen (select.h).
 *
 * A value f that is linear at the corners and takes f(x) inside differs from
 * its plane by at most M E^2 / 6: E is the longest edge and M E^2 bounds the
 * second derivative of f along any segment no longer than that. (By Taylor
 * around x the difference is at most M / 2 times the sum of w_i |a_i - x|^2,
 * which is the sum over pairs of w_i w_j |a_i - a_j|^2 and so at most E^2 / 3.)
 *
 * A direction N = n / |n|, n linear, moves by at most r over an edge, r =
 * |difference of n| / smallest |n|, and its second derivative is at most
 * 2 / sqrt(3) r^2 < 7/6 r^2 (r^2 c sqrt(4 s^2 + c^2), s and c sine and cosine
 * of the way from the nearest point of the segment). |n|^2 inside is at least
 * that at the corners less E^2 / 3. With n, v, l the r of the normal, of the
 * direction to the eye and of that to a light:
 *
 *     N.L     second derivative at most 7/6 (n + l)^2
 *     w = R.V first derivative at most q sqrt(1 - w^2), q = 2 n + v + l,
 *             second at most 7/6 q^2, as |R''| <= (2 n)^2 where L stands still
 *     w^p     second at most q^2 K(w), K(w) =
 *             p w^(p-2) ((p - 1) (1 - w^2) + 7/6 w) <= 1.345 p
 *
 * K grows with w while p w^2 - 7/6 w <= p - 2, so the smallest angle between R
 * and V bounds it: |R - V| changes by at most q. max(N.L, 0) adds the error of
 * a kink between a > 0 and -b < 0: a b / (a + b) <= (n + l) / 4. */
#ifndef PEL_SCENE_SELECT_LIGHT_H
#define PEL_SCENE_SELECT_LIGHT_H

#include "shading.h"

PEL_BEGIN_DECLS

/* The color of a lit vertex, and in place of its alpha what the bound needs to
 * know: bits 0..4 the smallest |R - V| of a light in units, rounded down, 31
 * where it is more; bits 5..7 the largest h up to 7 with |N.L| >= 2^(h-8) for
 * all lights, or 0. */
pel_color pel_light_note(const struct pel_frame *frame, uint32_t vertex,
                         pel_color surface);

/* The channels of three vertices: the middles of their ranges, the widest one,
 * the largest value, and whether 255 is at some vertices, but not at all. */
struct pel_color_ranges {
    pel_color middle;
    int32_t range, most;
    bool cut;
};

struct pel_color_ranges pel_color_ranges_of(const pel_color color[3]);

/* What is known of the light over a triangle. */
struct pel_light_bounds {
    /* 2^-16: how far the normals, and the directions to the eye and to a light,
     * turn over its longest edge. */
    uint32_t normal, eye, light;

    /* 1/256 steps: the difference of light from the plane through the vertices,
     * on surfaces of the vertices' colors; its parts on white, by curvature, by
     * signs of N.L and by highlights that end at N.L = 0. */
    uint64_t plane, curve, kink, tear;
};

/* Sets the bounds of frame->work->triangle, on surfaces of no more than
 * color[i] at vertex i. False where none is known. */
bool pel_light_bound(struct pel_frame *frame, const uint8_t note[3],
                     const pel_color color[3], struct pel_light_bounds *bounds);

PEL_END_DECLS
#endif
