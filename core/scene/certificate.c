#include "certificate.h"

#include <string.h>

#include "work.h"

/* A triangle of the mesh as it is on screen; `at` is right unless it is cut. */
struct corners {
    struct pel_point at[3];
    int32_t z[3];  /* coarse */
    bool cut;      /* by the near plane or the range of sub-pixels */
    bool in_front; /* of the near plane, all of it */
};

static void set_corners(const struct pel_frame *frame, uint32_t triangle,
                        struct corners *c)
{
    uint32_t vertex[3];
    pel_mesh_corners(frame->scene->mesh, triangle, vertex);
    *c = (struct corners){.in_front = true};
    for (int i = 0; i < 3; i++) {
        const struct pel_projected *v = &frame->vertex[vertex[i]].at;
        c->at[i] = (struct pel_point){v->x, v->y};
        c->z[i] = v->z;
        c->cut |= v->x == PEL_NOT_ON_SCREEN;
        c->in_front &= v->z >= frame->projector.near_coarse;
    }
}

/* Pixels of a rectangle, inside the range of surfaces. */
static uint32_t area_of(const struct pel_rect *r)
{
    return (uint32_t)(r->x1 - r->x0) * (uint32_t)(r->y1 - r->y0);
}

/* Adds the pixels of a box, which is not empty. */
static void add_doubt(struct pel_doubt *d, const struct pel_rect *box)
{
    const struct pel_rect *const b = &d->bounds;
    const uint32_t pixels = area_of(box), room = UINT32_MAX - d->pixels;
    d->pixels += pixels < room ? pixels : room;
    d->bounds = pel_rect_empty(b) ? *box : pel_rect_join(b, box);
}

/* True when an edge of a has a on one side, and all of b on the other or on the
 * edge: by the rule of the raster they share no pixel then, not even one whose
 * centre is on the edge. */
static bool separates(const struct pel_point a[3], const struct pel_point b[3])
{
    const bool back = pel_corners_area(a) < 0;
    for (int i = 0; i < 3; i++) {
        bool all = true;
        for (int k = 0; k < 3 && all; k++) {
            const struct pel_point v[3] = {a[i], a[i == 2 ? 0 : i + 1], b[k]};
            const int64_t side = pel_corners_area(v);
            all = back ? side >= 0 : side <= 0;
        }
        if (all)
            return true;
    }
    return false;
}

/* Two triangles in a strip of rows: a paint that keeps the spans of the first,
 * and one that compares the second with them. */
enum { STRIP = 16 };

struct overlap {
    struct pel_paint paint;
    struct pel_plane plane[2];
    int64_t least; /* what the second one has to be nearer */
    int32_t y;
    struct pel_span row[STRIP];
    struct pel_doubt *doubt;
    bool found; /* some pixel without proof */
};

static void keep_fill(const struct pel_paint *paint,
                      const struct pel_spans *spans)
{
    struct overlap *o = (void *)(uintptr_t)paint;
    for (int32_t i = 0; i < spans->n; i++)
        o->row[spans->y + i - o->y] = spans->span[i];
}

/* Is the second one nearer at that pixel? */
static bool is_nearer(const struct overlap *o, int32_t x, int32_t y)
{
    const int64_t first = (int64_t)pel_plane_at(&o->plane[0], x, y);
    const int64_t second = (int64_t)pel_plane_at(&o->plane[1], x, y);
    return second >= first + o->least;
}

/* The part of a row, not empty, without a proof. Depths are linear, and so is
 * their difference: it begins or ends the row. */
static struct pel_rect unproven(const struct overlap *o, struct pel_rect row)
{
    const bool proven = is_nearer(o, row.x0, row.y0);
    int32_t low = row.x0, high = row.x1;
    if (is_nearer(o, high - 1, row.y0) == proven)
        return proven ? (struct pel_rect){0} : row;
    while (high - low > 1) {
        const int32_t middle = (low + high) / 2;
        if (is_nearer(o, middle, row.y0) == proven)
            low = middle;
        else
            high = middle;
    }
    *(proven ? &row.x0 : &row.x1) = high;
    return row;
}

static void compare_fill(const struct pel_paint *paint,
                         const struct pel_spans *spans)
{
    struct overlap *o = (void *)(uintptr_t)paint;
    for (int32_t i = 0; i < spans->n; i++) {
        const int32_t y = spans->y + i;
        const struct pel_span *a = &o->row[y - o->y], *b = &spans->span[i];
        struct pel_rect part = {pel_max(a->x0, b->x0), y, pel_min(a->x1, b->x1),
                                y + 1};
        if (part.x0 < part.x1)
            part = unproven(o, part);
        if (part.x0 >= part.x1)
            continue;
        add_doubt(o->doubt, &part);
        o->found = true;
    }
}

/* The plane of depths, as depth buffers have it. */
static void set_plane(const struct pel_frame *frame, const struct corners *c,
                      struct pel_plane *plane)
{
    struct pel_plane_setup setup;
    int32_t near[3];
    for (int i = 0; i < 3; i++)
        near[i] = pel_nearness(&frame->projector, c->z[i]);
    pel_plane_start(&setup, c->at);
    pel_plane_set(plane, &setup, near);
}

/* Compares the triangles in each row of the rectangle. */
static void walk(const struct corners c[2], struct overlap *o,
                 struct pel_rect rows)
{
    const int32_t end = rows.y1;
    for (; rows.y0 < end; rows.y0 = rows.y1) {
        rows.y1 = pel_min(rows.y0 + STRIP, end);
        const struct pel_surface strip = {.bounds = rows, .clip = rows};
        o->y = rows.y0;
        memset(o->row, 0, sizeof o->row);
        pel_paint_clear(&o->paint);
        o->paint.fill = keep_fill;
        pel_triangle(&strip, c[0].at, &o->paint);
        o->paint.fill = compare_fill;
        pel_triangle(&strip, c[1].at, &o->paint);
    }
}

/* Adds the doubt about two triangles of the mesh, drawn in this order, that may
 * share pixels of `common` alone; false: there is none. Neither is `thin` where
 * depths are right to 2^-6 (raster/plane.h).
 *
 * Planes are off by less than that, so with twice as much the second one is
 * nearer in truth, and where numbers are equal the buffer shows the first of
 * the mesh; a number is 1/4. A thin one is never proven to be nearer or
 * farther. */
static bool doubt_pair(const struct pel_frame *frame,
                       const uint32_t triangle[2], bool thin,
                       const struct pel_rect *common, struct pel_doubt *doubt)
{
    struct overlap o = {.doubt = doubt, .least = 1 << 22};
    struct corners c[2];
    for (int i = 0; i < 2; i++)
        set_corners(frame, triangle[i], &c[i]);
    if (c[0].cut || c[1].cut) {
        add_doubt(doubt, common);
        return true;
    }
    if (separates(c[0].at, c[1].at) || separates(c[1].at, c[0].at))
        return false;
    if (thin)
        o.least = INT64_C(1) << 62;
    else if (triangle[1] < triangle[0])
        o.least = 1 << 19;
    for (int i = 0; i < 2; i++)
        set_plane(frame, &c[i], &o.plane[i]);
    walk(c, &o, *common);
    return o.found;
}

/* `entry` orders the items by the first rows of their boxes. */
struct search {
    const struct pel_frame *frame;
    struct pel_certificate_item *item;
    struct pel_depth_entry *entry;
    uint32_t n, work; /* items, steps left */
    struct pel_doubt *doubt;
};

static uint32_t index_of(const struct search *s,
                         const struct pel_certificate_item *m)
{
    return s->frame->order[m->rank].index;
}

/* A triangle thinner than a sub-pixel has depths that are not right to a number
 * (raster/plane.h). Its height is the area by its longest side, which is not
 * longer than width plus height of its box. */
static bool is_thin(const struct corners *c)
{
    const struct pel_rect box = pel_corners_box(c->at);
    const uint64_t area = (uint64_t)pel_size_of(pel_corners_area(c->at));
    return area < (uint32_t)(box.x1 - box.x0 + box.y1 - box.y0);
}

/* The least and the largest depth of a triangle. Those of thin ones, which are
 * cut out of others too, are off by less than 2^-17 of 2^30. */
static void set_depths(struct pel_certificate_item *m,
                       const struct pel_projector *p, const struct corners *c)
{
    const int32_t *const z = c->z;
    const int32_t nearest = pel_min(pel_min(z[0], z[1]), z[2]);
    const int32_t farthest = pel_max(pel_max(z[0], z[1]), z[2]);
    const int32_t slack = m->thin || c->cut ? 1 << 14 : 0;
    const int32_t low = pel_nearness(p, farthest) - slack;
    m->low = (uint32_t)pel_max(low, 0);
    m->high = UINT32_MAX;
    if (c->in_front)
        m->high = (uint32_t)(pel_nearness(p, nearest) + slack);
}

/* Adds a triangle of the order, if it may cover a pixel. */
static void measure(struct search *s, uint32_t rank)
{
    struct pel_certificate_item *m = &s->item[s->n];
    struct corners c;
    *m = (struct pel_certificate_item){.rank = rank};
    set_corners(s->frame, index_of(s, m), &c);
    const struct pel_rect around = pel_corners_box(c.at);
    const struct pel_rect *const view = &s->frame->scene->viewport;
    const struct pel_rect box = c.cut ? *view : pel_rect_pixels(&around, view);
    if (pel_rect_empty(&box))
        return;
    m->x0 = (int16_t)box.x0;
    m->y0 = (int16_t)box.y0;
    m->x1 = (int16_t)box.x1;
    m->y1 = (int16_t)box.y1;
    m->thin = !c.cut && is_thin(&c);
    set_depths(m, &s->frame->projector, &c);
    /* The sort puts the largest first: the topmost row. */
    s->entry[s->n] = (struct pel_depth_entry){-box.y0, s->n};
    s->n++;
}

static bool spend(struct search *s, uint32_t work)
{
    const bool enough = s->work >= work;
    s->work -= enough ? work : s->work;
    return enough;
}

/* Without branches that CPUs would have to guess. */
static bool overlap(const struct pel_certificate_item *a,
                    const struct pel_certificate_item *b)
{
    return ((a->x0 - b->x1) & (b->x0 - a->x1) & (a->y0 - b->y1) &
            (b->y0 - a->y1)) < 0;
}

/* Compares two items that overlap. False: no work is left for it. */
static bool compare(struct search *s, struct pel_certificate_item *a,
                    struct pel_certificate_item *b)
{
    const struct pel_rect common = {
        pel_max(a->x0, b->x0), pel_max(a->y0, b->y0), pel_min(a->x1, b->x1),
        pel_min(a->y1, b->y1)};
    const uint32_t triangle[2] = {index_of(s, a), index_of(s, b)};
    if (b->low > a->high)
        return true;
    if (!spend(s, 40 + (uint32_t)(common.y1 - common.y0)))
        return false;
    if (doubt_pair(s->frame, triangle, a->thin || b->thin, &common, s->doubt))
        a->in_doubt = b->in_doubt = true;
    return true;
}

/* Compares an item with those that begin later, in a row of its own. False when
 * there is no work left for all of them. */
static bool search_item(struct search *s, uint32_t i)
{
    struct pel_certificate_item *own = &s->item[s->entry[i].index];
    while (++i < s->n && -s->entry[i].depth < own->y1) {
        struct pel_certificate_item *m = &s->item[s->entry[i].index];
        const bool after = m->rank > own->rank;
        if (!spend(s, 1) ||
            (overlap(own, m) && !compare(s, after ? own : m, after ? m : own)))
            return false;
    }
    return true;
}

static void search_all(struct search *s)
{
    uint32_t i = 0;
    while (i < s->n && search_item(s, i))
        i++;
    for (; i < s->n; i++) {
        struct pel_certificate_item *m = &s->item[s->entry[i].index];
        const struct pel_rect box = {m->x0, m->y0, m->x1, m->y1};
        add_doubt(s->doubt, &box);
        m->in_doubt = true;
    }
    for (i = 0; i < s->n; i++)
        s->doubt->triangles += s->item[i].in_doubt;
    const uint32_t area = area_of(&s->doubt->bounds);
    if (s->doubt->pixels > area)
        s->doubt->pixels = area;
}

enum pel_status pel_scene_certify(const struct pel_frame *frame, void *scratch,
                                  size_t scratch_size, uint32_t work,
                                  struct pel_doubt *doubt)
{
    if (!frame || !scratch || !doubt)
        return PEL_ERROR_NULL;
    const uint32_t n = frame->triangles;
    if (scratch_size < PEL_CERTIFICATE_SCRATCH_SIZE(n) ||
        (uintptr_t)scratch % 4)
        return PEL_ERROR_SCRATCH;
    *doubt = (struct pel_doubt){0};
    struct search s = {
        .frame = frame, .item = scratch, .work = work, .doubt = doubt};
    s.entry = (void *)(s.item + n);
    for (uint32_t rank = 0; rank < n; rank++)
        measure(&s, rank);
    pel_depth_sort.sort(s.entry, s.n, NULL);
    search_all(&s);
    return PEL_OK;
}
