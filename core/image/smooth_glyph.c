#include "smooth_glyph.h"

/* Pixels of a glyph. */
enum { MOST = 255 * 255 };

/* Pixels of one coverage in a row that are worth a span of their own: full
 * ones, others behind these, and clear ones. */
enum { FULL = 3, GAP = 8 };

/* Numbers below 256, which are short where they lie on the stack. */
#if PEL_SMOOTH_TINY
typedef uint8_t step_type;
#else
typedef uint32_t step_type;
#endif

/* Steps of coverage, as they lie in a glyph: the run at hand, and where the
 * next one lies. */
struct runs {
    const uint8_t *at;
    step_type shift;      /* bits of the byte that are left */
    step_type bits, most; /* of a step, and the largest */
    step_type step;
    bool is_raw;   /* each is a run of its own */
    uint32_t left; /* px */
};

/* A step, or a part of a length; what of a byte is left are whole ones. */
static PEL_ALWAYS_INLINE uint32_t next_step(struct runs *r)
{
    uint32_t step = *r->at;
    r->shift -= r->bits;
    step = step >> r->shift & r->most;
    if (r->shift == 0) {
        r->shift = 8;
        r->at++;
    }
    return step;
}

/* Takes the length that follows a step. False when it would go on at `end`. */
static PEL_ALWAYS_INLINE bool take_length(struct runs *r, const uint8_t *end)
{
    uint32_t n;
    r->left = 0;
    do {
        if (r->at == end)
            return false;
        r->left += n = next_step(r);
    } while (n == r->most);
    return true;
}

/* False when it would go on at `end`. */
static inline bool next_run(struct runs *r, const uint8_t *end)
{
    if (r->at == end)
        return false;
    r->step = (step_type)next_step(r);
    r->left = 1;
    return r->is_raw || r->step - 1u < r->most - 1u || take_length(r, end);
}

static PEL_ALWAYS_INLINE void begin_runs(struct runs *r,
                                         const struct pel_font_asset *font,
                                         const struct pel_font_glyph *glyph)
{
    const uint32_t bits = font->kind->bits;
    r->at = font->bits + (glyph->offset & ~PEL_FONT_RAW);
    r->shift = 8;
    r->bits = (step_type)bits;
    r->most = (step_type)((1u << bits) - 1);
    r->is_raw = (glyph->offset & PEL_FONT_RAW) != 0;
    r->left = 0;
}

static bool fits(const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph)
{
    const uint8_t *const end = font->bits + font->size;
    struct runs r;
    uint32_t pixels = (uint32_t)glyph->width * glyph->height;
    bool good = (glyph->offset & ~PEL_FONT_RAW) <= font->size;
    begin_runs(&r, font, glyph);
    while (good && pixels > 0) {
        good = next_run(&r, end) && r.left <= MOST;
        pixels -= r.left < pixels ? r.left : pixels;
    }
    return good;
}

#if PEL_SMOOTH_TINY
/* Pixels of a glyph's row on their way to the layer, before column x. */
struct drawing {
    struct pel_smooth smooth;
    struct pel_smooth_row row;
    struct runs runs;
    int32_t x, right;
    uint8_t coverage[PEL_SMOOTH_BATCH_BYTES];
};

/* n pixels of a run, which go to the end of the row that is painted next where
 * they are many: those are no bytes. True: more are not to follow them. */
static bool take(struct drawing *d, int32_t n, uint32_t scale)
{
    const struct pel_rect *const clip = &d->smooth.target->clip;
    const uint32_t step = d->runs.step;
    const int32_t end = pel_min(d->x + n, clip->x1);
    int32_t x = pel_max(d->x, clip->x0);
    d->runs.left -= (uint32_t)n;
    d->x += n;
    d->row.x = pel_min(x, end) - d->row.left;
    if (n >= FULL && step - 1 >= d->runs.most - 1u) {
        d->row.full = step ? pel_max(end - x, 0) : 0;
        return true;
    }
    for (; x < end; x++)
        d->coverage[d->row.left++] = (uint8_t)(step * scale);
    return d->row.left > PEL_SMOOTH_BATCH_BYTES - FULL;
}

/* Pixels from column x on: as many as make a row of the layer. */
static PEL_NOINLINE_32 void take_row(struct drawing *d, uint32_t scale)
{
    int32_t n;
    d->row.left = d->row.full = 0;
    do {
        if (d->runs.left == 0)
            next_run(&d->runs, NULL);
        n = pel_min((int32_t)d->runs.left, d->right - d->x);
    } while (!take(d, n, scale) && d->x < d->right);
}

static void draw(const struct pel_surface *surface,
                 const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph, struct pel_point at,
                 const struct pel_paint *paint)
{
    const int32_t end = pel_min(at.y + glyph->height, surface->clip.y1);
    struct drawing d;
    if (!pel_smooth_begin(&d.smooth, surface, paint))
        return;
    begin_runs(&d.runs, font, glyph);
    d.row.right = 0;
    d.row.coverage = d.coverage;
    d.right = at.x + glyph->width;
    for (d.row.y = at.y; d.row.y < end; d.row.y++)
        for (d.x = at.x; d.x < d.right;) {
            take_row(&d, font->kind->scale);
            if (d.row.y >= surface->clip.y0)
                pel_smooth_paint(&d.smooth, &d.row);
        }
}
#else
/* Rows of a glyph on their way to the layer. */
struct drawing {
    struct pel_smooth smooth;
    const struct pel_rect *clip;
    uint32_t scale; /* of a step, to 255 */
    int32_t y;
    int32_t bytes; /* of coverage */
    bool is_cut;   /* by the clip's sides */
    struct pel_smooth_batch batch;
};

/* The next row is y. */
static void flush(struct drawing *d)
{
    if (d->is_cut)
        pel_smooth_clip_batch(&d->batch, d->clip);
    if (d->batch.y >= d->clip->y0)
        pel_smooth_paint_batch(&d->smooth, &d->batch);
    d->batch.y = d->y;
    d->batch.n = 0;
    d->bytes = 0;
}

/* Its bytes lie in place: up to `right` before the full pixels, which without
 * any begin where the part does, and up to `end` behind them. */
static PEL_ALWAYS_INLINE void add_part(struct drawing *d, struct pel_span full,
                                       const uint8_t *right, const uint8_t *end)
{
    struct pel_smooth_batch *const b = &d->batch;
    const int32_t left = (int32_t)(right - b->coverage) - d->bytes;
    if (full.x1 <= full.x0)
        full.x0 = full.x1 = full.x0 + left;
    b->at.full[b->n] = full;
    b->count[2 * b->n] = (uint8_t)left;
    b->count[2 * b->n + 1] = (uint8_t)(end - right);
    b->n++;
    d->bytes = (int32_t)(end - b->coverage);
}

/* Part of a row, from column x on to `end` at most: where it ends. In it are
 * pixels with a coverage each, then full ones, then others. */
static PEL_ALWAYS_INLINE int32_t take_part(struct drawing *d, struct runs *r,
                                           int32_t x, int32_t end)
{
    uint8_t *const start = d->batch.coverage + d->bytes;
    uint8_t *p = start, *right = NULL;
    struct pel_span full = {x, x};
    end = pel_min(end, x + PEL_SMOOTH_BATCH_BYTES - d->bytes);
    while (x < end) {
        if (r->left == 0) {
            r->step = (step_type)next_step(r);
            if (r->step - 1 < r->most - 1) {
                *p++ = (uint8_t)(r->step * d->scale);
                x++;
                continue;
            }
            r->left = 1;
            if (!r->is_raw)
                take_length(r, NULL);
        }
        int32_t n = pel_min((int32_t)r->left, end - x);
        const bool is_first = p == start && !right;
        if (r->step == 0 && n >= GAP && !is_first && x + n < end)
            break;
        r->left -= (uint32_t)n;
        x += n;
        if (r->step && n >= FULL && !right) {
            full = (struct pel_span){x - n, x};
            right = p;
        } else if (r->step == 0 && is_first)
            full.x0 = x;
        else if (r->step || x < end)
            for (; n > 0; n--)
                *p++ = (uint8_t)(r->step * d->scale);
    }
    add_part(d, full, right ? right : p, p);
    return x;
}

/* Rows above the clip are passed. */
static void draw(const struct pel_surface *surface,
                 const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph, struct pel_point at,
                 const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    const int32_t right = at.x + glyph->width;
    const int32_t end = pel_min(at.y + glyph->height, clip->y1);
    const int32_t most = pel_min(glyph->width, PEL_SMOOTH_BATCH_BYTES);
    struct runs r;
    struct drawing d;
    begin_runs(&r, font, glyph);
    if (!pel_smooth_begin(&d.smooth, surface, paint))
        return;
    d.clip = clip;
    d.is_cut = at.x < clip->x0 || right > clip->x1;
    d.scale = font->kind->scale;
    d.y = d.batch.y = at.y;
    d.bytes = d.batch.n = 0;
    for (int32_t x = at.x; d.y < end;) {
        if (x > at.x || d.batch.n == PEL_SMOOTH_BATCH_ROWS ||
            most > PEL_SMOOTH_BATCH_BYTES - d.bytes || d.y <= clip->y0)
            flush(&d);
        x = take_part(&d, &r, x, right);
        if (x == right) {
            x = at.x;
            d.y++;
        }
    }
    flush(&d);
}
#endif

static int32_t kerning(const struct pel_font_asset *font,
                       const struct pel_font_glyph *left,
                       const struct pel_font_glyph *right)
{
    if ((uintptr_t)left - (uintptr_t)font->glyph >= font->glyphs * sizeof *left)
        return 0;
    const struct pel_font_pair *const pair = pel_font_pair_find(
        font->pair, font->pairs, sizeof *font->pair,
        (uint32_t)(left - font->glyph), (uint32_t)(right - font->glyph));
    return pair ? pair->x : 0;
}

const struct pel_font_kind pel_font_smooth_2 = {fits, draw, kerning, 2, 85};
const struct pel_font_kind pel_font_smooth = {fits, draw, kerning, 4, 17};
const struct pel_font_kind pel_font_smooth_8 = {fits, draw, kerning, 8, 1};
