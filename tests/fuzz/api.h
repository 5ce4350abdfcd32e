/* The parts of fuzz_api.c: each takes bytes and makes a call of core with any
 * numbers that its contract allows or refuses. */
#ifndef TESTS_FUZZ_API_H
#define TESTS_FUZZ_API_H

#include "core/outline/outline_filter.h"
#include "core/pel.h"
#include "input.h"
#include "tests/support/any_paint.h"

enum { API_SURFACES = 3, API_PAINTS = 6, API_TRIANGLES = 16 };

struct api {
    struct input in;
    /* The last one is only read: paints may keep it. */
    struct pel_surface surface[API_SURFACES + 1];
    union any_paint paint[API_PAINTS];
    struct pel_fan_triangle triangle[API_PAINTS][API_TRIANGLES];
    pel_color ramp[64];
};

/* A surface of any format, in memory that ends at a guard page. */
void api_surface(struct api *a, int slot);

void api_paint(struct api *a);
void api_shape(struct api *a, const struct pel_surface *surface,
               const struct pel_paint *paint);
void api_path(struct api *a, const struct pel_surface *surface,
              const struct pel_paint *paint);
void api_hit(struct api *a);
void api_image(struct api *a, const struct pel_surface *surface,
               const struct pel_paint *paint);
void api_scene(struct api *a, const struct pel_surface *surface);

static inline struct pel_point api_point(struct api *a)
{
    const int32_t x = input_number(&a->in);
    return (struct pel_point){x, input_number(&a->in)};
}

static inline struct pel_rect api_rect(struct api *a)
{
    struct pel_rect r;
    r.x0 = input_number(&a->in);
    r.y0 = input_number(&a->in);
    r.x1 = input_number(&a->in);
    r.y1 = input_number(&a->in);
    return r;
}

#endif
