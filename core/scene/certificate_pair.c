#include "certificate_pair.h"

#include <string.h>

void pel_certificate_corners(const struct pel_frame *frame, uint32_t triangle,
                             struct pel_certificate_corners *corners)
{
    struct pel_certificate_corners *c = corners;
    uint32_t vertex[3];
    pel_mesh_corners(frame->scene->mesh, triangle, vertex);
    *c = (struct pel_certificate_corners){.in_front = true};
    for (int i = 0; i < 3; i++) {
        const struct pel_projected *v = &frame->vertex[vertex[i]].at;
        c->at[i] = (struct pel_point){v->x, v->y};
        c->z[i] = v->z;
        c->cut |= v->x == PEL_NOT_ON_SCREEN;
        c->in_front &= v->z >= frame->projector.near_coarse;
    }
}

void pel_doubt_add(struct pel_doubt *doubt, const struct pel_rect *box,
                   uint32_t pixels)
{
    struct pel_doubt *d = doubt;
    struct pel_rect *b = &d->bounds;
    const uint32_t room = UINT32_MAX - d->pixels;
    d->pixels += pixels < room ? pixels : room;
    if (pel_rect_empty(b))
        *b = *box;
    b->x0 = pel_min(b->x0, box->x0);
    b->y0 = pel_min(b->y0, box->y0);
    b->x1 = pel_max(b->x1, box->x1);
    b->y1 = pel_max(b->y1, box->y1);
}

/* Twice the area of three points, which are legal. */
static int64_t turn(struct pel_point p, struct pel_point q, struct pel_point r)
{
    return pel_minor(q.x - p.x, r.y - p.y, r.x - p.x, q.y - p.y);
}

/* True when an edge of a has a on one side, and all of b on the other or on the
 * edge: by the rule of the raster they share no pixel then, not even one whose
 * centre is on the edge. */
static bool separates(const struct pel_point a[3], const struct pel_point b[3])
{
    const bool back = turn(a[0], a[1], a[2]) < 0;
    for (int i = 0; i < 3; i++) {
        bool all = true;
        for (int k = 0; k < 3 && all; k++) {
            const int64_t side = turn(a[i], a[i == 2 ? 0 : i + 1], b[k]);
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
    struct pel_doubt doubt;
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
        if (part.x0 < part.x1)
            pel_doubt_add(&o->doubt, &part, pel_doubt_area(&part));
    }
}

/* The plane of depths, as depth buffers have it. */
static void set_plane(const struct pel_frame *frame,
                      const struct pel_certificate_corners *c,
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
static void walk(const struct pel_certificate_corners c[2], struct overlap *o,
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

/* What the second one has to be nearer at a pixel. Planes are off by less than
 * 2^-6, so with twice as much it is nearer in truth, and where numbers are
 * equal the buffer shows the first of the mesh; a number is 1/4. A thin one is
 * never proven to be nearer or farther. */
static int64_t least_of(const uint32_t triangle[2], bool thin)
{
    if (thin)
        return INT64_C(1) << 62;
    return triangle[1] < triangle[0] ? 1 << 19 : 1 << 22;
}

struct pel_doubt pel_certificate_pair(const struct pel_frame *frame,
                                      const uint32_t triangle[2], bool thin,
                                      const struct pel_rect *common)
{
    struct overlap o;
    struct pel_certificate_corners c[2];
    for (int i = 0; i < 2; i++)
        pel_certificate_corners(frame, triangle[i], &c[i]);
    o.doubt = (struct pel_doubt){0};
    if (c[0].cut || c[1].cut) {
        pel_doubt_add(&o.doubt, common, pel_doubt_area(common));
        return o.doubt;
    }
    if (separates(c[0].at, c[1].at) || separates(c[1].at, c[0].at))
        return o.doubt;
    o.least = least_of(triangle, thin);
    for (int i = 0; i < 2; i++)
        set_plane(frame, &c[i], &o.plane[i]);
    walk(c, &o, *common);
    return o.doubt;
}
