/* The cases. */
#ifndef BENCH_ATLAS_CASES_H
#define BENCH_ATLAS_CASES_H

#include "atlas.h"

void atlas_damage(struct atlas *a); /* case_damage.c */
void atlas_damage_time(struct atlas *a);

void atlas_thinness(struct atlas *a); /* case_regimes.c */
void atlas_snapping(struct atlas *a);
void atlas_overflow(struct atlas *a);
void atlas_map_sliver(struct atlas *a);

void atlas_color(struct atlas *a); /* case_color.c */
void atlas_color_sliver(struct atlas *a);
void atlas_gradient(struct atlas *a);

void atlas_span(struct atlas *a); /* case_texture.c */
void atlas_map_perspective(struct atlas *a);

void atlas_phong(struct atlas *a); /* case_light.c */
void atlas_map_phong(struct atlas *a);

void atlas_order(struct atlas *a); /* case_depth.c */
void atlas_fighting(struct atlas *a);

void atlas_alpha(struct atlas *a); /* case_scalar.c */
void atlas_hsv(struct atlas *a);
void atlas_dither(struct atlas *a);
void atlas_arctangent(struct atlas *a);
void atlas_gamma(struct atlas *a);

void atlas_circle(struct atlas *a); /* case_circle.c */
void atlas_map_circle(struct atlas *a);

void atlas_references(struct atlas *a); /* case_references.c */
void atlas_limits(struct atlas *a);     /* case_limits.c */
void atlas_sampling(struct atlas *a);   /* case_sampling.c */

void atlas_tolerance(struct atlas *a); /* case_tolerance.c */
void atlas_tolerance_time(struct atlas *a);

#endif
