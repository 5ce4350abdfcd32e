#include "certificate_pair.h"

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

static int32_t lowest(const int32_t v[3])
{
    return pel_min(pel_min(v[0], v[1]), v[2]);
}

static int32_t highest(const int32_t v[3])
{
    return pel_max(pel_max(v[0], v[1]), v[2]);
}

/* A triangle thinner than a sub-pixel has depths that are not right to a number
 * (raster/plane.h). Its height is the area by its longest side, which is not
 * longer than width plus height of its box. */
static bool is_thin(const struct pel_certificate_corners *c)
{
    const struct pel_rect box = pel_corners_box(c->at);
    const uint64_t area = (uint64_t)pel_size_of(pel_triangle_area(c->at));
    return area < (uint32_t)(box.x1 - box.x0 + box.y1 - box.y0);
}

/* The pixels that a triangle may cover. */
static struct pel_rect pixels_of(const struct search *s,
                                 const struct pel_certificate_corners *c)
{
    const struct pel_rect *view = &s->frame->scene->viewport;
    const struct pel_rect box = pel_corners_box(c->at);
    return c->cut ? *view : pel_rect_pixels(&box, view);
}

/* The least and the largest depth of a triangle. Those of thin ones, which are
 * cut out of others too, are off by less than 2^-17 of 2^30. */
static void set_depths(struct pel_certificate_item *m,
                       const struct pel_projector *p,
                       const struct pel_certificate_corners *c)
{
    const int32_t slack = m->thin || c->cut ? 1 << 14 : 0;
    const int32_t low = pel_nearness(p, highest(c->z)) - slack;
    m->low = (uint32_t)pel_max(low, 0);
    m->high = UINT32_MAX;
    if (c->in_front)
        m->high = (uint32_t)(pel_nearness(p, lowest(c->z)) + slack);
}

/* Adds a triangle of the order, if it may cover a pixel. */
static void measure(struct search *s, uint32_t rank)
{
    struct pel_certificate_item *m = &s->item[s->n];
    struct pel_certificate_corners c;
    *m = (struct pel_certificate_item){.rank = rank};
    pel_certificate_corners(s->frame, index_of(s, m), &c);
    const struct pel_rect box = pixels_of(s, &c);
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
    const struct pel_doubt doubt =
        pel_certificate_pair(s->frame, triangle, a->thin || b->thin, &common);
    if (doubt.pixels) {
        pel_doubt_add(s->doubt, &doubt.bounds, doubt.pixels);
        a->in_doubt = b->in_doubt = true;
    }
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
        pel_doubt_add(s->doubt, &box, pel_doubt_area(&box));
        m->in_doubt = true;
    }
    for (i = 0; i < s->n; i++)
        s->doubt->triangles += s->item[i].in_doubt;
    const uint32_t area = pel_doubt_area(&s->doubt->bounds);
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

void pel_scene_draw_certified(struct pel_frame *frame,
                              const struct pel_surface *surface,
                              const struct pel_rect *doubt,
                              const struct pel_depth *depth)
{
    struct pel_depth_entry *const order = frame->order;
    const uint32_t triangles = frame->triangles;
    struct pel_surface part = *surface;
    pel_scene_draw(frame, surface);
    part.clip = pel_rect_intersect(&part.clip, doubt);
    if (triangles == 0 || pel_rect_empty(&part.clip))
        return;
    frame->order = NULL;
    frame->triangles = frame->scene->mesh->triangles;
    pel_scene_draw_depth(frame, &part, depth);
    frame->order = order;
    frame->triangles = triangles;
}
