/* Bands of one surface, drawn side by side. What is drawn is a function of
 * absolute x and y, so the bytes are those of one thread. */
#ifndef PEL_PORT_LINUX_BANDS_H
#define PEL_PORT_LINUX_BANDS_H

#include <pel/pel.h>
#include "pool.h"

PEL_BEGIN_DECLS

/* Draws a band: a surface of its own whose bounds and clip are the band, over
 * the same memory. Runs on any thread of the pool, several at a time, so what
 * it changes must be its own (scratch memory too). */
typedef void pel_bands_work(void *context, const struct pel_surface *band);

/* Splits the clip of `surface` into bands, about four for each thread, so that
 * one slow band does not hold up the rest, and draws them all. Bands begin at
 * multiples of 8 rows of the surface. */
void pel_bands_draw(struct pel_pool *pool, const struct pel_surface *surface,
                    pel_bands_work *work, void *context);
PEL_END_DECLS
#endif
