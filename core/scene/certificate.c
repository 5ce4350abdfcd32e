#include "certificate_pair.h"

#include <string.h>

/* Triangles are in lists, one per cell of a grid, by the upper left corner of
 * their boxes. There is a grid for each size of a box, and a table of lists for
 * all: those whose hashes are equal share one. */
struct search {
    const struct pel_frame *frame;
    struct pel_certificate_item *item; /* in the order of the frame */
    uint32_t *head;                    /* of lists: an item plus 1, or 0 */
    int bits;                          /* 2^bits lists */
    uint32_t levels;                   /* a bit for each level in use */
    uint32_t n, work;
    struct pel_doubt *doubt;
};

static uint32_t index_of(const struct search *s, uint32_t rank)
{
    return s->frame->order[rank].index;
}

static int32_t lowest(const int32_t v[3])
{
    return pel_min(pel_min(v[0], v[1]), v[2]);
}

static int32_t highest(const int32_t v[3])
{
    return pel_max(pel_max(v[0], v[1]), v[2]);
}

/* The box in sub-pixels of a triangle that is not cut. */
static struct pel_rect box_of(const struct pel_certificate_corners *c)
{
    const int32_t x[3] = {c->at[0].x, c->at[1].x, c->at[2].x};
    const int32_t y[3] = {c->at[0].y, c->at[1].y, c->at[2].y};
    return (struct pel_rect){lowest(x), lowest(y), highest(x), highest(y)};
}

/* A triangle thinner than a sub-pixel has depths that are not right to a number
 * (raster/plane.h). Its height is the area by its longest side, which is not
 * longer than width plus height of its box. */
static bool is_thin(const struct pel_certificate_corners *c)
{
    const struct pel_rect box = box_of(c);
    const uint64_t area = (uint64_t)pel_size_of(pel_triangle_area(c->at));
    return area < (uint32_t)(box.x1 - box.x0 + box.y1 - box.y0);
}

/* The pixels that a triangle may cover. */
static struct pel_rect pixels_of(const struct search *s,
                                 const struct pel_certificate_corners *c)
{
    const struct pel_rect *view = &s->frame->scene->viewport;
    const struct pel_rect at = box_of(c);
    const struct pel_rect box = {pel_first_pixel(at.x0), pel_first_pixel(at.y0),
                                 pel_first_pixel(at.x1),
                                 pel_first_pixel(at.y1)};
    return c->cut ? *view : pel_rect_intersect(&box, view);
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

/* Sets an item; false when no pixel is its. */
static bool measure(struct search *s, uint32_t rank)
{
    struct pel_certificate_item *m = &s->item[rank];
    struct pel_certificate_corners c;
    pel_certificate_corners(s->frame, index_of(s, rank), &c);
    const struct pel_rect box = pixels_of(s, &c);
    *m = (struct pel_certificate_item){.next = 0};
    if (pel_rect_empty(&box))
        return false;
    m->x0 = (int16_t)box.x0;
    m->y0 = (int16_t)box.y0;
    m->x1 = (int16_t)box.x1;
    m->y1 = (int16_t)box.y1;
    m->thin = !c.cut && is_thin(&c);
    set_depths(m, &s->frame->projector, &c);
    const int32_t side = pel_max(box.x1 - box.x0, box.y1 - box.y0);
    m->level = (uint8_t)pel_bits_of((uint32_t)side - 1);
    return true;
}

/* The cell of a coordinate, in the grid of that level. */
static uint32_t cell_of(int32_t v, int level)
{
    return (uint32_t)(v + 65536) >> level;
}

static uint32_t *list_of(const struct search *s, uint32_t x, uint32_t y,
                         int level)
{
    const uint32_t hash = x * UINT32_C(0x9E3779B1) + y * UINT32_C(0x85EBCA6B) +
                          (uint32_t)level * UINT32_C(0xC2B2AE35);
    return &s->head[hash >> 1 >> (31 - s->bits)];
}

static void file(struct search *s, uint32_t rank)
{
    struct pel_certificate_item *m = &s->item[rank];
    uint32_t *head = list_of(s, cell_of(m->x0, m->level),
                             cell_of(m->y0, m->level), m->level);
    m->next = *head;
    *head = rank + 1;
    s->levels |= UINT32_C(1) << m->level;
}

static struct pel_rect item_box(const struct pel_certificate_item *m)
{
    return (struct pel_rect){m->x0, m->y0, m->x1, m->y1};
}

static bool spend(struct search *s, uint32_t work)
{
    const bool enough = s->work >= work;
    s->work -= enough ? work : s->work;
    return enough;
}

/* Compares two items of the order. False: no work is left for it. */
static bool compare(struct search *s, uint32_t first, uint32_t second)
{
    struct pel_certificate_item *a = &s->item[first], *b = &s->item[second];
    const struct pel_rect box[2] = {item_box(a), item_box(b)};
    const struct pel_rect common = pel_rect_intersect(&box[0], &box[1]);
    if (pel_rect_empty(&common) || b->low > a->high)
        return true;
    if (!spend(s, 40 + (uint32_t)(common.y1 - common.y0)))
        return false;
    const uint32_t triangle[2] = {index_of(s, first), index_of(s, second)};
    const struct pel_doubt doubt =
        pel_certificate_pair(s->frame, triangle, a->thin || b->thin, &common);
    if (doubt.pixels) {
        pel_doubt_add(s->doubt, &doubt.bounds, doubt.pixels);
        a->in_doubt = b->in_doubt = true;
    }
    return true;
}

/* Compares an item with those in a cell of its own level or a larger one; of
 * its own with those that are later in the order. */
static bool search_cell(struct search *s, uint32_t rank, uint32_t x, uint32_t y,
                        int level)
{
    const int own = s->item[rank].level;
    for (uint32_t next = *list_of(s, x, y, level); next;
         next = s->item[next - 1].next) {
        const uint32_t other = next - 1;
        const struct pel_certificate_item *m = &s->item[other];
        if (!spend(s, 1))
            return false;
        if (m->level != level || cell_of(m->x0, level) != x ||
            cell_of(m->y0, level) != y || (level == own && other <= rank))
            continue;
        if (!compare(s, other < rank ? other : rank,
                     other < rank ? rank : other))
            return false;
    }
    return true;
}

/* Boxes of a level are not wider than its cells: those that can overlap begin
 * in a cell that the item is in, or in one before. */
static bool search_level(struct search *s, uint32_t rank, int level)
{
    const struct pel_certificate_item *m = &s->item[rank];
    const int32_t before = (INT32_C(1) << level) - 1;
    const uint32_t left = cell_of(m->x0 - before, level);
    const uint32_t right = cell_of(m->x1 - 1, level);
    const uint32_t bottom = cell_of(m->y1 - 1, level);
    uint32_t y = cell_of(m->y0 - before, level);
    for (; y <= bottom; y++)
        for (uint32_t x = left; x <= right; x++)
            if (!search_cell(s, rank, x, y, level))
                return false;
    return true;
}

/* False when there is no work left for all of an item. One without a pixel has
 * an empty box at (0, 0). */
static bool search_item(struct search *s, uint32_t rank)
{
    int level = s->item[rank].level;
    if (s->item[rank].x0 == s->item[rank].x1)
        return true;
    for (; s->levels >> level; level++)
        if (s->levels >> level & 1 && !search_level(s, rank, level))
            return false;
    return true;
}

static void search_all(struct search *s)
{
    uint32_t rank = 0;
    for (; rank < s->n; rank++)
        if (measure(s, rank))
            file(s, rank);
    for (rank = 0; rank < s->n && search_item(s, rank); rank++)
        ;
    for (; rank < s->n; rank++) {
        const struct pel_rect box = item_box(&s->item[rank]);
        s->item[rank].in_doubt = !pel_rect_empty(&box);
        if (s->item[rank].in_doubt)
            pel_doubt_add(s->doubt, &box, pel_doubt_area(&box));
    }
    for (rank = 0; rank < s->n; rank++)
        s->doubt->triangles += s->item[rank].in_doubt;
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
    if (n == 0)
        return PEL_OK;
    struct search s = {.frame = frame,
                       .item = scratch,
                       .n = n,
                       .bits = pel_bits_of(n) - 1,
                       .work = work,
                       .doubt = doubt};
    s.head = (void *)(s.item + n);
    memset(s.head, 0, n * sizeof *s.head);
    search_all(&s);
    return PEL_OK;
}

void pel_scene_draw_certified(struct pel_frame *frame,
                              const struct pel_surface *surface,
                              const struct pel_rect *doubt,
                              const struct pel_depth *depth)
{
    struct pel_frame again = *frame;
    struct pel_surface part = *surface;
    pel_scene_draw(frame, surface);
    part.clip = pel_rect_intersect(&part.clip, doubt);
    again.order = NULL;
    again.triangles = frame->scene->mesh->triangles;
    if (!pel_rect_empty(&part.clip))
        pel_scene_draw_depth(&again, &part, depth);
}
